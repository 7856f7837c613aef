// Frames as values: CTRANS, CROT and the like, and their chain by the colon.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Value;

bool chain_frames(Execution& x, Value& left, const Value& right);
bool f_ctrans(Execution& x, Call& call);
bool f_cfine(Execution& x, Call& call);
bool f_cscale(Execution& x, Call& call);
bool f_crot(Execution& x, Call& call);
bool f_cmirror(Execution& x, Call& call);
bool f_crots(Execution& x, Call& call);
bool f_addframe(Execution& x, Call& call);
bool f_crpl(Execution& x, Call& call);
bool f_invframe(Execution& x, Call& call);

}  // namespace polyturn::channels::sinumerik
