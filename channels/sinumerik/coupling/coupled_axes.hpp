// TRAILON, LEADON: axes that follow the way of another one.
#pragma once
#include <cstddef>
#include <vector>

#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Trail;

bool p_trail(Execution& x, Call& c);
bool leads_itself(const Execution& x, std::size_t follows, std::size_t leads);
bool is_coupled(const Execution& x, int table);
AxisValues trailed(const Execution& x, AxisValues target);
bool bends_on_the_way(Execution& x, const AxisValues& wanted, std::vector<AxisValues>& bends);
const Trail* leads(const Execution& x, const AxisValues& target);
bool leads_nobody(Execution& x, const AxisValues& target);

}  // namespace polyturn::channels::sinumerik
