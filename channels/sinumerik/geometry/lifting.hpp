// Ways away from the contour: of a held thread, of an interrupted block.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>

#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct Word;

using LeaveBy = std::function<void(std::size_t place, double by)>;
// LFTXT: of a thread, of an interrupted contour
enum class LiftSide : std::uint8_t { AgainstInfeed, FromEdge };

bool lift_from_contour(Execution& x, const AxisValues& begin);
// LFPOS
void lift_to_positions(const Execution& x, const LeaveBy& leave);
bool lift_in_plane(Execution& x, std::size_t along, double on, LiftSide side, const LeaveBy& leave);
bool a_lift_position(Execution& x, const Word& word);
bool p_lift_axes(Execution& x, Call& c);

}  // namespace polyturn::channels::sinumerik
