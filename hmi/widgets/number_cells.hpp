#pragma once

#include <Qt>

namespace polyturn::hmi {

inline constexpr int kRight = Qt::AlignRight | Qt::AlignVCenter;   // where numbers stand in their column, so that their digits are below each other

}  // namespace polyturn::hmi
