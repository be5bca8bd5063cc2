// The files of a box while it runs: what it may read, its scratch directory, and what is copied out of that.
#pragma once

#include "common/box/identity.hpp"
#include "common/sandbox/sandbox.hpp"

#include <list>
#include <string>
#include <vector>

namespace rt {

/// At level Bubblewrap this process moves into a mount namespace of its own, where /tmp is covered by a place
/// that holds the mounts and the scratch directory. So no path to them need be open to the box's uid, nothing
/// is made on the machine's disk, and all of it goes with the last process. At the other levels there is a
/// directory in /tmp, on which a file system with limits is mounted if that can be.
class Stage {
public:
    /// Throws InputError where this machine does not allow it, or if a mount or a product's directory is
    /// missing.
    Stage(const Sandbox& box, const Identity& identity);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage();

    const std::string& scratch() const { return scratch_; }       ///< its place for this process
    const std::vector<Mount>& mounts() const { return mounts_; }  ///< with their places for this process

    /// Copies the products that the program has made; when no process is left. Returns their names. Throws
    /// InputError if one cannot be written.
    std::vector<std::string> copy_products() const;

private:
    void cover_tmp();
    void make_directory();
    void mount_scratch() const;
    void remove_directory();

    const Sandbox& box_;
    const Identity& identity_;
    std::string scratch_;
    std::vector<Mount> mounts_;
    std::list<Descriptor> product_directories_;
    bool is_directory_ = false, is_mounted_ = false;
};

}  // namespace rt
