// Subprograms and repeated sections: entering, binding parameters, returning.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "channels/program_files.hpp"
#include "channels/sinumerik/grammar/tables.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct Level;

bool call_program(Execution& x, const std::string& name, std::vector<Argument> arguments,
                  std::int64_t repeats, bool modal);
bool read_proc(Execution& x, const std::string& name, std::vector<Argument>& arguments,
               Level& level);
bool return_from_level(Execution& x);
bool run_section(Execution& x, TextPosition from, std::uint64_t end, std::int64_t repeats,
                 bool block_only);
bool call_section(Execution& x, const std::string& name, const std::string& first,
                  const std::string& last);
void leave_sections(Execution& x, std::uint64_t offset);

}  // namespace polyturn::channels::sinumerik
