// What a program writes into a stream, kept up to a limit.
#include "common/box/capture.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace rt {

Capture::Capture(std::size_t limit) : reader_(-1), writer_(-1), limit_(limit) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw std::system_error(errno, std::generic_category(), "a pipe for a box");
    reader_.number = ends[0];
    writer_.number = ends[1];
    fcntl(reader_.number, F_SETFL, O_NONBLOCK);
}

void Capture::close_writer() { close(std::exchange(writer_.number, -1)); }

void Capture::read_available() {
    char buffer[65536];
    while (reader_.number >= 0 && !over_limit_) {
        const ssize_t count = read(reader_.number, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return;
        if (count == 0) {
            close(std::exchange(reader_.number, -1));
            return;
        }
        const auto size = static_cast<std::size_t>(count), room = limit_ - text_.size();
        text_.append(buffer, std::min(size, room));
        over_limit_ = size > room;
    }
}

}  // namespace rt
