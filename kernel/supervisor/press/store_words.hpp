// Offsets and zeros as an operator or a scenario sets them on a running controller:
//   offset L1 3 wear X=0.05      number 3 of the offset table; geometry, wear, second; X Y Z R T
//   zero L1 G54 Z=-150           by the language's own names
// Values as the tables show them (X as a diameter where the axis is one).
#pragma once
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// `name`: the text before the equals sign.
Result<Command> parse_store_value(std::string_view name, std::string_view value,
                                  const MachineConfig& machine);
// The same as a request of the store, which answers when it is on disk.
StoreRequest store_request_of(const Command& command);

}  // namespace polyturn::supervisor
