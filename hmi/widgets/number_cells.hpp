#pragma once

#include <Qt>

namespace polyturn::hmi {

// where numbers stand in their column, so that their digits are below each other
inline constexpr int kRight = Qt::AlignRight | Qt::AlignVCenter;

}  // namespace polyturn::hmi
