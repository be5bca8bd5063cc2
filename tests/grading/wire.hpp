// Values as bytes, and back. The bytes of a worker may say anything: all that is read is checked before it
// becomes an object.
#pragma once

#include "common/world/world.hpp"
#include "tests/grading/fields.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <unordered_map>
#include <variant>
#include <vector>

namespace rt::grading {

/// Thrown by Reader for bytes that are no values of the type that is read.
struct BadBytes : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// ------------------------------------------------------------------------------------------ kinds of types

template <class T>
inline constexpr bool is_glm = false;
template <glm::length_t N, class T, glm::qualifier Q>
inline constexpr bool is_glm<glm::vec<N, T, Q>> = true;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
inline constexpr bool is_glm<glm::mat<C, R, T, Q>> = true;

template <class T>
inline constexpr bool is_std_array = false;
template <class T, std::size_t N>
inline constexpr bool is_std_array<std::array<T, N>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional_value = false;
template <class T>
inline constexpr bool is_optional_value<std::optional<T>> = true;
template <class T>
inline constexpr bool is_variant = false;
template <class... T>
inline constexpr bool is_variant<std::variant<T...>> = true;
template <class T>
inline constexpr bool is_shared = false;
template <class T>
inline constexpr bool is_shared<std::shared_ptr<T>> = true;

template <class T>
constexpr bool is_raw();
template <class... Field>
constexpr bool all_raw(const Field&...) {
    return (is_raw<Field>() && ...);
}
template <class T>
constexpr bool all_fields_raw() {
    using Result = decltype(with_fields(std::declval<T&>(), [](auto&... field) {
        return std::bool_constant < (is_raw<std::remove_cvref_t<decltype(field)>>() && ...) &&
               (sizeof(field) + ... + 0) == sizeof(T) > ();
    }));
    return Result::value;
}

/// Whether any bytes are a value, and the value is nothing but its bytes: numbers and what is made of them
/// alone, without gaps. Such values are copied.
template <class T>
constexpr bool is_raw() {
    if constexpr (std::is_arithmetic_v<T>)
        return !std::is_same_v<T, bool>;
    else if constexpr (is_glm<T>)
        return true;
    else if constexpr (is_std_array<T>)
        return is_raw<typename T::value_type>();
    else if constexpr (std::is_aggregate_v<T> && std::is_trivially_copyable_v<T> && !std::is_empty_v<T>)
        return all_fields_raw<T>();
    else
        return false;
}

/// The compiler names an enumerator, but writes a number that is none in brackets.
template <class E, E value>
constexpr bool is_enumerator() {
    const std::string_view name = __PRETTY_FUNCTION__;
    const std::size_t at = name.rfind("value = ");
    return at != std::string_view::npos && name[at + 8] != '(';
}

/// Whether a number is one of an enumeration's that count from 0 and are fewer than 64.
template <class E>
constexpr bool is_value_of(std::underlying_type_t<E> number) {
    constexpr auto values = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<bool, sizeof...(I)>{
            is_enumerator<E, static_cast<E>(static_cast<std::underlying_type_t<E>>(I))>()...};
    }
    (std::make_index_sequence<64>());
    static_assert(values[0]);
    return number >= 0 && static_cast<std::size_t>(number) < values.size() &&
           values[static_cast<std::size_t>(number)];
}

/// Calls `use` with all the fields of a struct.
template <class T, class Use>
decltype(auto) fields_of(T& value, Use use) {
    return with_fields(value, use);
}
template <class Group, class Extras, class Use>
decltype(auto) fields_of_group(Group& group, Extras& extras, Use use) {
    return with_fields(extras, [&](auto&... extra) -> decltype(auto) {
        return use(extra..., group.shapes, group.primitive, group.accelerator, group.mailbox);
    });
}
template <class Shape, class Use>
decltype(auto) fields_of(Group<Shape>& group, Use use) {
    return fields_of_group(group, static_cast<Extras<Shape>&>(group), use);
}
template <class Shape, class Use>
decltype(auto) fields_of(const Group<Shape>& group, Use use) {
    return fields_of_group(group, static_cast<const Extras<Shape>&>(group), use);
}

// --------------------------------------------------------------------------------------------------- writing

/// Makes bytes of values. An object that several shared pointers hold is written once.
class Writer {
public:
    template <class T>
    void operator()(const T& value) {
        if constexpr (is_raw<T>())
            raw(&value, sizeof value);
        else if constexpr (std::is_same_v<T, bool>)
            (*this)(static_cast<std::uint8_t>(value));
        else if constexpr (std::is_enum_v<T>)
            (*this)(static_cast<std::underlying_type_t<T>>(value));
        else if constexpr (std::is_same_v<T, std::string>)
            list(std::span<const char>(value));
        else if constexpr (is_vector<T>)
            list(std::span<const typename T::value_type>(value));
        else if constexpr (is_std_array<T>)
            for (const auto& element : value) (*this)(element);
        else if constexpr (is_optional_value<T>)
            optional(value);
        else if constexpr (is_variant<T>)
            variant(value);
        else if constexpr (is_shared<T>)
            shared(value);
        else
            fields_of(value, [this](const auto&... field) { ((*this)(field), ...); });
    }

    template <class T>
    void list(std::span<const T> values) {
        (*this)(static_cast<std::uint64_t>(values.size()));
        if constexpr (is_raw<T>())
            raw(values.data(), values.size_bytes());
        else
            for (const T& value : values) (*this)(value);
    }

    void raw(const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::byte*>(data);
        made.insert(made.end(), begin, begin + size);
    }

    const std::vector<std::byte>& bytes() const { return made; }
    void clear() {
        made.clear();
        written.clear();
    }

private:
    template <class T>
    void optional(const std::optional<T>& maybe) {
        (*this)(maybe.has_value());
        if (maybe) (*this)(*maybe);
    }

    template <class... T>
    void variant(const std::variant<T...>& one) {
        (*this)(static_cast<std::uint8_t>(one.index()));
        std::visit([this](const auto& value) { (*this)(value); }, one);
    }

    // 0 for nothing, else 1 + the object's number, which follows where it is met first.
    template <class T>
    void shared(const std::shared_ptr<T>& object) {
        const auto number = [&]() -> std::uint32_t {
            if (!object) return 0;
            return written.try_emplace(object.get(), static_cast<std::uint32_t>(written.size() + 1))
                .first->second;
        };
        const std::size_t before = written.size();
        (*this)(number());
        if (written.size() > before) (*this)(*object);
    }

    std::vector<std::byte> made;
    std::unordered_map<const void*, std::uint32_t> written;
};

// --------------------------------------------------------------------------------------------------- reading

/// Makes values of bytes; throws BadBytes where they are none.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : left(bytes) {}

    template <class T>
    T read() {
        T value{};
        (*this)(value);
        return value;
    }

    template <class T>
    void operator()(T& value) {
        if constexpr (is_raw<T>())
            raw(&value, sizeof value);
        else if constexpr (std::is_same_v<T, bool>)
            value = read_bool();
        else if constexpr (std::is_enum_v<T>)
            value = read_enum<T>();
        else if constexpr (std::is_same_v<T, std::string> || is_vector<T>)
            list(value);
        else if constexpr (is_std_array<T>)
            for (auto& element : value) (*this)(element);
        else if constexpr (is_optional_value<T>)
            value = read_bool() ? T(read<typename T::value_type>()) : T();
        else if constexpr (is_variant<T>)
            variant(value);
        else if constexpr (is_shared<T>)
            shared(value);
        else
            fields_of(value, [this](auto&... field) { ((*this)(field), ...); });
        if constexpr (std::is_same_v<T, Image>)
            if (value.width < 0 || value.height < 0 ||
                std::uint64_t(value.width) * std::uint64_t(value.height) != value.pixels.size())
                throw BadBytes("an image has not as many pixels as it says");
    }

    std::span<const std::byte> take(std::size_t size) {
        if (size > left.size()) throw BadBytes("it ends in the middle of a value");
        const std::span<const std::byte> taken = left.first(size);
        left = left.subspan(size);
        return taken;
    }

    bool at_end() const { return left.empty(); }

private:
    void raw(void* data, std::size_t size) {
        const std::span<const std::byte> taken = take(size);
        if (size > 0) std::memcpy(data, taken.data(), size);
    }

    bool read_bool() {
        const auto number = read<std::uint8_t>();
        if (number > 1) throw BadBytes("a truth value is " + std::to_string(number));
        return number == 1;
    }

    template <class E>
    E read_enum() {
        const auto number = read<std::underlying_type_t<E>>();
        if (!is_value_of<E>(number)) throw BadBytes("an enumeration has no value " + std::to_string(number));
        return static_cast<E>(number);
    }

    // Bytes bound the number of elements, not what is said of it.
    template <class List>
    void list(List& values) {
        using T = typename List::value_type;
        const auto count = read<std::uint64_t>();
        if (count > left.size())
            throw BadBytes("a list of " + std::to_string(count) + " elements is cut off");
        values.clear();
        if constexpr (is_raw<T>()) {
            if (count > left.size() / sizeof(T)) throw BadBytes("a list is cut off");
            values.resize(count);
            raw(values.data(), count * sizeof(T));
        } else {
            // Grids hold grids: whoever sends a million of them inside each other would fill the stack.
            if (++depth > 32) throw BadBytes("lists are nested too deeply");
            for (std::uint64_t i = 0; i < count; ++i) values.push_back(read<T>());
            --depth;
        }
    }

    template <class... T>
    void variant(std::variant<T...>& one) {
        const auto index = read<std::uint8_t>();
        if (index >= sizeof...(T)) throw BadBytes("a variant has no alternative " + std::to_string(index));
        std::size_t i = 0;
        ((i++ == index ? void(one = read<T>()) : void()), ...);
    }

    template <class T>
    void shared(std::shared_ptr<T>& object) {
        const auto number = read<std::uint32_t>();
        object = nullptr;
        if (number == 0) return;
        if (number <= objects.size()) {
            const auto& [seen, type] = objects[number - 1];
            if (!seen || type != std::type_index(typeid(T))) throw BadBytes("a shared object is another's");
            object = std::static_pointer_cast<T>(seen);
            return;
        }
        if (number != objects.size() + 1) throw BadBytes("a shared object is missing");
        objects.emplace_back(nullptr, std::type_index(typeid(T)));
        const auto made = std::make_shared<std::remove_const_t<T>>();
        (*this)(*made);
        objects[number - 1].first = made;
        object = made;
    }

    std::span<const std::byte> left;
    std::vector<std::pair<std::shared_ptr<void>, std::type_index>> objects;
    int depth = 0;
};

}  // namespace rt::grading
