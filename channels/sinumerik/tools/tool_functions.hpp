// Tools and edges by name, group and D number.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Tool;

// 0: no edge has this D number
int edge_of_d(const Tool& tool, int d);
bool f_gett(Execution& x, Call& c);
bool f_newt(Execution& x, Call& c);
bool p_delt(Execution& x, Call& c);
bool f_getdno(Execution& x, Call& c);
bool f_setdno(Execution& x, Call& c);
bool p_dzero(Execution& x, Call&);
bool f_chkdno(Execution& x, Call& c);
bool f_chkdm(Execution& x, Call& c);
bool f_getacttd(Execution& x, Call& c);
bool f_deldl(Execution& x, Call& c);
bool f_toolgnt(Execution& x, Call& c);
bool f_toolgt(Execution& x, Call& c);
bool f_getactt(Execution& x, Call& c);
bool p_tca(Execution& x, Call& c);
bool p_tml(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
