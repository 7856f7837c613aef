// A text file as a whole, with a diagnosis for what is no text file.
#pragma once
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/files/regular_file.hpp"

namespace polyturn::text {

// Refuses what is no ordinary file, cannot be read, is UTF-16, binary or larger than `largest`
// bytes.
Result<std::string> read_text_file(const std::string& path, std::uint64_t largest = kLargestText);

// Line `line` (from 1) of the text without its end, or nothing: what a diagnosis shows above its
// mark.
std::string_view line_of(std::string_view text, std::uint32_t line);

}  // namespace polyturn::text
