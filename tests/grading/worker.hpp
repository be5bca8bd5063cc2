// The worker's end of a call: reads the arguments, calls the student's function, writes down what it returns.
#pragma once

#include "chapters/09_grids/build.hpp"
#include "common/math/stopwatch.hpp"
#include "common/render/render.hpp"
#include "common/world/search.hpp"
#include "tests/grading/channel.hpp"
#include "tests/grading/wire.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace rt::grading {

/// One function of the table, by its number: reads arguments and writes the result.
using Answer = void (*)(Reader&, Writer&);
extern const std::span<const Answer> answers;  // answers.cpp, which the build makes

/// Calls back function `number` of those that the judge gave with the call that is being answered.
std::vector<std::byte> call_back(std::uint32_t number, const Writer& arguments);

/// The number of the next callback among the arguments that are being read.
std::uint32_t next_callback();

/// Objects that were sent before, by their numbers.
std::map<std::uint32_t, std::shared_ptr<const void>>& known_objects();

// ------------------------------------------------------------------------------------------------ arguments

/// Holds an argument while the function runs. T is the parameter without const and reference.
template <class T>
struct Argument {
    std::shared_ptr<const T> held;
    explicit Argument(Reader& in) {
        const bool large = in.read<bool>();
        const std::uint32_t number = large ? in.read<std::uint32_t>() : 0;
        if (in.read<bool>()) {
            Reader own(in.take(in.read<std::uint64_t>()));
            held = std::make_shared<T>(own.read<T>());
            if (large) known_objects()[number] = held;
        } else {
            held = std::static_pointer_cast<const T>(known_objects().at(number));
        }
    }
    const T& get() const { return *held; }
    void write_back(Writer&) const {}
};
template <class T>
requires(is_raw<T>() && !std::is_same_v<T, Stream>) struct Argument<T> {
    T held;
    explicit Argument(Reader& in) : held(in.read<T>()) {}
    const T& get() const { return held; }
    void write_back(Writer&) const {}
};
template <class T>
struct Argument<std::span<const T>> : Argument<std::vector<T>> {
    using Argument<std::vector<T>>::Argument;
    std::span<const T> get() const { return *this->held; }
};
template <>
struct Argument<Stream> {
    Stream held;
    explicit Argument(Reader& in) : held(in.read<Stream>()) {}
    Stream& get() { return held; }
    void write_back(Writer& out) const { out(held); }
};
/// A list that the function changes.
template <class T>
struct Changed {
    std::vector<T> held;
    explicit Changed(Reader& in) : held(in.read<std::vector<T>>()) {}
    std::vector<T>& get() { return held; }
    void write_back(Writer& out) const { out(held); }
};
/// A list whose elements the function changes.
template <class T>
struct ChangedElements : Changed<T> {
    using Changed<T>::Changed;
    std::span<T> get() { return this->held; }
};
template <>
struct Argument<Ask> {
    struct Call {
        std::uint32_t number;
        Real operator()(std::span<const std::uint32_t> shapes, Interval part) const {
            Writer out;
            out.list(shapes);
            out(part);
            return Reader(call_back(number, out)).read<Real>();
        }
    } call;
    Ask ask{call};
    explicit Argument(Reader&) : call{next_callback()} {}
    Argument(const Argument&) = delete;
    const Ask& get() const { return ask; }
    void write_back(Writer&) const {}
};
/// Overlaps of shapes of ours, which this end can ask itself, or a callback: tests/grading/judge.hpp.
template <>
struct Argument<Overlaps> {
    Overlaps overlaps;
    explicit Argument(Reader& in) {
        if (const auto place = in.read<std::uint8_t>())
            of_shapes(in, place, Shapes());
        else
            overlaps = [number = next_callback()](std::uint32_t shape, const Bounds& box) {
                Writer out;
                out(shape);
                out(box);
                return Reader(call_back(number, out)).read<bool>();
            };
    }
    const Overlaps& get() const { return overlaps; }
    void write_back(Writer&) const {}

private:
    template <class... Shape>
    void of_shapes(Reader& in, std::uint8_t place, List<Shape...>) {
        std::uint8_t i = 0;
        ((++i == place ? hold<Shape>(in) : void()), ...);
    }
    template <class Shape>
    void hold(Reader& in) {
        const auto shapes = std::make_shared<Argument<std::span<const Shape>>>(in);
        const auto bounds = std::make_shared<Argument<std::span<const Bounds>>>(in);
        held = {shapes, bounds};
        overlaps = ShapeOverlaps<Shape>{shapes->get(), bounds->get()};
    }
    std::vector<std::shared_ptr<void>> held;
};
template <>
struct Argument<RayColor> {
    explicit Argument(Reader&) { number() = next_callback(); }
    RayColor get() const {
        return [](const World&, const Ray& ray, Stream& stream) {
            Writer out;
            out(ray);
            out(stream);
            const std::vector<std::byte> answer = call_back(number(), out);
            Reader in(answer);
            const auto seen = in.read<Vec3>();
            stream = in.read<Stream>();
            return seen;
        };
    }
    void write_back(Writer&) const {}

private:
    static std::uint32_t& number() {
        static std::uint32_t of_this_call = 0;
        return of_this_call;
    }
};
template <>
struct Argument<RenderOptions> {
    RenderOptions options;
    explicit Argument(Reader& in) {
        options.threads = in.read<int>();
        options.seconds = Argument<std::optional<double>>(in).get();
        options.error = Argument<std::optional<Real>>(in).get();
        options.estimate = Argument<bool>(in).get();
    }
    const RenderOptions& get() const { return options; }
    void write_back(Writer&) const {}
};

// -------------------------------------------------------------------------------------------------- results

template <class R>
void write_result(Writer& out, const R& result) {
    out(result);
}
template <class R>
void write_result(Writer& out, R* result) {
    out(result != nullptr);
    if (result) out(*result);
}

/// What the judge adds to its own: rays, searches, and the seconds that the function took.
void write_counts(Writer& out, double seconds);

/// What holds a parameter of type P.
template <class P>
struct Holder {
    using Type = Argument<std::remove_cvref_t<P>>;
};
template <class T>
struct Holder<std::vector<T>&> {
    using Type = Changed<T>;
};

template <class T>
requires(!std::is_const_v<T>) struct Holder<std::span<T>> {
    using Type = ChangedElements<T>;
};

/// The table's entry for a function.
template <auto function>
struct AnswerOf;
template <class R, class... P, R (*function)(P...)>
struct AnswerOf<function> {
    static void answer(Reader& in, Writer& out) {
        std::tuple<std::optional<typename Holder<P>::Type>...> arguments;
        std::apply(
            [&](auto&... argument) {
                (argument.emplace(in), ...);
                const Stopwatch watch;
                if constexpr (std::is_void_v<R>) {
                    function(argument->get()...);
                    write_counts(out, watch.seconds());
                    (argument->write_back(out), ...);
                } else {
                    const R& result = function(argument->get()...);
                    write_counts(out, watch.seconds());
                    (argument->write_back(out), ...);
                    write_result(out, result);
                }
            },
            arguments);
    }
};

}  // namespace rt::grading
