// Jobs whose calls of the functions under test may be under way at the same time.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace rt::test {

/// Does what `together` says in another way; empty where functions under test are called directly. Only the
/// autograder's judges, whose calls are answered by another process, have one (tests/grading/together.cpp).
inline void (*together_elsewhere)(std::size_t count, const std::function<void(std::size_t)>& job) = nullptr;

/// Does job(0), job(1) and so on, `count` jobs. Each begins after the one before it has begun, but may wait
/// in a call of a function under test until others have come to theirs: so no job uses what another has
/// found, asserts, has an INFO or starts a thread. What a job throws comes out, of several that throw the
/// first's.
template <class Job>
void together(std::size_t count, Job job) {
    if (together_elsewhere) return together_elsewhere(count, job);
    for (std::size_t i = 0; i < count; ++i) job(i);
}

/// What `method` answers to each of the questions, in their order; asked together.
template <class Question, class Method>
auto answers(const std::vector<Question>& questions, Method method) {
    std::vector<std::decay_t<decltype(method(questions.front()))>> all(questions.size());
    together(questions.size(), [&](std::size_t i) { all[i] = method(questions[i]); });
    return all;
}

}  // namespace rt::test
