// The reference of the language as a page of the manual, printed from the tables that the
// interpreter works with.
#pragma once
#include <string>

#include "channels/reference_words.hpp"

namespace polyturn::channels::sinumerik {

std::string reference_page(const ReferenceWords& words);

}  // namespace polyturn::channels::sinumerik
