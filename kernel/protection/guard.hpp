// Collision protection: no body of the machine touches another one: chucks, tailstocks, tool
// carriers with the tool in work, of all channels, in every mode (N19xx, N20xx, machine.toml).
// Bodies are rectangles in the work area's plane of X and Z; a carrier moves with its axes.
//
//        +-----+   v
//        |  A  |--->        braking from now on, each body would rest at the end of its arrow
//        +-----+  +---+
//                 | B |
//                 +---+
//
// Eight points of both displacements are checked. When A and B would then be nearer than
// PT_GUARD_DISTANCE, and nearer than they are, whoever moves them stops now. Away from each other
// they may always go. The displacement along a path bends as it has bent in the last tick.
//
// The bodies themselves, and how a turret carries the tools of its other stations:
// ipc/model/bodies/room_bodies.hpp.
//
// Only the relative displacement of two bodies counts, so the eight points are found once for a
// pair, and a box pair adds four subtractions to each. Pairs, and boxes of them, that are too far
// apart for both displacements are left out by their outlines.
//
// Cost: eight carriers around one part, all moving, some microseconds
// (tests/bench/guard_bench.cpp).
#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "ipc/model/bodies/room_bodies.hpp"
#include "kernel/tick/core.hpp"
#include "kernel/tools/tool_shapes.hpp"

namespace polyturn::kernel {

class Guard {
public:
    // not in the cyclic thread
    void take_room(const Room& room, const MachineConfig& machine);
    // likewise, or at a tick start: allocates nothing
    void configure(const params::Table& table, const KernelConfig& config);
    // instead of what the machine model says of their stations; then configure()
    void take_tools(const ToolShapes& shapes) noexcept { shapes_ = shapes; }
    // What the offset in use takes from the axes of a channel (from 1), by their index in it
    // (machine coordinate less programmed coordinate): where the tip of the tool in work is. A
    // shape of machine.toml that names its tip goes with it; without an offset in use the tool
    // stays as it was known last.
    void take_tool(std::uint32_t channel, const std::array<double, kChannelAxes>& shift) noexcept;
    // Two bodies that would come too near; first is kNone when none do. Before the drives are
    // spoken to.
    struct Finding {
        std::uint32_t first, second;
        double distance = 0;
    };
    static constexpr std::uint32_t kNone = ~0u;
    Finding step(const Core& core) noexcept;
    bool protects(std::uint32_t channel) const noexcept;  // its carrier (N2000)
    // The turret of the channel (from 1) may turn anywhere while its axes drive this much further
    // (mm by machine axis, from 0): nothing, moving or not, comes within PT_GUARD_DISTANCE of
    // the circle of its tools. False where protection is off, where the turret's axis is not known,
    // or where the position of a body is not known.
    bool circle_is_free(std::uint32_t channel,
                        const std::array<double, kMaxAxes>& way) const noexcept;
    // channels whose axes carry it
    ChannelSet movers(const Core& core, std::uint32_t body) const noexcept;
    bool carries(std::uint32_t body, std::uint32_t axis) const noexcept;
    std::string_view name(std::uint32_t body) const noexcept { return {bodies_[body].name.data()}; }
    // Bodies and shapes beyond the capacity are not guarded; reported once behind each configure().
    // 0: all are.
    std::size_t unguarded() noexcept { return std::exchange(set_.left_out, 0); }
    bool any() const noexcept { return body_count_ > 1 && set_.watched; }
    void publish(GuardStatus& out) const noexcept;

private:
    static constexpr std::size_t kBodies = RoomBodies::kBodies, kBoxes = RoomBodies::kBoxes;
    using Vector = RoomBodies::Vector;
    using Box = RoomBodies::Box;
    using Kind = RoomBodies::Kind;
    struct Tool {
        bool known = false;
        Vector tip;  // from the carrier's point, in the work area
    };
    struct Body : RoomBodies::Body {
        // station that turned_ holds its boxes for; 0 anywhere, -1 none yet
        std::int64_t turned_for = -1;
        // now
        Vector at, velocity, before, rest, bend;
        double travel_left = 0;  // mm until it rests
        bool moving = false, watched = false;
        // its axes are referenced: its position is true
        bool known = false;
        std::size_t shown = 0, shown_count = 0;  // boxes of now, in the work area
        Box outline{};
    };
    // displacement of the second body against the first at the points that are checked
    struct Relative {
        std::array<double, 8> x{}, z{};
    };
    void place(const Core& core, Body& body) noexcept;
    void show(const Core& core, Body& body) noexcept;
    void turn_tools(const Core& core, Body& body) noexcept;
    bool off(const Core& core, const Body& a, const Body& b) const noexcept;
    double gaps(const Body& a, const Body& b, double reach, const Relative& way,
                std::array<double, 8>& then) const noexcept;

    Room room_;
    bool has_room_ = false;
    MachineConfig machine_;
    ToolShapes shapes_;
    std::array<Body, kBodies> bodies_{};
    RoomBodies set_;  // as configured; bodies_ has the same order
    // turned_: as set_.boxes, those of other stations as the turret is turned
    std::array<Box, kBoxes> shown_{}, turned_{};
    std::size_t shown_count_ = 0;
    std::array<std::uint32_t, kMaxChannels> station_{};  // in work
    std::array<Tool, kMaxChannels> tools_{};
    std::size_t body_count_ = 0;
    double distance_ = 1;
    Finding nearest_{kNone, kNone, 0};
};

}  // namespace polyturn::kernel
