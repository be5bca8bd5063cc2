// A judge and a worker take turns in memory that both share.
#include "tests/grading/channel.hpp"

#include <fcntl.h>
#include <linux/futex.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <string>

namespace rt::grading {

namespace {

constexpr std::size_t page = 4096;
constexpr std::size_t most = std::size_t{64} << 20;  // bytes of a message
constexpr std::size_t part_size = page + most;
constexpr std::size_t size = page + 2 * part_size;
constexpr int most_spins =
    2000;  // some 50 µs: being woken takes about as long where the core had nothing to do
constexpr int try_again = 32;  // messages after which spinning may help again

struct Header {
    std::uint32_t kind = 0;
    std::uint32_t number = 0;
    std::uint64_t bytes = 0;
};

Side other(Side side) { return side == Side::Judge ? Side::Worker : Side::Judge; }

void pause_a_little() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#else
    std::atomic_signal_fence(std::memory_order_seq_cst);
#endif
}

}  // namespace

struct Channel::Control {
    std::atomic<std::uint32_t> turn;       // whose it is
    std::atomic<std::uint32_t> asleep[2];  // whether that side waits for the kernel to wake it
};

int Channel::make_file() {
    const int file = ::memfd_create("channel", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (file < 0 || ::ftruncate(file, static_cast<off_t>(size)) != 0 ||
        ::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
        throw std::runtime_error(std::string("no shared memory: ") + std::strerror(errno));
    return file;
}

Channel::Channel(int file, Side one) : side(one), spins(most_spins) {
    void* const mapped = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped == MAP_FAILED)
        throw std::runtime_error(std::string("shared memory cannot be mapped: ") + std::strerror(errno));
    memory = static_cast<std::byte*>(mapped);
    control = static_cast<Control*>(mapped);
    // The worker has the first word.
    if (side == Side::Judge) control->turn.store(static_cast<std::uint32_t>(Side::Worker));
}

Channel::~Channel() { ::munmap(memory, size); }

std::byte* Channel::part(Side whose) const { return memory + page + (whose == Side::Judge ? 0 : part_size); }

void Channel::send(Kind kind, std::uint32_t number, std::span<const std::byte> bytes) {
    if (bytes.size() > most) throw std::runtime_error("a message of more than 64 MiB");
    const Header header{static_cast<std::uint32_t>(kind), number, bytes.size()};
    std::memcpy(part(side), &header, sizeof header);
    if (!bytes.empty()) std::memcpy(part(side) + page, bytes.data(), bytes.size());

    const auto whose = static_cast<std::uint32_t>(other(side));
    control->turn.store(whose);
    if (control->asleep[whose].load() != 0)
        ::syscall(SYS_futex, &control->turn, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

std::optional<Message> Channel::receive(const std::function<bool()>& goes_on) {
    const auto mine = static_cast<std::uint32_t>(side);
    if (!spin_until_it_is(mine) && !sleep_until_it_is(mine, goes_on)) return {};

    Header header;
    std::memcpy(&header, part(other(side)), sizeof header);
    Message message{static_cast<Kind>(header.kind), header.number, {}};
    const std::size_t count = header.bytes <= most ? static_cast<std::size_t>(header.bytes) : 0;
    const std::byte* const from = part(other(side)) + page;
    message.bytes.assign(from, from + count);
    return message;
}

bool Channel::spin_until_it_is(std::uint32_t mine) {
    if (++received % try_again == 0) spins = most_spins;
    for (int i = 0; i <= spins; ++i) {
        if (control->turn.load(std::memory_order_acquire) == mine) {
            spins = std::min(2 * spins + 1, most_spins);
            return true;
        }
        pause_a_little();
    }
    spins /= 2;
    return false;
}

bool Channel::sleep_until_it_is(std::uint32_t mine, const std::function<bool()>& goes_on) {
    control->asleep[mine].store(1);
    while (control->turn.load() != mine) {
        const timespec slice{0, 20'000'000};
        const long slept = ::syscall(SYS_futex, &control->turn, FUTEX_WAIT,
                                     static_cast<std::uint32_t>(other(side)), &slice, nullptr, 0);
        // A worker may have written anything there.
        if (slept != 0 && errno == EAGAIN && control->turn.load() != mine) ::usleep(1000);
        if (control->turn.load() != mine && !goes_on()) return false;
    }
    control->asleep[mine].store(0);
    return true;
}

}  // namespace rt::grading
