// Places in the program texts: blocks by their number, programs by theirs, and where reading goes
// on.
#pragma once
#include <cstdint>
#include <optional>

#include "channels/fanuc/program/text_place.hpp"
#include "channels/program_files.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

std::optional<TextPlace> find_block(Execution& x, std::int64_t number);
std::optional<TextPosition> find_program_in(Execution& x, FileId file, std::int64_t number);
TextPlace place_behind(const Execution& x, std::size_t column);
void go_on_at(Execution& x, const TextPlace& place);
void go_to(Execution& x, const TextPlace& place);
bool jump_to_block(Execution& x, std::int64_t number);

}  // namespace polyturn::channels::fanuc
