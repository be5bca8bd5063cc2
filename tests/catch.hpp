// The one place that knows Catch2 2 from Catch2 3.
// Debian 12 ships 2.13, and only that has been tried; newer systems ship 3.
#pragma once

#include "tests/show.hpp"

// Numbers in the conditions that failed have all the digits that they need: Catch's own would write a bound
// of 1e-16 as 0.0, and two neighbours alike. It calls `stringify` by its full name, so an overload that is
// known before its header takes the place of its template.
namespace Catch::Detail {
inline std::string stringify(double number) { return rt::test::show(number); }
// And whole numbers are written without their hexadecimal digits.
inline std::string stringify(int number) { return rt::test::show(number); }
inline std::string stringify(unsigned number) { return rt::test::show(number); }
inline std::string stringify(long number) { return rt::test::show(number); }
inline std::string stringify(unsigned long number) { return rt::test::show(number); }
inline std::string stringify(long long number) { return rt::test::show(number); }
inline std::string stringify(unsigned long long number) { return rt::test::show(number); }
}  // namespace Catch::Detail

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

// Values of ours in conditions; what is a range for Catch stays one, of elements that are shown.
namespace Catch {
template <class T>
requires(rt::test::Shown<T> && !std::is_arithmetic_v<T> && !is_range<T>::value) struct StringMaker<T> {
    static std::string convert(const T& value) { return rt::test::show(value); }
};
}  // namespace Catch

// And in the messages beside them.
#undef INFO
#undef UNSCOPED_INFO
#undef FAIL
#undef FAIL_CHECK
#define INFO(message) INTERNAL_CATCH_INFO("INFO", (::rt::test::Text() << message).str())
#define UNSCOPED_INFO(message) \
    INTERNAL_CATCH_UNSCOPED_INFO("UNSCOPED_INFO", (::rt::test::Text() << message).str())
#define FAIL(message)                                                                               \
    INTERNAL_CATCH_MSG("FAIL", Catch::ResultWas::ExplicitFailure, Catch::ResultDisposition::Normal, \
                       (::rt::test::Text() << message).str())
#define FAIL_CHECK(message)                                             \
    INTERNAL_CATCH_MSG("FAIL_CHECK", Catch::ResultWas::ExplicitFailure, \
                       Catch::ResultDisposition::ContinueOnFailure, (::rt::test::Text() << message).str())

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
