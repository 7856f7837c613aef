// Switches and keys of a channel, as the operator has set them and as they act.
#pragma once
#include <cstdint>

#include "ipc/image/enums.hpp"

namespace polyturn::kernel {

struct OperatorPanel {
    // of an axis' limits, that a path leaves to a superposed handwheel
    static constexpr double kOverlayShare = 0.2;

    double feed_override = 1, rapid_override = 1;  // as the switches are set
    std::uint32_t pressed = 0;                     // ChannelKey, by the operator
    // ChannelKey as they act: the operator's and those that the PLC's marks hold
    std::uint32_t keys = 0;
    std::uint32_t start_missing = 0;  // ChannelStatus::start_missing

    bool has(std::uint32_t key) const noexcept { return (keys & key) != 0; }
    bool superposes() const noexcept { return (pressed & kKeySuperpose) != 0; }
};

}  // namespace polyturn::kernel
