// What a program writes into a stream, kept up to a limit.
#pragma once

#include "common/image/descriptor.hpp"

#include <cstddef>
#include <string>

namespace rt {

/// A pipe; the child gets its end `writer`.
class Capture {
public:
    /// Throws std::system_error if there is no pipe.
    explicit Capture(std::size_t limit);

    int reader() const { return reader_.number; }  ///< negative when all writers have ended
    int writer() const { return writer_.number; }
    void close_writer();

    /// Takes what is there now.
    void read_available();

    bool over_limit() const { return over_limit_; }
    const std::string& text() const { return text_; }

private:
    Descriptor reader_, writer_;
    std::size_t limit_;
    std::string text_;
    bool over_limit_ = false;
};

}  // namespace rt
