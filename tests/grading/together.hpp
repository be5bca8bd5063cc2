// Jobs that run together (tests/together.hpp): their calls go to the worker in one message.
#pragma once

#include "tests/grading/channel.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::grading {

/// A call that waits for others, and the answer to it.
struct Call {
    std::uint32_t number = 0;
    std::span<const std::byte> arguments;  ///< which stay where they are until it is answered
    std::optional<Message> answer;         ///< its kind and bytes
};

/// Whether the caller is a job that runs together with others, and not one by one.
bool is_together();

/// Stops this job until its call was answered together with the others'. False where they have no answers,
/// because the worker died of one of them, took too long or said nonsense: from then on the jobs run one by
/// one.
bool answered_together(Call& call);

/// Has the calls answered that wait, so that another can be made now; whether there were any.
bool answer_waiting();

/// Has the worker answer calls in one message; whether it did (judge.cpp).
bool answer(std::span<Call* const> calls);

}  // namespace rt::grading
