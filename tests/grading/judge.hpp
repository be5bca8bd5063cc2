// The judge's end of a call: every function of a contract becomes one here (calls.cpp, which the build
// makes).
#pragma once

#include "chapters/09_grids/build.hpp"
#include "common/render/render.hpp"
#include "common/world/search.hpp"
#include "tests/grading/channel.hpp"
#include "tests/grading/wire.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::grading {

/// Thrown out of a call where the worker gave no answer; the text is for the student.
struct NoAnswer : std::runtime_error {
    NoAnswer(std::string verdict, const std::string& text)
        : std::runtime_error(text), how(std::move(verdict)) {}
    std::string how;  ///< "crashed", "timed out" or "too much memory"
};

/// Functions of the judge's that a worker may call while it answers: arguments in, result out.
using Callbacks = std::vector<std::function<void(Reader&, Writer&)>>;

/// Throws NoAnswer where there is no time left for calls, or this function did not return once. Asked before
/// arguments are written, because those are then known to the worker.
void refuse_hopeless(std::uint32_t number, std::string_view name);

/// Calls function `number` of the worker's table (answers.cpp), starting a worker where none runs. `name` is
/// for messages. Throws what the function threw: NotImplemented, InputError, std::runtime_error; and NoAnswer
/// where it crashed, ended the program, took too long or returned nonsense. What the callbacks throw comes
/// out of here, too. No answer means that the call is to be asked for once more, with its arguments written
/// anew: it was one of several (together.hpp) of which one ended the worker.
std::optional<std::vector<std::byte>> ask(std::uint32_t number, std::string_view name,
                                          std::span<const std::byte> arguments, const Callbacks& callbacks);

/// The number by which the worker knows an argument that it was sent before, and whether it is new to it.
struct Known {
    std::uint32_t number = 0;
    bool is_new = true;
};
Known known(std::type_index type, std::span<const std::byte> bytes);

// ------------------------------------------------------------------------------------------------ arguments

/// Whether an argument is passed by a number when it is passed again.
inline bool is_large(std::span<const std::byte> bytes) { return bytes.size() > 256; }

/// What is written of a call so far.
struct Outgoing {
    Writer out;
    Callbacks callbacks;
    const World* world = nullptr;  ///< the world among the arguments

    /// By value. Large ones are sent once.
    template <class T>
    void value(const T& argument) {
        if constexpr (std::is_same_v<T, World>) world = &argument;
        if constexpr (is_raw<T>()) {
            out(argument);
        } else {
            Writer own;
            own(argument);
            object<T>(own);
        }
    }

    template <class T>
    void list(std::span<const T> argument) {
        Writer own;
        own.list(argument);
        object<std::vector<T>>(own);
    }

    template <class T>
    void object(const Writer& own) {
        const std::span<const std::byte> bytes = own.bytes();
        const bool large = is_large(bytes);
        const Known object = large ? known(typeid(T), bytes) : Known{};
        out(large);
        if (large) out(object.number);
        out(object.is_new);
        if (!object.is_new) return;
        out(static_cast<std::uint64_t>(bytes.size()));
        out.raw(bytes.data(), bytes.size());
    }

    void callback(std::function<void(Reader&, Writer&)> function) {
        callbacks.push_back(std::move(function));
    }
};

template <class T>
void write_argument(Outgoing& call, const T& argument) {
    call.value(argument);
}
template <class T>
void write_argument(Outgoing& call, std::span<const T> argument) {
    call.list(argument);
}
/// One whose elements the function changes.
template <class T>
requires(!std::is_const_v<T>) void write_argument(Outgoing& call, std::span<T> changed) {
    call.out.list(std::span<const T>(changed));
}
inline void write_argument(Outgoing& call, const Ask& ask) {
    call.callback([&ask](Reader& in, Writer& out) {
        const auto shapes = in.read<std::vector<std::uint32_t>>();
        out(ask(shapes, in.read<Interval>()));
    });
}
/// Overlaps of shapes that the worker can ask itself cross as these shapes; what they are is said first, as
/// 1 + their place in the list of shapes, or 0 for a callback.
template <class... Shape>
void write_overlaps(Outgoing& call, const Overlaps& overlaps, List<Shape...>) {
    std::uint8_t place = 0;
    const auto write_if = [&](const auto* known) {
        ++place;
        if (!known) return false;
        call.value(place);
        call.list(known->shapes);
        call.list(known->bounds);
        return true;
    };
    if ((write_if(overlaps.target<ShapeOverlaps<Shape>>()) || ...)) return;
    call.value(std::uint8_t{0});
    call.callback([&overlaps](Reader& in, Writer& out) {
        const auto shape = in.read<std::uint32_t>();
        out(overlaps(shape, in.read<Bounds>()));
    });
}
inline void write_argument(Outgoing& call, const Overlaps& overlaps) {
    write_overlaps(call, overlaps, Shapes());
}
/// Not as other values with gaps between their bytes are: it is changed, and so never kept.
inline void write_argument(Outgoing& call, const Stream& stream) { call.out(stream); }
template <class T>
void write_argument(Outgoing& call, std::vector<T>& changed) {
    call.out(changed);
}
inline void write_argument(Outgoing& call, RayColor color) {
    call.callback([color, &call](Reader& in, Writer& out) {
        const auto ray = in.read<Ray>();
        auto stream = in.read<Stream>();
        const Vec3 seen = color(*call.world, ray, stream);
        out(seen);
        out(stream);
    });
}
/// Without the progress and a colour of the caller's, which no test asks a render for.
inline void write_argument(Outgoing& call, const RenderOptions& options) {
    if (options.progress || options.color) throw std::logic_error("renders are judged without callbacks");
    call.value(options.threads);
    call.value(options.seconds);
    call.value(options.error);
    call.value(options.estimate);
}

// -------------------------------------------------------------------------------------------------- results

/// A result as it crosses: what a reference or pointer refers to is a value of its own.
template <class R>
struct Result {
    static R read(Reader& in) { return in.read<R>(); }
};
template <class R>
struct Result<const R&> {
    static const R& read(Reader& in) {
        static thread_local std::deque<R> kept;
        return kept.emplace_back(in.read<R>());
    }
};
template <class R>
struct Result<const R*> {
    static const R* read(Reader& in) { return in.read<bool>() ? &Result<const R&>::read(in) : nullptr; }
};
template <>
struct Result<void> {
    static void read(Reader&) {}
};

/// What an argument that the function may change has become.
template <class T>
void read_back(Reader&, const T&) {}
inline void read_back(Reader& in, Stream& stream) { in(stream); }
template <class T>
void read_back(Reader& in, std::vector<T>& changed) {
    in(changed);
}
template <class T>
requires(!std::is_const_v<T>) void read_back(Reader& in, std::span<T> changed) {
    const auto now = in.read<std::vector<T>>();
    if (now.size() != changed.size()) throw BadBytes("a list has another length than before");
    std::copy(now.begin(), now.end(), changed.begin());
}

void add_counts(Reader& in);

[[noreturn]] void returned_nonsense(std::string_view name, const char* what);

/// Calls the function in the worker.
template <class R, class... P>
R call(std::uint32_t number, std::string_view name, P&&... argument) {
    std::optional<std::vector<std::byte>> answer;
    while (!answer) {
        refuse_hopeless(number, name);
        Outgoing outgoing;
        (write_argument(outgoing, argument), ...);
        answer = ask(number, name, outgoing.out.bytes(), outgoing.callbacks);
    }
    try {
        Reader in(*answer);
        add_counts(in);
        (read_back(in, argument), ...);
        if constexpr (std::is_void_v<R>) {
            if (!in.at_end()) throw BadBytes("too much");
        } else {
            R result = Result<R>::read(in);
            if (!in.at_end()) throw BadBytes("too much");
            return result;
        }
    } catch (const BadBytes& error) {
        returned_nonsense(name, error.what());
    }
}

}  // namespace rt::grading
