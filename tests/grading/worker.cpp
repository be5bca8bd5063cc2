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

void send_text(Kind kind, std::string_view text) {
    channel->send(kind, 0, std::as_bytes(std::span(text.data(), text.size())));
}

RayCounts minus(const RayCounts& a, const RayCounts& b) {
    return {a.camera - b.camera, a.shadow - b.shadow, a.reflection - b.reflection,
            a.refraction - b.refraction, a.random_numbers - b.random_numbers};
}

// What the judge was told of so far.
RayCounts rays_told;
SearchCounts searches_told;

void answer(const Message& call) {
    const std::uint32_t callbacks_outside = callbacks;
    try {
        if ((call.number & forget) != 0) known_objects().clear();
        Reader in(call.bytes);
        Writer out;
        callbacks = 0;
        answers[call.number & ~forget](in, out);
        channel->send(Kind::Return, 0, out.bytes());
    } catch (const NotImplemented& error) {
        send_text(Kind::Missing, error.step);
    } catch (const InputError& error) {
        send_text(Kind::Refused, error.what());
    } catch (const std::exception& error) {
        send_text(Kind::Threw, error.what());
    } catch (...) {
        send_text(Kind::Threw, "an exception that is no std::exception");
    }
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
