// Synchronized actions of the channel, and what they have brought about that is still to be done:
// overlays to be driven, a way to be deleted. Polynomials of FCTDEF are theirs too.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "channels/sinumerik/actions/synchronized_action.hpp"

namespace polyturn::channels::sinumerik {

struct Overlay {
    std::size_t place = 0;
    double mm = 0.0;
};

struct Polynomial {
    double low = 0, high = 0;
    std::array<double, 4> factors{};
};

struct ActionState {
    std::vector<SynchronizedAction> all;  // in the order in which they were programmed
    bool in_action = false;               // one is being read or done
    std::vector<Overlay> overlays;  // $AA_OFF written by what is being done, still to be driven
    bool travel_deleted = false;    // the way of this block: DELDTG is due before it begins
    std::map<int, Polynomial> polynomials;
};

}  // namespace polyturn::channels::sinumerik
