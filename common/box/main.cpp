// course-box: looks after one box. A program of its own, so that it has one thread, nothing in memory that a
// student must not see, and no descriptors but those that it was given.
#include "common/box/supervise.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <exception>

/// Standard input is a socket: a request comes, a reply goes; its end ends the box.
int main() {
    using namespace rt;
    umask(022);  // whatever the grader's is
    std::string message;
    if (!receive_message(STDIN_FILENO, message)) {
        std::fputs("course-box is started by ./course grade\n", stderr);
        return 2;
    }
    Reply reply;
    try {
        reply.verdict = supervise(request_from(message), STDIN_FILENO);
    } catch (const std::exception& error) {
        reply.refusal = error.what();
    }
    send_message(STDIN_FILENO, to_message(reply));
    return 0;
}
