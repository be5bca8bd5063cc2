// Boxes for tests: in every way that this machine can do, and what they may not leave behind.
#pragma once

#include "common/sandbox/sandbox.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rt::test {

/// A level, and who asks for it: root, or a user without privileges.
struct Way {
    std::string name;
    Isolation isolation;
    bool root;
    bool may_mount = true;

    bool apart() const { return isolation != Isolation::None; }
    /// Whether files are limited in number and sum.
    bool counts_files() const { return isolation == Isolation::Bubblewrap || (root && may_mount); }
};

/// All that this machine can do. Those that it cannot are named on standard error, once, with the reason.
const std::vector<Way>& ways();

/// Short limits that no attack needs long to reach.
Limits small_limits();

/// A box that sees the attacks.
Sandbox attack_box(const Way& way);

/// The command that is an attack's program with arguments, as it is seen in this box.
std::vector<std::string> attack(const Sandbox& box, const std::string& name,
                                const std::vector<std::string>& arguments = {});

/// Makes this process who asks, for good. False if that cannot be.
bool become(const Way& way);

/// Does something as who asks: here, or in a child that is a user without privileges. What it throws comes
/// here.
Ending as(const Way& way, const std::function<Ending()>& action);

/// Runs a command in a box as who asks.
Ending run(const Way& way, const Sandbox& box, const std::vector<std::string>& command);

/// An attack in its box with small limits.
Ending run_attack(const Way& way, const std::string& name, const std::vector<std::string>& arguments = {});

/// The processes of attacks that run, as "box_forks (12)".
std::vector<std::string> attacks_running();

/// What a box could change around this process: mounts, shared memory, its files, environment, children and
/// descriptors.
std::vector<std::string> surroundings();

/// All of this machine that a box could change: files where everybody may write, and processes, too. Boxes of
/// other programs are seen there, but for those of level Bubblewrap: whoever has others must have this lock.
std::vector<std::string> machine();
std::filesystem::path boxes_lock();

/// A directory for this test that everybody may enter, empty; without a name the one around them all.
std::string fresh_directory(const std::string& name);

}  // namespace rt::test
