// What an exercise that has not been started yet does.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace rt {

/// Thrown by `todo`. Tests and programs show it as *not started*, never as *wrong*.
struct NotImplemented : std::runtime_error {
    /// `id` is the exercise's number, such as "02.1".
    explicit NotImplemented(const std::string& id)
        : std::runtime_error("step " + id + " is not started"), step(id) {}
    std::string step;
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Stands for any value, so that `return todo("02.1");` compiles in every function. An optional is made from
/// its value: with a conversion of its own besides, compilers would warn of the choice.
struct Todo {
    std::string step;
    template <class T>
    requires(!is_optional<T>) operator T() const { throw NotImplemented(step); }
};

/// The body of an exercise before the student replaces it: converts to whatever the function
/// returns, and throws NotImplemented while doing so.
[[nodiscard]] inline Todo todo(const char* step) { return Todo{step}; }

}  // namespace rt
