// The places of the channel's axes by the letter that programs use for them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "channels/machine_view.hpp"

namespace polyturn::channels::fagor {

class AxisPlaces {
public:
    explicit AxisPlaces(const MachineView& view);
    // -1: the channel has no such axis, or the letter is 0.
    int of(char letter) const {
        return letter ? of_letter_[static_cast<std::size_t>(letter - 'A')] : -1;
    }

private:
    std::array<std::int8_t, 26> of_letter_{};
};

}  // namespace polyturn::channels::fagor
