// What searches keep from one ray to the next.
#include "common/world/search.hpp"

#include <deque>

namespace rt {

Mailbox& mailbox_of(std::uint32_t number) {
    // A deque, because a mesh asks for its mailbox while the accelerator that it stands in uses its own.
    thread_local std::deque<Mailbox> mailboxes;
    if (number >= mailboxes.size()) mailboxes.resize(number + 1);
    return mailboxes[number];
}

SearchCounts& search_counts() {
    thread_local SearchCounts counts;
    return counts;
}

}  // namespace rt
