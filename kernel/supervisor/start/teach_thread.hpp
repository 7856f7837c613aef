// press teach_thread: a part has been clamped again, the tool has been moved by hand into the
// groove of its thread, the spindle with it. Where both stand becomes PT_THREAD_ANGLE and
// PT_THREAD_AT; with PT_THREAD_PICKUP threads begin where they meet that groove.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

bool is_teach_thread(std::string_view words);

// Parameter lines for "teach_thread L1" (off: "teach_thread L1=off"), from what the machine shows
// now. The thread's axis is the channel's Z; its spindle the one that the channel commands, else
// N0604.
Result<std::vector<std::string>> teach_thread(std::string_view words, const MachineStatus& status,
                                              const MachineConfig& machine,
                                              const params::Table& table);
// The same of a running instance.
Result<std::vector<std::string>> teach_thread(std::string_view words, const std::string& instance);

}  // namespace polyturn::supervisor
