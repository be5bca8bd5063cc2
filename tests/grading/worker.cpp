// The program that holds a student's chapter and answers calls. It is started with the channel's file as
// descriptor 3.
#include "tests/grading/worker.hpp"

#include "common/math/input_error.hpp"
#include "common/math/todo.hpp"

#include <cstdlib>
#include <exception>
#include <string_view>

namespace rt::grading {

namespace {

constexpr int channel_file = 3;

// Started by main, so that constructors of the student's cannot take it over before.
Channel* channel = nullptr;
std::uint32_t callbacks = 0;  // how many the call that is being read has so far

Message next_message() {
    std::optional<Message> message = channel->receive([] { return true; });
    return std::move(*message);
}

/// What comes of a call: its result, or what it throws.
struct Outcome {
    Kind kind = Kind::Return;
    std::vector<std::byte> bytes;
};

Outcome in_words(Kind kind, std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    return {kind, {bytes.begin(), bytes.end()}};
}

RayCounts minus(const RayCounts& a, const RayCounts& b) {
    return {a.camera - b.camera, a.shadow - b.shadow, a.reflection - b.reflection,
            a.refraction - b.refraction, a.random_numbers - b.random_numbers};
}

// What the judge was told of so far.
RayCounts rays_told;
SearchCounts searches_told;

/// Sends it, or in words that it is too long.
void send(const Outcome& outcome) {
    try {
        channel->send(outcome.kind, 0, outcome.bytes);
    } catch (const std::exception& error) {
        const Outcome why = in_words(Kind::Threw, error.what());
        channel->send(why.kind, 0, why.bytes);
    }
}

Outcome outcome_of(std::uint32_t number, std::span<const std::byte> arguments) {
    try {
        if ((number & forget) != 0) known_objects().clear();
        Reader in(arguments);
        Writer out;
        callbacks = 0;
        answers[number & ~forget](in, out);
        const std::span<const std::byte> bytes = out.bytes();
        return {Kind::Return, {bytes.begin(), bytes.end()}};
    } catch (const NotImplemented& error) {
        return in_words(Kind::Missing, error.step);
    } catch (const InputError& error) {
        return in_words(Kind::Refused, error.what());
    } catch (const std::exception& error) {
        return in_words(Kind::Threw, error.what());
    } catch (...) {
        return in_words(Kind::Threw, "an exception that is no std::exception");
    }
}

void answer_all(const Message& calls) {
    Reader in(calls.bytes);
    Writer out;
    for (std::uint32_t i = 0; i < calls.number; ++i) {
        const auto number = in.read<std::uint32_t>();
        const Outcome outcome = outcome_of(number, in.take(in.read<std::uint64_t>()));
        out(static_cast<std::uint32_t>(outcome.kind));
        out(static_cast<std::uint64_t>(outcome.bytes.size()));
        out.raw(outcome.bytes.data(), outcome.bytes.size());
    }
    const std::span<const std::byte> bytes = out.bytes();
    send({Kind::Answers, {bytes.begin(), bytes.end()}});
}

void answer(const Message& message) {
    if (message.kind == Kind::Calls) return answer_all(message);
    const std::uint32_t callbacks_outside = callbacks;
    const Outcome outcome = outcome_of(message.number, message.bytes);
    send(outcome);
    callbacks = callbacks_outside;
}

}  // namespace

std::vector<std::byte> call_back(std::uint32_t number, const Writer& arguments) {
    channel->send(Kind::Callback, number, arguments.bytes());
    for (;;) {
        Message message = next_message();
        if (message.kind == Kind::Result) return std::move(message.bytes);
        answer(message);  // what the judge's function calls in its turn
    }
}

std::uint32_t next_callback() { return callbacks++; }

std::map<std::uint32_t, std::shared_ptr<const void>>& known_objects() {
    static std::map<std::uint32_t, std::shared_ptr<const void>> objects;
    return objects;
}

void write_counts(Writer& out, double seconds) {
    out(seconds);
    out(minus(ray_counts(), rays_told));
    out(SearchCounts{search_counts().cells - searches_told.cells,
                     search_counts().shapes - searches_told.shapes});
    rays_told = ray_counts();
    searches_told = search_counts();
}

}  // namespace rt::grading

int main() {
    using namespace rt::grading;
    Channel own(channel_file, Side::Worker);
    channel = &own;
    channel->send(Kind::Ready, 0, {});
    for (;;) answer(next_message());
}
