// Searches among shapes: one after another, or as an accelerator says. All that asks for the nearest hit or
// for any hit goes through here, whatever the shapes; each kind's `intersect` is found by its name.
#pragma once

#include "common/world/accelerators.hpp"
#include "common/world/hit.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rt {

// ------------------------------------------------------------------------------------------- one question

/// Names a shape where there is none at hand.
template <class Shape>
struct ShapeTag {};

/// The ray as the shapes of a kind want it, worked out once a ray: itself, unless the shape's chapter says
/// otherwise.
template <class Shape>
const Ray& prepared(ShapeTag<Shape>, const Ray& ray) {
    return ray;
}

/// Whether the shape is hit in the range; a shape that knows a cheaper answer has one of its own.
template <class Shape, class PreparedRay>
bool is_hit(const Shape& shape, const PreparedRay& ray, Interval range) {
    return intersect(shape, ray, range).has_value();
}

// ------------------------------------------------------------------------------------------------ in a list

/// The nearest hit so far; of equal distances the lowest index wins, in whichever order they are asked.
struct Nearest {
    Interval range;  ///< ends at the hit, and includes it
    std::optional<Hit> hit{};

    template <class Shape, class PreparedRay>
    void ask(std::span<const Shape> shapes, std::uint32_t i, const PreparedRay& ray) {
        std::optional<Hit> found = intersect(shapes[i], ray, range);
        if (!found || (hit && found->t == hit->t && i > hit->primitive)) return;
        found->primitive = i;
        hit = found;
        range.max = found->t;
    }
};

// The two loops are kept out of the functions that call them, which else would save registers for them
// always.

/// Nearest hit with the shapes in (range.min, range.max], or nothing. `Hit::primitive` is the shape's index;
/// of equal distances the lowest wins.
template <class Shape>
[[gnu::noinline]] std::optional<Hit> closest_hit(std::span<const Shape> shapes, const Ray& ray,
                                                 Interval range) {
    const auto& own = prepared(ShapeTag<Shape>(), ray);
    Nearest nearest{range};
    for (std::uint32_t i = 0; i < shapes.size(); ++i) nearest.ask(shapes, i, own);
    return nearest.hit;
}

/// Whether any shape is hit in the range; stops at the first.
template <class Shape>
[[gnu::noinline]] bool any_hit(std::span<const Shape> shapes, const Ray& ray, Interval range) {
    const auto& own = prepared(ShapeTag<Shape>(), ray);
    for (const Shape& shape : shapes)
        if (is_hit(shape, own, range)) return true;
    return false;
}

// --------------------------------------------------------------------------------------- by an accelerator

/// Which ray asked a shape last, so that a ray asks no shape twice (Arnaldi, Priol & Bouatouch 1987).
struct Mailbox {
    std::uint32_t ray = 0;                ///< the number of the ray that is on its way
    std::vector<std::uint32_t> asked_by;  ///< for each shape the number of the last ray that asked it
};

/// The calling thread's mailbox with this number; it stays where it is.
Mailbox& mailbox_of(std::uint32_t number);

/// What rays asked on their way, for tests and figures.
struct SearchCounts {
    std::uint64_t cells = 0;   ///< cells entered
    std::uint64_t shapes = 0;  ///< shapes asked
};

/// The calling thread's counts so far.
SearchCounts& search_counts();

/// The shapes that one ray has asked. `mailbox` has room for all the shapes or grows.
class Asked {
public:
    Asked(Mailbox& box, std::size_t shapes) : mailbox(box) {
        if (mailbox.asked_by.size() < shapes) mailbox.asked_by.resize(shapes, 0);
        // After 2^32 rays the numbers begin anew, and those of old rays mean nothing any more.
        if (++mailbox.ray == 0) {
            mailbox.asked_by.assign(mailbox.asked_by.size(), 0);
            mailbox.ray = 1;
        }
    }
    ~Asked() { search_counts().shapes += count; }
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;

    /// Whether this ray has not asked the shape yet; from now on it has.
    bool is_new(std::uint32_t shape) {
        if (mailbox.asked_by[shape] == mailbox.ray) return false;
        mailbox.asked_by[shape] = mailbox.ray;
        ++count;
        return true;
    }

private:
    Mailbox& mailbox;
    std::uint64_t count = 0;
};

/// The same as without the accelerator, to the bit. Every shape is asked at most once.
template <class OneAccelerator, class Shape>
std::optional<Hit> closest_hit(const OneAccelerator& accelerator, std::span<const Shape> shapes,
                               const Ray& ray, Interval range, Mailbox& mailbox) {
    if (!serves(accelerator, ray)) return closest_hit(shapes, ray, range);
    const auto& own = prepared(ShapeTag<Shape>(), ray);
    Asked asked(mailbox, shapes.size());
    Nearest nearest{range};
    search(accelerator, ray, range, [&](std::span<const std::uint32_t> some, Interval) {
        for (const std::uint32_t i : some)
            if (asked.is_new(i)) nearest.ask(shapes, i, own);
        return nearest.range.max;
    });
    return nearest.hit;
}

/// Whether any shape is hit in the range, wherever in it; stops at the first.
template <class OneAccelerator, class Shape>
bool any_hit(const OneAccelerator& accelerator, std::span<const Shape> shapes, const Ray& ray, Interval range,
             Mailbox& mailbox) {
    if (!serves(accelerator, ray)) return any_hit(shapes, ray, range);
    const auto& own = prepared(ShapeTag<Shape>(), ray);
    Asked asked(mailbox, shapes.size());
    bool found = false;
    search(accelerator, ray, range, [&](std::span<const std::uint32_t> some, Interval) {
        for (const std::uint32_t i : some)
            if (asked.is_new(i) && is_hit(shapes[i], own, range)) {
                found = true;
                return -infinity;
            }
        return infinity;
    });
    return found;
}

/// Appends a hit for each shape that is hit in the range, its nearest there, in no particular order. Every
/// shape that the accelerator names along the range is asked, so the range should be short.
template <class OneAccelerator, class Shape>
void append_hits(const OneAccelerator& accelerator, std::span<const Shape> shapes, const Ray& ray,
                 Interval range, Mailbox& mailbox, std::vector<Hit>& hits) {
    const auto& own = prepared(ShapeTag<Shape>(), ray);
    const auto ask = [&](std::uint32_t i) {
        std::optional<Hit> hit = intersect(shapes[i], own, range);
        if (!hit) return;
        hit->primitive = i;
        hits.push_back(*hit);
    };
    if (!serves(accelerator, ray)) {
        for (std::uint32_t i = 0; i < shapes.size(); ++i) ask(i);
        return;
    }
    Asked asked(mailbox, shapes.size());
    search(accelerator, ray, range, [&](std::span<const std::uint32_t> some, Interval) {
        for (const std::uint32_t i : some)
            if (asked.is_new(i)) ask(i);
        return infinity;
    });
}

// The same for the shapes of a vector.

template <class Shape>
std::optional<Hit> closest_hit(const std::vector<Shape>& shapes, const Ray& ray, Interval range) {
    return closest_hit(std::span<const Shape>(shapes), ray, range);
}
template <class Shape>
bool any_hit(const std::vector<Shape>& shapes, const Ray& ray, Interval range) {
    return any_hit(std::span<const Shape>(shapes), ray, range);
}
template <class OneAccelerator, class Shape>
std::optional<Hit> closest_hit(const OneAccelerator& accelerator, const std::vector<Shape>& shapes,
                               const Ray& ray, Interval range, Mailbox& mailbox) {
    return closest_hit(accelerator, std::span<const Shape>(shapes), ray, range, mailbox);
}
template <class OneAccelerator, class Shape>
bool any_hit(const OneAccelerator& accelerator, const std::vector<Shape>& shapes, const Ray& ray,
             Interval range, Mailbox& mailbox) {
    return any_hit(accelerator, std::span<const Shape>(shapes), ray, range, mailbox);
}

// Without an accelerator every shape is asked.
inline bool serves(const Nothing&, const Ray&) { return false; }
inline void search(const Nothing&, const Ray&, Interval, const Ask&) {}
inline std::size_t bytes_of(const Nothing&) { return 0; }
inline std::string in_words(const Nothing&) { return "nothing"; }

}  // namespace rt
