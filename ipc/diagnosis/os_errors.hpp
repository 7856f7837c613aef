// What the operating system says of a file, a place or a device (errno), in the language of the
// reader. One table: processes write it in English into the detail of a diagnosis (details.hpp),
// screens and command line show it in the reader's words, wherever it stands in a text.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn {

struct OsErrorRow {
    int number;              // errno
    std::string_view in[4];  // in the order of Tongue; English is what strerror says
};
std::span<const OsErrorRow> os_error_rows();
// What has no row is reported as the C library has it.
std::string os_error(int number, DisplayLanguage display_language);
// A text that quotes them at its end, in brackets or behind a colon ("a.nc: Permission denied", "/x
// (File exists)"), translated into another language.
std::string os_errors_in(std::string_view told, DisplayLanguage display_language);

}  // namespace polyturn
