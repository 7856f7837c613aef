// Arithmetic and text functions.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

bool f_abs(Execution&, Call& c);
bool f_sin(Execution&, Call& c);
bool f_cos(Execution&, Call& c);
bool f_tan(Execution& x, Call& c);
bool f_asin(Execution& x, Call& c);
bool f_acos(Execution& x, Call& c);
bool f_atan2(Execution&, Call& c);
bool f_sqrt(Execution& x, Call& c);
bool f_pot(Execution&, Call& c);
bool f_trunc(Execution&, Call& c);
bool f_round(Execution&, Call& c);
bool f_roundup(Execution&, Call& c);
bool f_ln(Execution& x, Call& c);
bool f_exp(Execution& x, Call& c);
bool f_minval(Execution&, Call& c);
bool f_maxval(Execution&, Call& c);
bool f_bound(Execution& x, Call& c);
bool f_isnumber(Execution&, Call& c);
bool f_number(Execution& x, Call& c);
bool f_toupper(Execution&, Call& c);
bool f_tolower(Execution&, Call& c);
bool f_strlen(Execution&, Call& c);
bool f_index(Execution&, Call& c);
bool f_rindex(Execution&, Call& c);
bool f_mindex(Execution&, Call& c);
bool f_match(Execution&, Call& c);
bool f_substr(Execution& x, Call& c);
bool f_sprint(Execution& x, Call& c);
bool f_calcdat(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
