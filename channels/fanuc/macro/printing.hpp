// POPEN, DPRNT, BPRNT, PCLOS.
#pragma once
#include <string_view>

#include "channels/fanuc/macro/flow.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

Flow print_statement(Execution& x, std::string_view name, const char*& at, const char* end);

}  // namespace polyturn::channels::fanuc
