// What a controller does, as text for people and as JSON for programs; read from its shared memory.
#pragma once
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::supervisor {

// Names of controllers whose supervisor lives.
std::vector<std::string> running_instances();

// One line of JSON, or a page for people.
Result<std::string> status_json(const std::string& instance);
Result<std::string> status_page(const std::string& instance);

}  // namespace polyturn::supervisor
