#include "ipc/memory/trusted_owner.hpp"

#include <grp.h>
#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace polyturn {
namespace {

constexpr uid_t kNobody = static_cast<uid_t>(-1);
constexpr const char* kName = "polyturn";  // of the service's user and of its group

uid_t user_named(const char* name) {
    if (!name || !*name) return kNobody;
    passwd entry{}, *found = nullptr;
    std::array<char, 4096> room;
    return ::getpwnam_r(name, &entry, room.data(), room.size(), &found) == 0 && found
               ? found->pw_uid
               : kNobody;
}

bool in_own_group() {
    group entry{}, *found = nullptr;
    std::array<char, 16384> room;
    return ::getgrnam_r(kName, &entry, room.data(), room.size(), &found) == 0 && found &&
           found->gr_gid == ::getegid();
}

}  // namespace

bool trusted_owner(uid_t owner) {
    static const uid_t service = user_named(kName),
                       named = user_named(std::getenv("POLYTURN_OWNER"));
    return owner == ::geteuid() || owner == 0 ||
           (owner != kNobody && (owner == service || owner == named));
}

mode_t private_mode() {
    static const bool group = in_own_group();
    return group ? 0640 : 0600;
}

}  // namespace polyturn
