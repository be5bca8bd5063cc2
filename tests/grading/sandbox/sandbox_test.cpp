// Boxes under attack: every attack of tests/grading/sandbox/attacks, at every level that this machine can do,
// with the verdict that it must get, and a machine that is afterwards what it was.
#include "common/sandbox/sandbox.hpp"
#include "common/image/descriptor.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"
#include "tests/grading/sandbox/boxes.hpp"
#include "tests/support.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <thread>
#include <utility>

using namespace rt;
using namespace rt::test;
namespace fs = std::filesystem;

namespace {

/// Each way in its turn; the machine must be the same after it.
template <class Check>
void in_every_way(Check check) {
    fresh_directory("");
    REQUIRE_FALSE(ways().empty());
    for (const Way& way : ways()) {
        INFO("level := " << way.name);
        const Lock alone(boxes_lock(), "trying boxes");
        const std::vector<std::string> before = machine();
        check(way);
        fresh_directory("");
        // What looked after the box of a killed grader tidies up by itself, soon after.
        for (int i = 0; i < 1000 && machine() != before; ++i) ::usleep(10'000);
        CHECK(machine() == before);
    }
}

bool ends_by(const Ending& verdict, int signal) {
    return verdict.end == End::Signal && verdict.number == signal;
}

int number_in(const Ending& verdict) { return std::atoi(verdict.output.c_str()); }

/// Two sockets that are connected.
struct Pair {
    Descriptor here{-1}, there{-1};
    Pair() {
        int ends[2];
        REQUIRE(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0);
        here.number = ends[0];
        there.number = ends[1];
    }
    /// Whether a worker at the other end still answers.
    bool answers() const {
        char letter = 'a';
        return write(here.number, &letter, 1) == 1 && read(here.number, &letter, 1) == 1 && letter == 'A';
    }
};

/// A worker in a box, at the other end of a pair.
struct Worker {
    Pair pair;
    Boxed boxed;

    explicit Worker(const Way& way)
        : boxed(start(attack_box(way), attack(attack_box(way), "worker"), std::span(&pair.there.number, 1))) {
        close(std::exchange(pair.there.number, -1));
    }
};

bool soon(const std::function<bool()>& holds) {
    for (const Stopwatch patience; patience.seconds() < 10;) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

}  // namespace

TEST_CASE("a level of isolation is possible or says why it is not", "[box]") {
    for (const Level& level : probe()) {
        CHECK(isolation_named(name_of(level.isolation)) == level.isolation);
        CHECK(level.possible == level.reason.empty());
        if (level.possible) {
            CHECK_NOTHROW(require_possible(level.isolation));
        } else {
            std::fprintf(stderr, "skipped: level %s: %s\n", std::string(name_of(level.isolation)).c_str(),
                         level.reason.c_str());
            CHECK(error_of([&] { require_possible(level.isolation); }).find(level.reason) !=
                  std::string::npos);
        }
    }
    CHECK(error_of([] { isolation_named("docker"); }) ==
          "there is no level of isolation 'docker'; they are bwrap, user and none");
    const Way user{"user for a user", Isolation::User, false};
    CHECK(error_of([&] { run_attack(user, "worker"); }) == "only root can give a program a uid of its own");
}

TEST_CASE("what cannot be started is refused with one line", "[box]") {
    in_every_way([](const Way& way) {
        const auto refusal = [&](const Sandbox& box, const std::vector<std::string>& command) {
            return error_of([&] { run(way, box, command); });
        };
        Sandbox box = attack_box(way);
        const std::string missing = refusal(box, {"/attacks/none"});
        CHECK(missing.find("/attacks/none: No such file or directory") != std::string::npos);
        CHECK(std::ranges::count(missing, '\n') == 0);
        box.mounts.push_back({"/nowhere", "/nowhere"});
        CHECK(refusal(box, attack(box, "worker")).starts_with("/nowhere"));
        const std::string closed = fresh_directory("closed");
        fs::permissions(closed, fs::perms(0700));
        if (geteuid() != 0) return;
        box.mounts.back() = {closed, "/closed"};
        CHECK(refusal(box, attack(box, "worker")) ==
              closed + " cannot be read by the box: Permission denied");
    });
}

TEST_CASE("a program in a box answers on its descriptor and tells its status", "[box]") {
    in_every_way([](const Way& way) {
        const Ending verdict = as(way, [&] {
            Worker worker(way);
            if (!worker.pair.answers() || worker.boxed.ended()) throw std::runtime_error("no answer");
            if (write(worker.pair.here.number, ".", 1) != 1) throw std::runtime_error("no more");
            return worker.boxed.wait();
        });
        CHECK(verdict.end == End::Exited);
        CHECK(verdict.number == 7);
        CHECK(verdict.errors == "to the errors");
        CHECK(verdict.peak_memory > 100'000);
        CHECK(verdict.cpu_seconds > 0);
        CHECK(verdict.wall_seconds > 0);
    });
}

TEST_CASE("a box outlives the thread that started it, and ends when it is told to", "[box]") {
    in_every_way([](const Way& way) {
        const Ending verdict = as(way, [&] {
            std::unique_ptr<Worker> worker;
            std::thread([&] { worker = std::make_unique<Worker>(way); }).join();
            if (!worker->pair.answers()) throw std::runtime_error("no answer");
            worker->boxed.stop();
            return worker->boxed.wait();
        });
        CHECK(verdict.end == End::Stopped);
    });
}

TEST_CASE("boxes have nothing of each other's limits, and leave no zombie", "[box]") {
    in_every_way([](const Way& way) {
        const Ending all = as(way, [&] {
            std::vector<Boxed> boxes;
            const Sandbox box = attack_box(way);
            for (int i = 0; i < 4; ++i) boxes.push_back(start(box, attack(box, "forks")));
            Ending sum;
            for (Boxed& boxed : boxes) sum.number += number_in(boxed.wait());
            return sum;
        });
        if (way.root || way.apart()) {
            CHECK(all.number <= 4 * 12);
            CHECK(all.number >= 4 * 9);
        }
    });
}

TEST_CASE("a box dies with its grader", "[box]") {
    in_every_way([](const Way& way) {
        const pid_t grader = fork();
        if (grader == 0) {
            if (!become(way)) _exit(1);
            const Sandbox box = attack_box(way);
            const Boxed boxed = start(box, attack(box, "sleep"));
            for (;;) pause();
        }
        CHECK(soon([] { return !attacks_running().empty(); }));
        kill(grader, SIGKILL);
        waitpid(grader, nullptr, 0);
        CHECK(soon([] { return attacks_running().empty(); }));
    });
}

TEST_CASE("processes, time, memory and output have limits", "[box]") {
    in_every_way([](const Way& way) {
        if (way.root || way.apart()) {
            const int forks = number_in(run_attack(way, "forks"));
            CHECK(forks <= 12);
            CHECK(forks >= 9);
        }
        const Ending hog = run_attack(way, "one_hog");
        CHECK(hog.end == End::Exited);
        CHECK(number_in(hog) <= 64);
        CHECK(number_in(hog) > 32);
        CHECK(run_attack(way, "many_hogs").end == End::Memory);
        CHECK(ends_by(run_attack(way, "large_file"), SIGXFSZ));
        const Ending output = run_attack(way, "much_output");
        CHECK(output.end == End::Output);
        CHECK(output.output.size() == small_limits().output);
        CHECK(ends_by(run_attack(way, "deep_stack"), SIGSEGV));
        CHECK(in_words(output, small_limits()) == "wrote more than 0.0625 MiB of output");

        Sandbox box = attack_box(way);
        box.limits.cpu_seconds = box.limits.wall_seconds = 0.3;
        CHECK(run(way, box, attack(box, "sleep")).end == End::WallTime);
        box.limits.wall_seconds = 20;
        const Ending spin = run(way, box, attack(box, "spin"));
        CHECK(spin.end == End::CpuTime);
        CHECK(spin.cpu_seconds < 1.5);
        CHECK(in_words(spin, box.limits) == "took more than 0.3 s of processor time");
    });
}

TEST_CASE("files have limits in number and sum", "[box]") {
    in_every_way([](const Way& way) {
        const int files = number_in(run_attack(way, "many_files")),
                  size = number_in(run_attack(way, "full_disk"));
        CHECK(files >= 90);
        CHECK(size >= 7);
        if (way.counts_files()) {
            CHECK(files <= 100);
            CHECK(size <= 8);
        }
    });
}

TEST_CASE("nothing outside of a box is written or read", "[box]") {
    in_every_way([](const Way& way) {
        const std::string open = fresh_directory("open"), key = fresh_directory("key");
        fs::permissions(open, fs::perms(0777));
        write_file(open + "/anybody", "x");
        write_file(key + "/secret", "x");
        fs::permissions(key + "/secret", fs::perms(0600));
        fs::permissions(key, fs::perms(0700));
        const std::vector<std::string> before = machine();

        const Ending written = run_attack(way, "write_outside", {open, key});
        const Ending read = run_attack(way, "read_outside", {open + "/anybody", key + "/secret"});
        CHECK(machine() == before);
        if (way.apart()) {
            CHECK(written.output == "");
            CHECK(read.output == "");
        } else {  // the attacks are real ones
            CHECK(written.output.starts_with(open + "/sandbox_attack\n"));
            CHECK(read.output.starts_with(open + "/anybody\n/etc/passwd\n"));
        }
        CHECK(read.output.find("secret") == std::string::npos);
        CHECK(read.output.find("shadow") == std::string::npos);
    });
}

TEST_CASE("a box sees no other process, no descriptor and no environment", "[box]") {
    const Descriptor inheritable(dup(STDIN_FILENO));
    setenv("COURSE_SECRET", "rosebud", 1);
    in_every_way([](const Way& way) {
        // In two parts, because it can read its own command line.
        const std::string place = this_project().build.string();
        const Ending spy = run_attack(way, "spy", {place.substr(0, 3), place.substr(3)});
        CHECK((spy.output == "0\n") == way.apart());

        const Ending given = run_attack(way, "descriptors");
        CHECK(given.output.starts_with("0 1 2 PATH=/usr/bin HOME=/tmp"));
        CHECK(given.output.find("rosebud") == std::string::npos);
        const Ending kept = as(way, [&] {
            const Pair pair;
            const Sandbox box = attack_box(way);
            const int both[] = {pair.there.number, pair.here.number};
            return run_in(box, attack(box, "descriptors"), both);
        });
        CHECK(kept.output.starts_with("0 1 2 3 4 PATH"));
    });
    unsetenv("COURSE_SECRET");
}

TEST_CASE("a box reaches no server", "[box]") {
    const Descriptor tcp(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    REQUIRE(bind(tcp.number, reinterpret_cast<sockaddr*>(&address), size) == 0);
    REQUIRE(listen(tcp.number, 16) == 0);
    REQUIRE(getsockname(tcp.number, reinterpret_cast<sockaddr*>(&address), &size) == 0);

    const Descriptor local(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const std::string name = "box_test_" + std::to_string(getpid());
    sockaddr_un abstract{};
    abstract.sun_family = AF_UNIX;
    std::memcpy(abstract.sun_path + 1, name.data(), name.size());
    size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    REQUIRE(bind(local.number, reinterpret_cast<sockaddr*>(&abstract), size) == 0);
    REQUIRE(listen(local.number, 16) == 0);

    in_every_way([&](const Way& way) {
        const Ending verdict = run_attack(way, "network", {std::to_string(ntohs(address.sin_port)), name});
        CHECK(verdict.output == (way.apart() ? "" : "TCP\nabstract socket\n"));
    });
}

TEST_CASE("a box leaves no process behind and harms none", "[box]") {
    in_every_way([](const Way& way) {
        CHECK(run_attack(way, "daemon").end == End::Exited);
        CHECK(attacks_running().empty());
        if (!way.root && !way.apart()) return;  // it would end all that this user has
        const Ending attacked = as(way, [&] {
            Worker neighbour(way);
            if (!neighbour.pair.answers()) throw std::runtime_error("no answer");
            const Sandbox box = attack_box(way);
            const Ending verdict = run_in(
                box, attack(box, "attack_processes", {std::to_string(getpid()), std::to_string(getppid())}));
            if (!neighbour.pair.answers()) throw std::runtime_error("the neighbour was ended");
            return verdict;
        });
        CHECK(attacked.output == "");
    });
}

TEST_CASE("a box has no privilege and gets none", "[box]") {
    in_every_way([](const Way& way) {
        CHECK(ends_by(run_attack(way, "core"), SIGABRT));
        if (!way.apart()) return;
        CHECK(run_attack(way, "privileges").output == "");
        CHECK(run_attack(way, "system_calls").output == "");
        const Ending foreign = run_attack(way, "foreign_calls");
        CHECK(foreign.end == End::Signal);
        CHECK(foreign.output == "");
    });
}

TEST_CASE("only regular files come out of a box, whole", "[box]") {
    in_every_way([](const Way& way) {
        const std::string out = fresh_directory("out"), secret = fresh_directory("secret") + "/file";
        fs::permissions(out, fs::perms(0777));
        write_file(secret, "secret");
        Sandbox box = attack_box(way);
        for (const char* name : {"right", "link", "pipe", "directory", "hard", "absent", "root/etc/passwd",
                                 "../../etc/passwd", "/etc/passwd"})
            box.products.push_back({name, out + "/" + fs::path(name).filename().string()});
        const Ending verdict = run(way, box, attack(box, "products", {secret}));
        CHECK(verdict.products == std::vector<std::string>{"right"});
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(out))
            names.push_back(entry.path().filename().string());
        CHECK(names == std::vector<std::string>{"right"});
        CHECK(read_file(out + "/right") == "right");
        struct stat status {};
        REQUIRE(stat((out + "/right").c_str(), &status) == 0);
        CHECK((status.st_mode & 07777) == 0755);
    });
}
