// What holds, for variables #4001 and on and for screens; #3003, #3004.
#pragma once
#include <cstdint>
#include <string>

#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool modal_variable(Execution& x, std::int64_t number, double& value);
void active_codes(const Execution& x, std::string& out);
void list_variables(const Execution& x, const Language::ShowVariable& show);
std::uint32_t control_bits(const Execution& x);
void tell_control(Execution& x);

}  // namespace polyturn::channels::fanuc
