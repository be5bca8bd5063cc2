// What a grader and the supervisor of a box tell each other over a socket: a request, then a reply.
#pragma once

#include "common/sandbox/sandbox.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

struct Request {
    Sandbox box;
    std::vector<std::string> command;
    std::size_t descriptors = 0;  ///< how many follow standard error
};

struct Reply {
    std::string refusal;  ///< why the program could not be started, one line; empty if it was
    Ending verdict;
};

std::string to_message(const Request& request);
std::string to_message(const Reply& reply);

/// Throw std::exception if the message is not one.
Request request_from(const std::string& message);
Reply reply_from(const std::string& message);

/// Sends a message whole; what the other side does not want to know any more is lost without a signal.
void send_message(int socket, const std::string& message);

/// Waits for a message; false if the other side ended before it was whole.
bool receive_message(int socket, std::string& message);

}  // namespace rt
