// What a program can ask about a variable.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool f_getvarlim(Execution& x, Call& c);
bool f_getvardft(Execution& x, Call& c);
bool f_getvarphu(Execution& x, Call& c);
bool f_getvarap(Execution& x, Call& c);
bool f_isvar(Execution& x, Call& c);
bool f_getvartyp(Execution& x, Call& c);
bool f_stringis(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
