// What the geometry half of the language keeps from block to block: part of a resume state.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::sinumerik {

struct GeoModal {
};

}  // namespace polyturn::channels::sinumerik
