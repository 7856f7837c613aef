// A text file as a whole, with a diagnosis for what is no text file.
#pragma once
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

// Refuses what cannot be read, UTF-16, binary and files over 64 MB (nobody writes such a setup by hand).
Result<std::string> read_text_file(const std::string& path);

// Line `line` (from 1) of the text without its end, or nothing: what a diagnosis shows above its mark.
std::string_view line_of(std::string_view text, std::uint32_t line);

}  // namespace polyturn::text
