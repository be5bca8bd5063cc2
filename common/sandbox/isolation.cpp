// The levels of isolation: their names, which of them this machine can do, and what each leaves open.
#include "common/sandbox/isolation.hpp"

#include "common/math/input_error.hpp"
#include "common/sandbox/system_files.hpp"

#include <fmt/format.h>

#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace rt {

namespace {

constexpr std::array levels{Isolation::Bubblewrap, Isolation::User, Isolation::None};

Level tried(Isolation isolation) {
    Sandbox box;
    box.isolation = isolation;
    box.mounts = compiler_mounts();
    try {
        const Ending verdict = run_in(box, {"/usr/bin/true"});
        if (verdict.end == End::Exited && verdict.number == 0) return {isolation, true, ""};
        return {isolation, false, "a program that does nothing " + in_words(verdict, box.limits)};
    } catch (const InputError& refusal) {
        return {isolation, false, refusal.what()};
    }
}

bool has_landlock() {
    constexpr int ask_version = 1;
    return syscall(SYS_landlock_create_ruleset, nullptr, 0, ask_version) > 0;
}

/// Whether root may mount, which a container's root most often may not.
bool has_mounts() {
    Sandbox box;
    box.isolation = Isolation::User;
    box.mounts = compiler_mounts();
    box.limits.files = 1;
    const Ending verdict = run_in(box, {"/usr/bin/touch", "a", "b", "c"});
    return verdict.end == End::Exited && verdict.number != 0;
}

}  // namespace

std::string_view name_of(Isolation isolation) {
    switch (isolation) {
        case Isolation::Bubblewrap:
            return "bwrap";
        case Isolation::User:
            return "user";
        case Isolation::None:
            return "none";
    }
    throw std::logic_error("a level of isolation without a name");
}

Isolation isolation_named(std::string_view name) {
    for (const Isolation isolation : levels)
        if (name_of(isolation) == name) return isolation;
    throw InputError(fmt::format("there is no level of isolation '{}'; they are bwrap, user and none", name));
}

std::vector<Level> probe() {
    std::vector<Level> tries;
    for (const Isolation isolation : levels) tries.push_back(tried(isolation));
    return tries;
}

void require_possible(Isolation isolation) {
    const Level wanted = tried(isolation);
    if (wanted.possible) return;
    std::string others;
    for (const Isolation other : levels)
        if (other != isolation && tried(other).possible)
            others += fmt::format("{}{}", others.empty() ? "; possible here: " : ", ", name_of(other));
    throw InputError(fmt::format("isolation level {} is not possible here: {}{}", name_of(isolation),
                                 wanted.reason, others));
}

std::vector<std::string> open_at(Isolation isolation) {
    const bool root = geteuid() == 0;
    if (isolation == Isolation::Bubblewrap)
        return root ? std::vector<std::string>{}
                    : std::vector<std::string>{"your own files, but for namespaces"};
    if (isolation == Isolation::None) {
        std::vector<std::string> open{"read what everybody may read", "write where everybody may write",
                                      "use the network", "see all processes",
                                      "fill the disk with many files"};
        if (!root) {
            open.push_back("read, write and delete your files");
            open.push_back("end your processes");
            open.push_back("start as many processes as you may");
        }
        return open;
    }
    std::vector<std::string> open{"see names and sizes of files that everybody may see"};
    if (!has_landlock()) {
        open.push_back("read what everybody may read");
        open.push_back("write where everybody may write");
        open.push_back("see all processes");
    }
    if (!has_mounts()) open.push_back("fill the disk with many files");
    return open;
}

}  // namespace rt
