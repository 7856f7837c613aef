// Whose files and sockets a program of a controller believes. On a computer with several users
// anybody may make something under any name in /dev/shm or /tmp; what belongs to a stranger is
// neither opened, waited for nor spoken to.
//
// Believed are: the user who asks, root, the user "polyturn" of the installed service, and the user
// whom POLYTURN_OWNER names (for guests: users of the controller who look at it from an account of
// their own).
#pragma once
#include <sys/types.h>

namespace polyturn {

bool trusted_owner(uid_t owner);

// What is made for the controller alone: 0600; 0640 where the process runs in the group "polyturn",
// which is made for it.
mode_t private_mode();

}  // namespace polyturn
