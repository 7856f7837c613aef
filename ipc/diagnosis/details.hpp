// What a diagnosis says of the very case ({d} of its row: why a request is refused, what is
// missing), in the language of the reader. The processes write it in English, with names and
// numbers in it; the rows of details.cpp say how that reads elsewhere. What has no row (names,
// paths, words of a program) stays as it is; what the operating system says in it has a table of
// its own (os_errors.hpp).
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn {

struct DetailRow {
    std::string_view in[4];  // in the order of DisplayLanguage; {0} to {3} are what stands in the
                             // text
};
std::span<const DetailRow> detail_rows();
// Told in any of the languages.
std::string detail_in(std::string_view told, DisplayLanguage display_language);

}  // namespace polyturn
