// The files of a box while it runs: what it may read, its scratch directory, and what is copied out of that.
#include "common/box/stage.hpp"

#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <linux/openat2.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace rt {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw InputError(fmt::format("{}: {}", what, std::strerror(errno)));
}

void write_text(const char* path, const std::string& text) {
    const Descriptor file(open(path, O_WRONLY | O_CLOEXEC));
    if (write(file.number, text.data(), text.size()) < 0) refuse(path);
}

/// Who is not root gets the right to mount in a user namespace, whose only user is the same as before.
void own_mounts() {
    const uid_t uid = geteuid();
    const gid_t gid = getegid();
    if (unshare(uid == 0 ? CLONE_NEWNS : CLONE_NEWNS | CLONE_NEWUSER) != 0)
        refuse("no mount namespace can be made");
    if (uid != 0) {
        write_text("/proc/self/setgroups", "deny");
        write_text("/proc/self/uid_map", fmt::format("{} {} 1", uid, uid));
        write_text("/proc/self/gid_map", fmt::format("{} {} 1", gid, gid));
    }
    if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
        refuse("mounts cannot be made private");
}

std::string opened(const Descriptor& descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor.number);
}

/// An empty file or directory, as `source` is one, to mount that on.
void make_place(const Descriptor& source, const std::string& place) {
    struct stat status {};
    fstat(source.number, &status);
    if (S_ISDIR(status.st_mode) ? mkdir(place.c_str(), 0755) != 0
                                : mknod(place.c_str(), S_IFREG | 0644, 0) != 0)
        refuse(place);
}

/// A regular file of `owner`'s below a directory, by no link; negative if there is none.
int open_regular(int directory, const std::string& name, uid_t owner, struct stat& status) {
    open_how how{};
    how.flags = O_RDONLY | O_NONBLOCK | O_CLOEXEC;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_XDEV;
    const auto file = static_cast<int>(syscall(SYS_openat2, directory, name.c_str(), &how, sizeof how));
    if (file < 0) return -1;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == owner) return file;
    close(file);
    return -1;
}

/// Copies a file into a directory: under another name first, so that it appears whole or not at all.
void copy_whole(int source, const struct stat& status, int directory, const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    const std::string temporary = fmt::format("{}.{}", name, getpid());
    const Descriptor target(
        openat(directory, temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (target.number < 0) refuse(path);
    off_t done = 0;
    bool good = true;
    while (good && done < status.st_size)
        good = sendfile(target.number, source, &done, static_cast<std::size_t>(status.st_size - done)) > 0;
    const mode_t mode = (status.st_mode & 0100) != 0 ? 0755 : 0644;
    if (good && fchmod(target.number, mode) == 0 &&
        renameat(directory, temporary.c_str(), directory, name.c_str()) == 0)
        return;
    const int error = errno;
    unlinkat(directory, temporary.c_str(), 0);
    errno = error;
    refuse(path);
}

}  // namespace

Stage::Stage(const Sandbox& box, const Identity& identity)
    : box_(box), identity_(identity), mounts_(box.mounts) {
    // While all paths are what they are for the grader.
    for (const Product& product : box.products) {
        const std::string directory = fs::path(product.host).parent_path().string();
        product_directories_.emplace_back(open(directory.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        if (product_directories_.back().number < 0) refuse(directory);
    }
    if (box.isolation == Isolation::Bubblewrap)
        cover_tmp();
    else
        make_directory();
}

Stage::~Stage() { remove_directory(); }

void Stage::cover_tmp() {
    own_mounts();
    std::list<Descriptor> sources;
    for (const Mount& source : mounts_) {
        sources.emplace_back(open(source.host.c_str(), O_PATH | O_CLOEXEC));
        if (sources.back().number < 0) refuse(source.host);
    }
    const std::string size = fmt::format("size=1m,nr_inodes={},mode=755", mounts_.size() + 8);
    if (mount("box", "/tmp", "tmpfs", MS_NOSUID | MS_NODEV, size.c_str()) != 0)
        refuse("/tmp cannot be covered");
    auto source = sources.begin();
    for (std::size_t i = 0; i < mounts_.size(); ++i, ++source) {
        const std::string place = fmt::format("/tmp/{}", i);
        make_place(*source, place);
        if (mount(opened(*source).c_str(), place.c_str(), nullptr, MS_BIND | MS_REC, nullptr) != 0)
            refuse(mounts_[i].host);
        mounts_[i].host = place;
    }
    scratch_ = "/tmp/scratch";
    mkdir(scratch_.c_str(), 0700);
    mount_scratch();
}

void Stage::make_directory() {
    scratch_ = "/tmp/box-" + std::string(6, 'X');  // mkdtemp puts a name that is free there
    if (!mkdtemp(scratch_.data())) refuse("/tmp");
    is_directory_ = true;
    if (!identity_.own()) return;
    if (chown(scratch_.c_str(), identity_.number(), identity_.number()) != 0) {
        remove_directory();
        refuse(scratch_);
    }
    if (!box_.may_mount) return;
    try {
        own_mounts();
        mount_scratch();
        is_mounted_ = true;
    } catch (const InputError&) {
        // What the level leaves open then, `open_at` says.
    }
}

void Stage::mount_scratch() const {
    const std::string options =
        fmt::format("size={},nr_inodes={},mode=700,uid={},gid={}", box_.limits.disk, box_.limits.files + 1,
                    identity_.number(), identity_.own() ? identity_.number() : getegid());
    if (mount("scratch", scratch_.c_str(), "tmpfs", MS_NOSUID | MS_NODEV, options.c_str()) != 0)
        refuse("no file system for the scratch directory");
}

void Stage::remove_directory() {
    if (!is_directory_) return;
    if (is_mounted_) umount2(scratch_.c_str(), MNT_DETACH);
    std::error_code ignored;
    fs::remove_all(scratch_, ignored);
}

std::vector<std::string> Stage::copy_products() const {
    std::vector<std::string> copied;
    const Descriptor scratch(open(scratch_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    auto directory = product_directories_.begin();
    for (const Product& product : box_.products) {
        struct stat status {};
        const Descriptor file(open_regular(scratch.number, product.inside, identity_.number(), status));
        if (file.number >= 0) {
            copy_whole(file.number, status, directory->number, product.host);
            copied.push_back(product.inside);
        }
        ++directory;
    }
    return copied;
}

}  // namespace rt
