// The contour between the blocks P and Q.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/fanuc/cycles/contour_text.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool read_contour(Execution& x, cycles::Contour& contour, ContourText& text);
void after_contour(Execution& x, const ContourText& text);

}  // namespace polyturn::channels::fanuc
