#include "ipc/memory/controller_door.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "ipc/memory/segment.hpp"
#include "ipc/memory/trusted_owner.hpp"

namespace polyturn {
namespace {

constexpr int kBacklog = 64;
constexpr std::string_view kTail = ".sock";

struct Descriptor {
    int fd = -1;
    explicit Descriptor(int number = -1) : fd(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
    int release() { return std::exchange(fd, -1); }
};

struct Address {
    sockaddr_un un{};
    socklen_t size = 0;
    const sockaddr* any() const { return reinterpret_cast<const sockaddr*>(&un); }
};

Address abstract_address(const std::string& instance) {
    const std::string name = "polyturn." + instance;  // valid_instance(): short enough
    Address out;
    out.un.sun_family = AF_UNIX;
    // a leading zero byte: abstract
    std::memcpy(out.un.sun_path + 1, name.data(),
                std::min(name.size(), sizeof out.un.sun_path - 2));
    out.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    return out;
}

std::optional<Address> file_address(const std::string& path) {
    Address out;
    out.un.sun_family = AF_UNIX;
    if (path.size() + 1 > sizeof out.un.sun_path) return {};
    std::memcpy(out.un.sun_path, path.data(), path.size());
    out.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size() + 1);
    return out;
}

std::string from_environment(const char* name) {
    const char* text = std::getenv(name);
    if (!text || text[0] != '/') return {};
    const std::string all = text;
    return all.substr(0, all.find(':'));  // RUNTIME_DIRECTORY may name several
}

// Where the controller of this user keeps its socket, the best place first.
std::vector<std::string> own_folders() {
    std::vector<std::string> out;
    if (const std::string given = from_environment("RUNTIME_DIRECTORY"); !given.empty())
        out.push_back(given);
    if (geteuid() == 0) out.push_back("/run/polyturn");
    if (const std::string runtime = from_environment("XDG_RUNTIME_DIR"); !runtime.empty())
        out.push_back(runtime + "/polyturn");
    out.push_back("/tmp/polyturn-" + std::to_string(geteuid()));
    return out;
}

// The folder, ours and writable by us alone; -1: there is none and none can be made, or it is
// somebody's trap.
int open_own_folder(const std::string& folder) {
    ::mkdir(folder.c_str(), 0755);
    const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    struct stat about {};
    if (fd >= 0 && ::fstat(fd, &about) == 0 && about.st_uid == geteuid() &&
        (about.st_mode & 022) == 0)
        return fd;
    if (fd >= 0) ::close(fd);
    return -1;
}

// Bound and connected through the open folder: whatever the path leads to meanwhile.
std::string inside(int folder, const std::string& name) {
    return "/proc/self/fd/" + std::to_string(folder) + "/" + name;
}

int new_socket(int flags) { return ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | flags, 0); }

std::int64_t peer_uid(int fd) {
    ucred who{};
    socklen_t size = sizeof who;
    return ::getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &who, &size) == 0
               ? static_cast<std::int64_t>(who.uid)
               : -1;
}

// Whoever made the controller's segment: his folders are looked into as well; -1: there is none, or
// a stranger's.
std::int64_t owner_of(const std::string& instance) {
    struct stat about {};
    const std::string segment = "/dev/shm/" + segment_name(instance, SegmentKind::Supervisor);
    return ::lstat(segment.c_str(), &about) == 0 && S_ISREG(about.st_mode) &&
                   trusted_owner(about.st_uid)
               ? static_cast<std::int64_t>(about.st_uid)
               : -1;
}

enum class Found { Nobody, Foreign, Controller };

Found try_one(const Address& address, bool blocking, int& out) {
    Descriptor one(new_socket(blocking ? 0 : SOCK_NONBLOCK));
    const timeval timeout{30, 0};  // of a stopped controller the queue is full one day
    if (one.fd < 0 ||
        ::setsockopt(one.fd, SOL_SOCKET, SO_SNDTIMEO, &timeout, sizeof timeout) != 0 ||
        ::connect(one.fd, address.any(), address.size) != 0)
        return Found::Nobody;
    const std::int64_t uid = peer_uid(one.fd);
    if (uid < 0 || !trusted_owner(static_cast<uid_t>(uid))) return Found::Foreign;
    out = one.release();
    return Found::Controller;
}

}  // namespace

ControllerDoor::ControllerDoor(ControllerDoor&& other) noexcept
    : listeners_(std::move(other.listeners_)),
      path_(std::move(other.path_)),
      foreign_(other.foreign_) {
    other.listeners_.clear();
    other.path_.clear();
}

ControllerDoor::~ControllerDoor() {
    if (!path_.empty()) ::unlink(path_.c_str());
    for (const int fd : listeners_) ::close(fd);
}

Result<ControllerDoor> ControllerDoor::open(const std::string& instance) {
    const auto runs = [&] { return Diagnosis{Alarm::InstanceRuns, {}, {}, instance}; };
    ControllerDoor out;
    int why = 0;
    // The name that everybody may take is taken first: two controllers of one user meet here,
    // whatever their environments say.
    {
        const Address address = abstract_address(instance);
        Descriptor one(new_socket(SOCK_NONBLOCK));
        if (one.fd >= 0 && ::bind(one.fd, address.any(), address.size) == 0 &&
            ::listen(one.fd, kBacklog) == 0) {
            out.listeners_.push_back(one.release());
        } else if (why = errno; why == EADDRINUSE) {
            Descriptor probe(new_socket(SOCK_NONBLOCK));
            const bool ours = probe.fd >= 0 &&
                              ::connect(probe.fd, address.any(), address.size) == 0 &&
                              peer_uid(probe.fd) == static_cast<std::int64_t>(geteuid());
            if (ours) return runs();
            out.foreign_ = true;
        }
    }
    for (const std::string& folder : own_folders()) {
        Descriptor place(open_own_folder(folder));
        if (place.fd < 0) continue;
        // until this one listens: another one that starts just now waits, and then meets it
        while (::flock(place.fd, LOCK_EX) != 0 && errno == EINTR) {}
        const std::string name = instance + std::string(kTail);
        const auto address = file_address(inside(place.fd, name));
        if (!address) continue;
        if (Descriptor probe(new_socket(SOCK_NONBLOCK));
            probe.fd >= 0 &&
            (::connect(probe.fd, address->any(), address->size) == 0 || errno == EAGAIN))
            return runs();
        ::unlinkat(place.fd, name.c_str(), 0);  // of one that was killed
        Descriptor one(new_socket(SOCK_NONBLOCK));
        if (one.fd < 0 || ::bind(one.fd, address->any(), address->size) != 0) continue;
        // who may connect is decided by who he is, not by the file
        ::fchmodat(place.fd, name.c_str(), 0666, 0);
        if (::listen(one.fd, kBacklog) != 0) continue;
        out.listeners_.push_back(one.release());
        out.path_ = folder + "/" + name;
        break;
    }
    if (out.foreign_ && out.listeners_.empty())
        return Diagnosis{Alarm::InstanceForeign, {}, {}, "@polyturn." + instance};
    if (out.listeners_.empty())
        return Diagnosis{
            Alarm::ProcessStart, {}, {}, std::string("its socket (") + std::strerror(why) + ")"};
    return out;
}

Result<int> connect_to_controller(const std::string& instance, bool blocking) {
    if (!valid_instance(instance)) return Diagnosis{Alarm::InstanceName, {}, {}, instance};
    const std::int64_t owner = owner_of(instance);
    std::vector<std::string> folders = own_folders();
    const auto add = [&](std::string folder) {
        if (std::find(folders.begin(), folders.end(), folder) == folders.end())
            folders.push_back(std::move(folder));
    };
    add("/run/polyturn");
    if (owner >= 0) {
        add("/run/user/" + std::to_string(owner) + "/polyturn");
        add("/tmp/polyturn-" + std::to_string(owner));
    }
    bool foreign = false;
    int fd = -1;
    for (const std::string& folder : folders)
        if (const auto address = file_address(folder + "/" + instance + std::string(kTail))) {
            const Found found = try_one(*address, blocking, fd);
            if (found == Found::Controller) return fd;
            foreign = foreign || found == Found::Foreign;
        }
    const Found found = try_one(abstract_address(instance), blocking, fd);
    if (found == Found::Controller) return fd;
    if (foreign || found == Found::Foreign)
        return Diagnosis{Alarm::InstanceForeign, {}, {}, instance};
    return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
}

std::vector<std::string> remove_dead_doors() {
    std::vector<std::string> out;
    for (const std::string& folder : own_folders()) {
        Descriptor place(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        struct stat about {};
        if (place.fd < 0 || ::fstat(place.fd, &about) != 0 || about.st_uid != geteuid() ||
            ::flock(place.fd, LOCK_EX | LOCK_NB) != 0)
            continue;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
            const std::string name = entry.path().filename().string();
            if (!name.ends_with(kTail)) continue;
            const auto address = file_address(inside(place.fd, name));
            if (!address) continue;
            Descriptor probe(new_socket(SOCK_NONBLOCK));
            if (probe.fd < 0 || ::connect(probe.fd, address->any(), address->size) == 0 ||
                errno != ECONNREFUSED)
                continue;
            if (::unlinkat(place.fd, name.c_str(), 0) == 0) out.push_back(folder + "/" + name);
        }
    }
    return out;
}

}  // namespace polyturn
