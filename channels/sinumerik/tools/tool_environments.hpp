// TOOLENV, GETTENV, DELTOOLENV: offsets kept under a name.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool f_toolenv(Execution& x, Call& c);
bool f_gettenv(Execution& x, Call& c);
bool f_deltoolenv(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
