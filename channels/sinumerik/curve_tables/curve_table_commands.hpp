// CTABDEF, CTABEND and the functions that read curve tables.
#pragma once
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool p_ctabdef(Execution& x, Call& c);
bool curve_point(Execution& x, const AxisValues& target);
bool p_ctabend(Execution& x, Call&);
bool p_ctab_each(Execution& x, Call& c);
bool f_ctab(Execution& x, Call& c);
bool f_ctabinv(Execution& x, Call& c);
bool f_ctabssv(Execution& x, Call& c);
bool f_ctabsev(Execution& x, Call& c);
bool f_ctabtsv(Execution& x, Call& c);
bool f_ctabtsp(Execution& x, Call& c);
bool f_ctabtev(Execution& x, Call& c);
bool f_ctabtep(Execution& x, Call& c);
bool f_ctabtmin(Execution& x, Call& c);
bool f_ctabtmax(Execution& x, Call& c);
bool f_ctabexists(Execution& x, Call& c);
bool f_ctabislock(Execution& x, Call& c);
bool f_ctabmemtyp(Execution& x, Call& c);
bool f_ctabperiod(Execution& x, Call& c);
bool f_ctabsegid(Execution& x, Call& c);
bool f_ctabpolid(Execution& x, Call& c);
bool f_ctabid(Execution& x, Call& c);
bool f_ctabno(Execution& x, Call& c);
bool f_ctabnomem(Execution& x, Call& c);
bool f_ctabfno(Execution& x, Call& c);
bool f_ctabseg(Execution& x, Call& c);
bool f_ctabfseg(Execution& x, Call& c);
bool f_ctabmseg(Execution& x, Call& c);
bool f_ctabpol(Execution& x, Call& c);
bool f_ctabfpol(Execution& x, Call& c);
bool f_ctabmpol(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
