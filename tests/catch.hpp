// The one place that knows Catch2 2 from Catch2 3.
// Debian 12 ships 2.13, and only that has been tried; newer systems ship 3.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>
using Catch::Approx;

#else

// tests/main.cpp reports a crash itself, from outside the process: a handler inside it would run on a
// broken heap.
#ifdef COURSE_TEST_MAIN
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_NO_POSIX_SIGNALS
#endif
#include <catch2/catch.hpp>

#endif

#ifdef COURSE_TEST_MAIN
namespace rt::test {

#ifdef CATCH_CONFIG_RUNNER
using Listener = Catch::TestEventListenerBase;
namespace options = Catch::clara;
/// All the tags of a test case, such as "02.1".
inline std::vector<std::string> tags_of(const Catch::TestCaseInfo& info) { return info.tags; }
inline const Catch::TestCaseInfo& info_of(const Catch::TestCaseStats& stats) { return stats.testInfo; }
/// Whether Catch asks what to do with the result of an assertion; its answer is not used.
using AssertionEnded = bool;
#else
using Listener = Catch::EventListenerBase;
namespace options = Catch::Clara;
inline std::vector<std::string> tags_of(const Catch::TestCaseInfo& info) {
    std::vector<std::string> tags;
    for (const Catch::Tag& tag : info.tags) tags.emplace_back(tag.original.data(), tag.original.size());
    return tags;
}
inline const Catch::TestCaseInfo& info_of(const Catch::TestCaseStats& stats) { return *stats.testInfo; }
using AssertionEnded = void;
#endif

}  // namespace rt::test
#endif
