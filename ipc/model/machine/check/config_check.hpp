// Contradictions between parameters that are each within their limits: an axis of a channel that
// does not exist, two axes of one name. All of them are found at once, so that a commissioner
// corrects the machine in one go. Until there are none the controller does not become ready and
// nothing moves (NCT parameters, section 2.1).
#pragma once

#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

// Empty when the machine is consistent. Each diagnosis names parameter, scope and value in its
// detail.
[[nodiscard]] std::vector<Diagnosis> check_machine_config(const params::Table& table);

}  // namespace polyturn
