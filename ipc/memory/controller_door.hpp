// The socket on which a controller listens for requests, and how a client makes sure that it is the
// controller that he speaks to: passwords go through this socket.
//
// The socket NAME.sock lies in a folder that belongs to the controller's user and that nobody
// else can write (checked on the open folder): $RUNTIME_DIRECTORY (a service of systemd),
// /run/polyturn (root), $XDG_RUNTIME_DIR/polyturn, or /tmp/polyturn-UID. Users of the controller
// who cannot reach that folder come by the abstract name "@polyturn.NAME", which everybody may
// take: without it the controller runs all the same.
//
// Whoever asks looks who listens (SO_PEERCRED) before he sends anything: only who is believed
// (trusted_owner.hpp) gets any data. Everybody else is passed over, as if he did not listen.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn {

// The controller's side. The file goes with it.
class ControllerDoor {
public:
    static Result<ControllerDoor> open(const std::string& instance);
    ControllerDoor(ControllerDoor&& other) noexcept;
    ControllerDoor& operator=(ControllerDoor&&) = delete;
    ~ControllerDoor();

    const std::vector<int>& listeners() const { return listeners_; }  // non-blocking; at least one
    // empty: there is no folder for it
    const std::string& path() const { return path_; }
    // somebody else listens at the abstract name
    bool name_is_foreign() const { return foreign_; }

private:
    ControllerDoor() = default;
    std::vector<int> listeners_;
    std::string path_;
    bool foreign_ = false;
};

// Connected to the controller of this name. SegmentMissing: no listener; InstanceForeign:
// a listener that must not get any data.
Result<int> connect_to_controller(const std::string& instance, bool blocking);

// Files of sockets without a listener, of this user's folders; they are removed.
std::vector<std::string> remove_dead_doors();

}  // namespace polyturn
