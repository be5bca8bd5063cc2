// A sandbox, called a box in what follows: another program is run in it with narrow limits, sees what it is
// given and nothing else, and leaves nothing behind. The program course-box (common/box) looks after each
// one.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

/// How far the program is kept apart, from the least to the most. What each level leaves open: `open_at` in
/// common/sandbox/isolation.hpp. No level is ever lowered: a box that cannot be had is an error.
enum class Isolation {
    None,       ///< limits only; a grader that is root gives the program a uid of its own all the same
    User,       ///< a uid of its own, a filter of system calls, files by Landlock; only root can do this
    Bubblewrap  ///< namespaces of its own on top of these: files, processes, network
};

/// Each is held by SIGKILL or by an error inside the box. Zero would be zero, not "no limit".
struct Limits {
    double cpu_seconds = 10;   ///< of processor time, of all processes together
    double wall_seconds = 20;  ///< from the start of the box to its end
    std::uint64_t process_memory = std::uint64_t{512} << 20;  ///< addresses of one process, in bytes
    std::uint64_t memory = std::uint64_t{768} << 20;          ///< resident, of all processes together
    std::uint64_t stack = std::uint64_t{8} << 20;             ///< of each thread
    std::uint64_t processes = 32;                             ///< threads count, too
    std::uint64_t file_size = std::uint64_t{16} << 20;        ///< bytes of one file
    std::uint64_t disk = std::uint64_t{64} << 20;             ///< bytes of all files
    std::uint64_t files = 2048;                               ///< how many, directories among them
    std::uint64_t open_files = 64;                            ///< descriptors of one process
    std::uint64_t output = std::uint64_t{1} << 20;            ///< bytes, of each of the two streams
};

/// A file or directory of this machine that the program may read and execute, with all that is below it.
/// Everybody must have the right to read it: the box has a uid of its own.
struct Mount {
    std::string host;    ///< absolute
    std::string inside;  ///< absolute; where it is seen at level Bubblewrap, while others see it at `host`
};

/// A file that the program makes in its scratch directory, and that is copied out when all of it has ended.
/// Only a regular file is; one that is missing, a link or a pipe is not copied, and makes no error.
struct Product {
    std::string inside;  ///< from the scratch directory, such as "program"
    std::string host;    ///< absolute; its directory must exist, and a file that is there is replaced whole
};

/// The program starts in an empty scratch directory, the only place where it may write, whose name it finds
/// in HOME and TMPDIR: /tmp at level Bubblewrap.
struct Sandbox {
    Isolation isolation = Isolation::Bubblewrap;
    Limits limits;
    std::vector<Mount> mounts;
    std::vector<Product> products;
    /// All that the program sees, beside HOME, TMPDIR and PATH.
    std::vector<std::pair<std::string, std::string>> environment;
    /// Where root may mount, the scratch directory is a file system of its own, which holds `disk` and
    /// `files`. False makes the box what it is in a container where root may not; level Bubblewrap needs it.
    bool may_mount = true;
};

/// The name by which the program knows a file or directory of this machine that is below one of the mounts.
std::string seen_from(const Sandbox& box, const std::filesystem::path& host);

enum class End {
    Exited,    ///< by itself, with a status
    Signal,    ///< by a signal, such as a segmentation fault
    CpuTime,   ///< by a limit, here and below
    WallTime,  //
    Memory,    ///< all processes together; one alone sees its allocation fail
    Output,    //
    Stopped    ///< by the grader
};

struct Ending {
    End end = End::Exited;
    int number = 0;  ///< the status for Exited, the signal for Signal
    double wall_seconds = 0;
    double cpu_seconds = 0;             ///< of all processes, with 10 ms or so of the box itself
    std::uint64_t peak_memory = 0;      ///< bytes resident of all processes together, looked at every 10 ms
    std::string output, errors;         ///< standard output and standard error, their beginnings
    std::vector<std::string> products;  ///< those that were copied out, by their names inside
};

/// "took more than 2 s of processor time"; a phrase that follows "the program".
std::string in_words(const Ending& verdict, const Limits& limits);

/// A program in its box. It is ended with all its processes when this goes, and when this process ends,
/// however that happens. May be handed to another thread; one thread at a time may use it.
class Boxed {
public:
    Boxed(pid_t supervisor, int control) : supervisor_(supervisor), control_(control) {}
    Boxed(Boxed&& other) noexcept
        : supervisor_(std::exchange(other.supervisor_, -1)), control_(std::exchange(other.control_, -1)) {}
    Boxed& operator=(Boxed&&) = delete;
    ~Boxed();

    /// Readable, as poll(2) calls it, when the box has ended.
    int descriptor() const { return control_; }
    bool ended() const;

    /// Ends the box; `wait` then says how it stood.
    void stop();

    /// Waits for the end, once. Throws InputError with one line if the program could not be started: the
    /// level is not possible here, a mount is missing or closed, there is no such program.
    Ending wait();

private:
    pid_t supervisor_;
    int control_;
};

/// Starts a program, named by its path inside, in a box. Standard input is empty; the program finds
/// `descriptors` as 3, 4, ... in their order, and no others. Throws InputError if there is no course-box.
Boxed start(const Sandbox& box, const std::vector<std::string>& command,
            std::span<const int> descriptors = {});

/// Starts it and waits for the end.
Ending run_in(const Sandbox& box, const std::vector<std::string>& command,
              std::span<const int> descriptors = {});

}  // namespace rt
