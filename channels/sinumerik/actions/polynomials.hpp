// FCTDEF and SYNFCT: polynomials that synchronized actions evaluate.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_fctdef(Execution& x, Call& c);
bool p_synfct(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
