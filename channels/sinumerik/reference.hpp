// The reference of the language as a page of the manual, printed from the tables that the interpreter works with.
#pragma once
#include <string>

namespace polyturn::channels::sinumerik {

std::string reference_page();

}  // namespace polyturn::channels::sinumerik
