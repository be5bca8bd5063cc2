// Child programs: output, ends of all kinds, limits.
#include "common/terminal/process.hpp"
#include "tests/catch.hpp"

#include <sched.h>

#include <csignal>

using namespace rt;

TEST_CASE("a child's output and status come back") {
    std::vector<std::string> lines;
    ProcessOptions options;
    options.on_line = [&](std::string_view line) { lines.emplace_back(line); };
    const auto result = run_process({"sh", "-c", "echo one; echo two >&2; printf three; exit 3"}, options);
    CHECK(result.exit_code == 3);
    CHECK(result.signal == 0);
    CHECK_FALSE(succeeded(result));
    CHECK(result.output == "one\ntwo\nthree");
    CHECK(lines == std::vector<std::string>{"one", "two", "three"});
}

TEST_CASE("a program that does not exist is status 127") {
    CHECK(run_process({"no-such-program-here"}).exit_code == 127);
}

TEST_CASE("a crash is told by its signal") {
    const auto result = run_process({"sh", "-c", "kill -SEGV $$"});
    CHECK(result.signal == SIGSEGV);
    CHECK(signal_name(result.signal) == "segmentation fault");
    CHECK_FALSE(succeeded(result));
}

TEST_CASE("a child that hangs is ended at its limit") {
    ProcessOptions options;
    options.time_limit = 0.2;
    for (const char* hang : {"sleep 60", "while :; do :; done", "exec >&- 2>&-; sleep 60", "yes"}) {
        INFO("command := " << hang);
        const auto result = run_process({"sh", "-c", hang}, options);
        CHECK(result.timed_out);
        CHECK(result.seconds < 10);
        CHECK(result.output.size() <= (1 << 20));
    }
}

TEST_CASE("before it is killed a child may say where it is") {
    ProcessOptions options;
    options.time_limit = 0.2;
    options.last_words = SIGQUIT;
    for (const char* hang : {"while :; do :; done", "sleep 60"}) {
        const auto result =
            run_process({"bash", "-c", std::string("trap 'echo here; exit 3' QUIT; ") + hang}, options);
        CHECK(result.timed_out);
        CHECK(result.seconds < 10);
        if (std::string_view(hang) != "sleep 60") CHECK(result.output == "here\n");
    }
    // One that has nothing to say ends at once, and one that does not listen is killed.
    CHECK(run_process({"sleep", "60"}, options).signal == SIGQUIT);
    CHECK(run_process({"sh", "-c", "trap '' QUIT; while :; do :; done"}, options).signal == SIGKILL);
}

TEST_CASE("who waits for a child can show that it waits, though it says nothing") {
    int calls = 0;
    ProcessOptions options;
    options.while_waiting = [&] { ++calls; };
    run_process({"sleep", "0.2"}, options);
    CHECK(calls >= 2);
}

TEST_CASE("what others take of the time is not the child's") {
    cpu_set_t all, one;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    CPU_ZERO(&one);
    for (int core = 0; CPU_COUNT(&one) == 0; ++core)
        if (CPU_ISSET(core, &all)) CPU_SET(core, &one);
    REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
    ProcessOptions options;
    options.time_limit = 0.2;
    // Half of the limit is work; with seven others on the core it takes about eight times as long.
    const std::string loop = "while :; do :; done";
    const std::string work = "while read -r ran rest </proc/$$/schedstat; [ $ran -lt 100000000 ]; do :; done";
    const std::string others = "for other in 1 2 3 4 5 6 7; do timeout 3 sh -c '" + loop + "' & done; ";
    const auto worked = run_process({"sh", "-c", others + work + "; echo done"}, options);
    const auto looped = run_process({"sh", "-c", loop}, options);
    CHECK(sched_setaffinity(0, sizeof all, &all) == 0);
    CHECK(worked.output == "done\n");
    CHECK_FALSE(worked.timed_out);
    CHECK(looped.timed_out);
}

TEST_CASE("a child that leaves another behind does not hold us up") {
    const auto result = run_process({"sh", "-c", "sleep 5 & echo done"});
    CHECK(result.output == "done\n");
    CHECK(result.seconds < 4);
}

TEST_CASE("variables reach the child, and only the child") {
    ProcessOptions options;
    options.environment = {{"COURSE_TEST_VARIABLE", "a b"}};
    CHECK(run_process({"sh", "-c", "printf '%s' \"$COURSE_TEST_VARIABLE\""}, options).output == "a b");
    CHECK(run_process({"sh", "-c", "printf '%s' \"$COURSE_TEST_VARIABLE\""}).output.empty());
    // In place of one that is there, not beside it; what has a longer name is another.
    options.environment = {{"PATH", "/bin:/usr/bin:/x"}, {"PAT", "short"}};
    CHECK(run_process({"sh", "-c", "env | grep '^PAT' | sort"}, options).output ==
          "PAT=short\nPATH=/bin:/usr/bin:/x\n");
}
