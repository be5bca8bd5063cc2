// What a grader and the supervisor of a box tell each other over a socket: a request, then a reply. In CBOR,
// because paths and output are bytes and need not be UTF-8.
#include "common/sandbox/message.hpp"

#include <nlohmann/json.hpp>

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace rt {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Limits, cpu_seconds, wall_seconds, process_memory, memory, stack,
                                   processes, file_size, disk, files, open_files, output)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mount, host, inside)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Product, inside, host)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sandbox, isolation, limits, mounts, products, environment, may_mount)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Request, box, command, descriptors)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Ending, end, number, wall_seconds, cpu_seconds, peak_memory, output,
                                   errors, products)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Reply, refusal, verdict)

namespace {

template <class Content>
std::string packed(const Content& content) {
    std::string bytes;
    nlohmann::json::to_cbor(nlohmann::json(content), bytes);
    return bytes;
}

/// All bytes, or none if the other side has ended.
bool receive_all(int socket, char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t got = read(socket, bytes, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

void send_all(int socket, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t sent = send(socket, bytes, count, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return;
        bytes += sent;
        count -= static_cast<std::size_t>(sent);
    }
}

}  // namespace

std::string to_message(const Request& request) { return packed(request); }
std::string to_message(const Reply& reply) { return packed(reply); }

Request request_from(const std::string& message) { return nlohmann::json::from_cbor(message).get<Request>(); }
Reply reply_from(const std::string& message) { return nlohmann::json::from_cbor(message).get<Reply>(); }

void send_message(int socket, const std::string& message) {
    const std::uint64_t size = message.size();
    char head[sizeof size];
    std::memcpy(head, &size, sizeof size);
    send_all(socket, head, sizeof head);
    send_all(socket, message.data(), message.size());
}

bool receive_message(int socket, std::string& message) {
    std::uint64_t size = 0;
    char head[sizeof size];
    if (!receive_all(socket, head, sizeof head)) return false;
    std::memcpy(&size, head, sizeof size);
    message.resize(size);
    return receive_all(socket, message.data(), message.size());
}

}  // namespace rt
