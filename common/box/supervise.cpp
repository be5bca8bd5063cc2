// One box from its start to its end.
#include "common/box/supervise.hpp"

#include "common/box/launch.hpp"
#include "common/box/members.hpp"
#include "common/math/input_error.hpp"
#include "common/math/stopwatch.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

namespace rt {

namespace {

constexpr double look_seconds = 0.01;  ///< between two looks at memory and time
constexpr std::size_t message_limit = 4096;

/// Of the children that have been waited for, and theirs.
double cpu_seconds_of_ended() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t largest_of_ended() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) << 10;
}

std::string last_line(const std::string& text) {
    std::istringstream in(text);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) last = line;
    return last;
}

class Supervisor {
public:
    Supervisor(const Request& request, int control)
        : request_(request),
          limits_(request.box.limits),
          control_(control),
          stage_(request.box, identity_),
          output_(limits_.output),
          errors_(limits_.output) {}

    Ending run() {
        child_ = launch({request_, identity_, stage_, output_, errors_, failure_, status_});
        for (Capture* capture : captures()) capture->close_writer();
        const std::optional<End> ended = watch();
        verdict_.wall_seconds = stopwatch_.seconds();
        end_all();
        for (Capture* capture : captures()) capture->read_available();
        if (!failure_.text().empty()) throw InputError(failure_.text());
        judge(ended);
        verdict_.cpu_seconds = cpu_seconds_of_ended();
        verdict_.peak_memory = std::max(verdict_.peak_memory, largest_of_ended());
        verdict_.output = output_.text();
        verdict_.errors = errors_.text();
        verdict_.products = stage_.copy_products();
        return verdict_;
    }

private:
    std::array<Capture*, 4> captures() { return {&output_, &errors_, &failure_, &status_}; }

    /// Waits for the end of the child, or for a limit, which it returns.
    std::optional<End> watch() {
        const Descriptor child(static_cast<int>(syscall(SYS_pidfd_open, child_, 0)));
        if (child.number < 0) throw std::system_error(errno, std::generic_category(), "pidfd_open");
        for (double next_look = look_seconds;;) {
            pollfd events[] = {{child.number, POLLIN, 0},
                               {control_, POLLIN | POLLRDHUP, 0},
                               {output_.reader(), POLLIN, 0},
                               {errors_.reader(), POLLIN, 0}};
            poll(events, std::size(events), static_cast<int>(1000 * look_seconds));
            output_.read_available();
            errors_.read_available();
            if (output_.over_limit() || errors_.over_limit()) return End::Output;
            if (events[0].revents != 0) return std::nullopt;
            if (events[1].revents != 0) return End::Stopped;
            if (stopwatch_.seconds() > limits_.wall_seconds) return End::WallTime;
            if (stopwatch_.seconds() < next_look) continue;
            if (const auto limit = look()) return limit;
            next_look = stopwatch_.seconds() + look_seconds;
        }
    }

    std::optional<End> look() {
        const Members::Use use = members_.look();
        verdict_.peak_memory = std::max(verdict_.peak_memory, use.memory);
        if (use.memory > limits_.memory) return End::Memory;
        if (use.cpu_seconds + cpu_seconds_of_ended() > limits_.cpu_seconds) return End::CpuTime;
        return std::nullopt;
    }

    /// Ends and reaps every process of the box; orphans come to this process. One that dies may leave another
    /// behind, so it is repeated until there is none.
    void end_all() {
        const Stopwatch patience;
        for (;;) {
            int status = 0;
            pid_t ended = 0;
            while ((ended = waitpid(-1, &status, WNOHANG)) > 0)
                if (ended == child_) child_status_ = status;
            if (ended == -1 && errno == ECHILD) return;
            if (patience.seconds() > 10) throw std::runtime_error("processes of a box cannot be ended");
            if (identity_.own())
                identity_.kill_all();
            else
                for (const pid_t alive : Members().look().alive) kill(alive, SIGKILL);
            std::this_thread::sleep_for(std::chrono::microseconds(500));
        }
    }

    /// `ended` is the limit that ended it, if one did.
    void judge(std::optional<End> ended) {
        const bool boxed = request_.box.isolation == Isolation::Bubblewrap;
        if (boxed && !ended && status_.text().find("exit-code") == std::string::npos)
            throw InputError(errors_.text().empty() ? "bubblewrap ended without a word"
                                                    : last_line(errors_.text()));
        int signal = WIFSIGNALED(child_status_) ? WTERMSIG(child_status_) : 0;
        const int status = WEXITSTATUS(child_status_);
        // As a shell does, bubblewrap ends with 128 and the signal's number.
        if (boxed && signal == 0 && status > 128 && status <= 128 + SIGRTMAX) signal = status - 128;
        verdict_.end = ended ? *ended : signal != 0 ? End::Signal : End::Exited;
        verdict_.number = verdict_.end == End::Signal ? signal : verdict_.end == End::Exited ? status : 0;
        const bool by_kernel =
            signal == SIGXCPU || (signal == SIGKILL && cpu_seconds_of_ended() > limits_.cpu_seconds);
        if (!ended && by_kernel) verdict_.end = End::CpuTime;
    }

    const Request& request_;
    const Limits& limits_;
    int control_;
    Identity identity_;
    Stage stage_;
    Capture output_, errors_;
    Capture failure_{message_limit}, status_{message_limit};
    Members members_;
    Stopwatch stopwatch_;
    Ending verdict_;
    pid_t child_ = -1;
    int child_status_ = 0;
};

}  // namespace

Ending supervise(const Request& request, int control) {
    // Orphans of the box come here: they are seen, ended, waited for, and their time is counted.
    if (prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0)
        throw std::system_error(errno, std::generic_category(), "subreaper");
    if (request.box.isolation == Isolation::User && geteuid() != 0)
        throw InputError("only root can give a program a uid of its own");
    return Supervisor(request, control).run();
}

}  // namespace rt
