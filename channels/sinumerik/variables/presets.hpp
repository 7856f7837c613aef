// Values that setup and operator give by name, and what screens show of the language.
#pragma once
#include <string>
#include <string_view>

#include "channels/language.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

void active_codes(const Execution& x, std::string& out);
void list_variables(const Execution& x, const Language::ShowVariable& show);
bool preset_variable(Execution& x, std::string_view name, double value);
bool preset_text(std::string_view, std::string_view);
bool preset_tool(Execution& x, int number, std::string_view name);
bool preset_edge(Execution& x, int tool, int edge, std::string_view parameter, double value);

}  // namespace polyturn::channels::sinumerik
