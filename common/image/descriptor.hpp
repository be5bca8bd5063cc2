// A file descriptor as a value.
#pragma once

#include <unistd.h>

namespace rt {

/// A file descriptor that is closed on every way out.
struct Descriptor {
    int number;

    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

}  // namespace rt
