// The reference of the fanuc family as a page of the manual, printed from the tables that the
// interpreter works with.
#pragma once
#include <string>

#include "channels/reference_words.hpp"

namespace polyturn::channels::fanuc {

std::string reference_page(const ReferenceWords& words);

}  // namespace polyturn::channels::fanuc
