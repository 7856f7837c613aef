// What a trace of the scope records, as it is asked for: "1 measured A3", "2 speed S1", "3 path
// L1", "4 signal CN_WTNG L1", "5 input 12", "6 off".
#pragma once
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

inline constexpr std::string_view kScopeShape =
    "scope 1 measured A3 (trace 1 to 8; command measured error velocity torque compensation A3, "
    "speed_command speed angle deviation S1, path left L1, signal NAME, input 5, off)";
Result<Command> parse_scope(std::string_view words, const MachineConfig& machine);

}  // namespace polyturn::supervisor
