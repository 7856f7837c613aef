// Axes and spindles by their names: in words, in arguments, in functions.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;

// place, kSpindleAxis + n, or -1
int find_axis(const Execution& x, std::string_view name);
std::string axis_name(const Execution& x, int place);
bool f_axname(Execution& x, Call& c);
bool f_axstring(Execution& x, Call& c);
bool f_isaxis(Execution& x, Call& c);
bool f_spi(Execution& x, Call& c);
bool f_axtospi(Execution& x, Call& c);
bool f_modaxval(Execution& x, Call& c);
bool axis_argument(Execution& x, Call& c, std::size_t k, std::string_view name, std::size_t& place);
// each argument is an axis
bool axes_only(Execution& x, const Call& c);

}  // namespace polyturn::channels::sinumerik
