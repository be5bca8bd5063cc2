// Another program as a child of this one: its output, its end, and a limit on its time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

struct ProcessOptions {
    double time_limit = 0;  ///< seconds that the child may have, not counting others'; 0 is no limit
    int last_words = 0;  ///< a signal that is sent a second before it is killed, so that it can say something
    std::function<void()> while_waiting;                           ///< called some times a second
    std::function<void(std::string_view line)> on_line;            ///< told each line of output as it comes
    std::vector<std::pair<std::string, std::string>> environment;  ///< added to this program's
    std::size_t output_limit = 1 << 20;                            ///< bytes of output that are kept
    bool merge_errors = true;  ///< standard error goes into `output` too; else it is this program's
};

struct ProcessResult {
    int exit_code = 0;  ///< meaningful where `signal` is 0; 127 if the program could not be started
    int signal = 0;     ///< that ended it; 0 if it ended by itself
    bool timed_out = false;
    double seconds = 0;
    std::string output;  ///< its beginning, as much as was to be kept
};

/// Whether the child ended by itself with status 0.
inline bool succeeded(const ProcessResult& result) { return result.exit_code == 0 && result.signal == 0; }

/// Runs a program, found as a shell would, and waits for its end. With a time limit the child may also use no
/// more memory than 4 GiB, so that a runaway loop cannot take the machine down.
ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

/// Replaces this program by another, in which `environment` is added. Returns only if that fails.
void replace_process(const std::vector<std::string>& command,
                     const std::vector<std::pair<std::string, std::string>>& environment);

/// What a signal means to a person: "segmentation fault".
std::string signal_name(int signal);

}  // namespace rt
