// The contour between the blocks P and Q.
//
// It is read by a second Execution with the state of the first and a recorder for a sink:
// variables, arcs, axis words and diagnoses are those of the language, and nothing of it leaves a
// trace. G70 drives the blocks themselves.
#pragma once
#include "channels/cycles/contour.hpp"
#include "channels/fanuc/cycles/contour_text.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

bool read_contour(Execution& x, cycles::Contour& contour, ContourText& text);
void after_contour(Execution& x, const ContourText& text);

}  // namespace polyturn::channels::fanuc
