// Stretches of time are told apart by their shape as well as by their colour: in a grey picture,
// and by whoever does not see all colours.
#pragma once
#include "hmi/widgets/sheet.hpp"

namespace polyturn::hmi {

// the lower half; a frame in the middle
enum class TimeShape : std::uint8_t { Full, Half, Hatched, Hollow };
void drawTimeShape(Writer& w, TimeShape shape, const QRectF& bar, const QColor& colour);

}  // namespace polyturn::hmi
