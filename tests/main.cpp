// The main program of every test program: Catch2, and a report that a crash cannot take away.
// Beside Catch2's own options: --quick (fewer random cases), --seed N (other random cases), --report FILE
// (see below), --watched (what is printed is marked with the test that was running, and a report says where a
// crash was), and those of the program alone (tests/own_options.hpp), which may have other uses, too.
#define COURSE_TEST_MAIN
#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/math/todo.hpp"
#include "tests/back_trace.hpp"
#include "tests/catch.hpp"
#include "tests/condition.hpp"
#include "tests/own_options.hpp"
#include "tests/support.hpp"

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

namespace rt::test {

// Set by --quick; read by `cases`.
extern bool quick;

namespace {

std::string report_file;
bool watched = false;
int passed = 0, failed = 0, waiting = 0;
bool finished = false;
bool reported = true;  // as long as every line of the report could be written

// The step whose function a test called although it is not started; empty while there was none.
std::string missing_step;

std::string json(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : printable(text, Keep::Controls)) {
        if (c == '"' || c == '\\') {
            quoted += {'\\', c};
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            quoted += escape;
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

/// The file as a person at the repository's root names it.
std::string relative_to_root(std::string file) {
    const std::string root = repository() + "/";
    return file.starts_with(root) ? file.substr(root.size()) : file;
}

/// What a failed assertion says: what was asked, as INFO has it, what came out and what was expected.
std::string told_by(const Catch::AssertionStats& stats) {
    const Catch::AssertionResult& result = stats.assertionResult;
    std::ostringstream text;
    for (const Catch::MessageInfo& info : stats.infoMessages)
        if (info.type == Catch::ResultWas::Info) text << info.message << '\n';
    text << "came out: ";
    if (result.getResultType() == Catch::ResultWas::ThrewException)
        text << "the exception " << result.getMessage();
    else if (result.getResultType() == Catch::ResultWas::DidntThrowException)
        text << "no exception";
    else if (result.hasExpandedExpression())
        text << in_words(result.getExpandedExpression(), result.getExpression());
    else
        text << result.getMessage();
    return text.str();
}

/// Where in the tests it stands, and how.
std::string place_of(const Catch::AssertionStats& stats) {
    const Catch::AssertionResult& result = stats.assertionResult;
    const Catch::SourceLineInfo place = result.getSourceInfo();
    std::ostringstream text;
    text << relative_to_root(place.file) << ':' << place.line;
    // A condition that says itself what is wrong has said it.
    if (result.hasExpression() && result.getExpression().find("or_say(") == std::string::npos)
        text << ": " << result.getExpression();
    return text.str();
}

/// Begins what is printed during a test with a line of its name; a sign in front that nobody prints tells it
/// from other lines (common/workbook/printed.hpp). The empty name ends the last test's.
void mark_output(const std::string& name) {
    if (watched) std::cout << '\x1e' << printable(name) << std::endl;
}

/// Writes one line of JSON as a test case starts and one as it ends, so that whoever started the program
/// knows in which test it died:
///   {"started":"name","steps":["02.1"]}
///   {"ended":"name","steps":["02.1"],"state":"todo|failed|passed","message":"…","missing":"02.1","stopped":"…"}
/// and {"finished":true} after the last.
struct Report : Listener {
    using Listener::Listener;

    std::ofstream out;
    std::string failure, place;  // the first of the test case
    int alike = 0;               // further ones at the same place

    void testRunStarting(const Catch::TestRunInfo&) override {
        if (!report_file.empty()) out.open(report_file, std::ios::trunc);
    }

    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        failure.clear();
        alike = 0;
        missing_step.clear();
        stopped.clear();
        mark_output(info.name);
        out << "{\"started\":" << json(info.name) << ",\"steps\":" << steps(info) << "}" << std::endl;
    }

    AssertionEnded assertionEnded(const Catch::AssertionStats& stats) override {
        if (stats.assertionResult.isOk()) return AssertionEnded();
        if (failure.empty()) {
            failure = told_by(stats);
            place = place_of(stats);
        } else if (place_of(stats) == place) {
            ++alike;
        }
        return AssertionEnded();
    }

    /// The first failure, and how many cases are like it.
    std::string message() const {
        if (alike == 0) return failure + "\n" + place;
        return failure + "\nit fails in " + counted(alike, "more case") + " of this test\n" + place;
    }

    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        const bool todo = !missing_step.empty();
        const bool ok = !todo && stats.totals.assertions.allOk();
        ++(todo ? waiting : ok ? passed : failed);
        const Catch::TestCaseInfo& info = info_of(stats);
        out << "{\"ended\":" << json(info.name) << ",\"steps\":" << steps(info) << ",\"state\":"
            << json(todo ? "todo"
                    : ok ? "passed"
                         : "failed")
            << ",\"message\":" << json(todo || ok ? "" : message()) << ",\"missing\":" << json(missing_step)
            << ",\"stopped\":" << json(stopped) << "}" << std::endl;
    }

    void testRunEnded(const Catch::TestRunStats&) override {
        finished = true;
        mark_output("");
        out << "{\"finished\":true}" << std::endl;
        reported = report_file.empty() || out.good();
    }

    static std::string steps(const Catch::TestCaseInfo& info) {
        std::string list;
        for (const std::string& tag : tags_of(info)) list += (list.empty() ? "" : ",") + json(tag);
        return "[" + list + "]";
    }
};

CATCH_REGISTER_LISTENER(Report)

CATCH_TRANSLATE_EXCEPTION(const NotImplemented& error) {
    if (missing_step.empty()) missing_step = error.step;
    return error.what();
}

}  // namespace

}  // namespace rt::test

/// Exit status: 0 if every test passed, 1 if not, 2 for a wrong command line or where nothing can be written.
/// The last line on standard output is `N passed, N failed`, and `, N skipped` where functions that tests
/// need are not started.
int main(int argc, char** argv) {
    using namespace rt::test;
    // Whoever is started in the background, or by nohup, ignores some of these; tests send them to children.
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
    for (const OtherUse* other : other_uses())
        if (argc > 1 && other->name == argv[1]) return other->use({argv + 2, argv + argc});
    Catch::Session session;
    session.cli(
        session.cli() | options::Opt(quick)["--quick"]("fewer random cases, as in a student's check") |
        options::Opt(case_seed, "number")["--seed"]("other random cases than those that everybody knows") |
        options::Opt(report_file, "file")["--report"]("write a line of JSON a test case") |
        options::Opt(watched)["--watched"]("mark what is printed, and report where a crash was"));
    for (OwnOption* own : own_options())
        session.cli(session.cli() | options::Opt(own->values, own->value_name)[own->name](own->help));
    if (session.applyCommandLine(argc, argv) != 0) return 2;
    if (watched) {
        std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // what is printed before a crash is not lost
        report_where_it_stops(report_file);
    }
    session.run();
    if (!finished) return 0;
    std::cout << passed << " passed, " << failed << " failed";
    if (waiting > 0) std::cout << ", " << waiting << " skipped";
    std::cout << std::endl;
    if (!reported || !std::cout) {
        std::fprintf(stderr, "%s: cannot be written\n", reported ? "standard output" : report_file.c_str());
        return 2;
    }
    return failed + waiting > 0 ? 1 : 0;
}
