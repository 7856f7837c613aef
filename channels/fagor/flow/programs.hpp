// Where labels, subroutines and programs are found.
#pragma once
#include <cstdint>
#include <optional>

#include "channels/program_files.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// Subroutines from this number on are the machine maker's.
inline constexpr std::int64_t kMakerFirst = 10'000;

// A letter between the commas of the first line: %NAME,MX,
bool attribute_of(Execution& x, FileId file, char attribute);
// The subroutines that the main program defines; what is wrong with a definition is kept and
// reported before anything moves.
void index_subroutines(Execution& x, FileId file);
std::optional<TextPosition> find_label(Execution& x, FileId file, std::int64_t label);
std::optional<FileId> find_program(Execution& x, std::int64_t number);
bool find_subroutine(Execution& x, std::int64_t number, FileId& file, TextPosition& begin);
// Two programs that were loaded define it (part 2, 12.5).
bool defined_twice(Execution& x, std::int64_t number, FileId known);

}  // namespace polyturn::channels::fagor
