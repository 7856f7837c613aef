// The effective stroke ranges of all channels at this tick (ipc/path/stroke_zones.hpp), and what
// they mean for motion: where a record must end, how far an axis may be moved by hand.
//
// An axis counts only while it is referenced and attached. What the PLC selects acts with its
// signal; a record that was planned before is planned again when the path rests, or braked at once
// when it runs out (Machine::run_axes).
#pragma once
#include <array>
#include <cstdint>

#include "ipc/path/path_geometry.hpp"
#include "ipc/path/stroke_zones.hpp"
#include "kernel/config/kernel_config.hpp"

namespace polyturn::kernel {

struct Core;

class StrokeGuard {
public:
    void configure(const KernelConfig& config) noexcept;  // which axes belong to which channel
    void update(const Core& core) noexcept;               // once a tick, before the channels run
    // Grows when something that holds for the channel (from 0) has changed; so has what its axes
    // may do once one has its reference.
    std::uint64_t version(unsigned channel) const noexcept { return channels_[channel].version; }

    // Positions of a channel's axes while records are planned: in the order of its zones.
    using Places = std::array<double, kChannelAxes>;
    void places_now(const Core& core, unsigned channel, Places& places) const noexcept;
    // Where along the record the path must stop; infinity: it may be driven to its end. `places`
    // goes to that end.
    double exit_of(unsigned channel, const PathRecord& record, const Kinematics* kinematics,
                   Places& places, StrokeFault& fault) const noexcept;
    // from 0
    std::uint32_t axis_of(unsigned channel, unsigned place) const noexcept {
        return channels_[channel].axis[place];
    }

    // Free travel of an axis (from 0) in a direction from its present command; `other` of the same
    // channel goes `share` of it as well.
    double room(const Core& core, std::uint32_t axis, double sign, std::uint32_t other = kMaxAxes,
                double share = 0) const noexcept;
    // Directions closed to it at its target: bit 0 positive, bit 1 negative.
    std::uint32_t closed_sides(const Core& core, std::uint32_t axis) const noexcept;
    // nullptr: an axis of no channel
    const AxisZone* zone(const Core& core, std::uint32_t axis) const noexcept;

private:
    struct Channel {
        StrokeZones zones;
        std::array<std::uint32_t, kChannelAxes> axis{};
        // Travel that superimposed masters have added: a record's positions do not contain it (nct
        // part 2, 22.5). While it grows the end of a record that is planned now is not known;
        // guard_stroke() watches that axis.
        std::array<double, kChannelAxes> added{};
        std::uint32_t growing = 0;     // bit i: added[i] has changed with this tick
        std::uint32_t referenced = 0;  // bit i: axis[i] is
        bool limited = false;
        std::uint64_t version = 1;
    };
    std::array<Channel, kMaxChannels> channels_{};
    std::array<std::int16_t, kMaxAxes> place_{};
};

}  // namespace polyturn::kernel
