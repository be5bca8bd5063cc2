// A judge and a worker take turns in memory that both share: each writes a message into its own part of it
// and passes the turn. Whoever waits spins for some microseconds, then sleeps: where spinning has not helped
// of late, because others want the processors too, at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rt::grading {

enum class Side : std::uint32_t { Judge, Worker };

/// What a message is.
enum class Kind : std::uint32_t {
    Ready,     ///< the worker waits for calls
    Call,      ///< of function `number`; then its arguments
    Return,    ///< the result of the last call
    Missing,   ///< the function is not written yet; then its step
    Refused,   ///< an InputError came out; then its text
    Threw,     ///< another exception came out; then its text
    Callback,  ///< of function `number` among those that the last call was given; then its arguments
    Result,    ///< of the last callback
    Calls,     ///< `number` calls; of each its number, its arguments' size and they
    Answers,   ///< to the last calls, one after the other: each's kind, its size and what it would be alone
};

/// Added to the number of a call: what was sent before is forgotten.
inline constexpr std::uint32_t forget = std::uint32_t{1} << 31;

struct Message {
    Kind kind = Kind::Ready;
    std::uint32_t number = 0;
    std::vector<std::byte> bytes;
};

/// One end. The other may be hostile: what it wrote is copied once, sizes are checked, and it can do no more
/// harm than say nonsense or keep silent.
class Channel {
public:
    /// Both ends map this file. The judge makes it; throws std::runtime_error where there is no memory.
    static int make_file();
    /// Maps `file`, which may be closed afterwards.
    Channel(int file, Side side);
    ~Channel();
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    /// Passes the turn with a message. Throws std::runtime_error for one of more than 64 MiB.
    void send(Kind kind, std::uint32_t number, std::span<const std::byte> bytes);

    /// Waits for the turn. `goes_on` is asked every 20 ms, not before the first; when it says no, there is no
    /// message.
    std::optional<Message> receive(const std::function<bool()>& goes_on);

private:
    struct Control;
    std::byte* part(Side whose) const;
    bool spin_until_it_is(std::uint32_t mine);
    bool sleep_until_it_is(std::uint32_t mine, const std::function<bool()>& goes_on);

    std::byte* memory = nullptr;
    Control* control = nullptr;
    Side side;
    int spins;         // that are worth trying
    int received = 0;  // messages
};

}  // namespace rt::grading
