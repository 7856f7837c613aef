// Answers of the store as tables that people read.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace polyturn::supervisor {
// `what`: the operation that was asked, "tools.list". `done`: a restore that was carried out, not
// only shown.
std::string store_table(const std::string& what, const nlohmann::json& answer, bool done);
}  // namespace polyturn::supervisor
