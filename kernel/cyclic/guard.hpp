// Nothing of the machine touches anything else of it: chucks, tailstocks, tool carriers with the tool in work, of all channels,
// watched in every mode (N19xx, N20xx, machine.toml). Bodies are rectangles in the room's plane of X and Z; a carrier's move
// with its axes.
//
//        +-----+   v        braking from now on, each body would rest at the end of its arrow; eight points of both ways are
//        |  A  |--->        looked at. When A and B would then be nearer than PT_GUARD_DISTANCE, and nearer than they are,
//        +-----+  +---+     whoever moves them stops now. Away from each other they may always go.
//                 | B |
//                 +---+     The way of a path bends as it has bent in the last tick.
//
// A turret whose room says where its axis is (stations, reach, direction) carries the tools of its other stations along: they stand
// turned about that axis, seen from the side, and while the turret turns each of them is anywhere on its circle.
//
//        axis o----- reach ---->| tool in work        a box from u to u' outwards of the axis, w wide across: turned by t it covers
//              \                                      u cos t ... u' cos t, and w |sin t| on both sides
//               \ t ---> [tool of the next station]   (across, the width of a tool is taken as its width along Z)
//
// Only the relative way of two bodies counts, so the eight points are found once for a pair, and a box pair adds four subtractions
// to each. Pairs, and boxes of them, that are too far apart for both ways are left out by their outlines.
//
// Cost: eight carriers around one part, all moving, some microseconds (tests/bench/guard_bench.cpp).
#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "ipc/machine/room.hpp"
#include "kernel/cyclic/tool_shapes.hpp"
#include "kernel/cyclic/core.hpp"

namespace polyturn::kernel {

class Guard {
public:
    void take_room(const Room& room, const MachineConfig& machine);            // not in the cyclic thread
    void configure(const params::Table& table, const KernelConfig& config);    // likewise, or at a tick start: allocates nothing
    void take_tools(const ToolShapes& shapes) noexcept { shapes_ = shapes; }   // instead of what the room says of their stations; then configure()
    // What the offset in use takes from the axes of a channel (from 1), by their place in it (machine coordinate less programmed
    // coordinate): where the tip of the tool in work is. A shape of machine.toml that names its tip goes with it; without an offset in use the
    // tool stays as it was known last.
    void take_tool(std::uint32_t channel, const std::array<double, kChannelAxes>& shift) noexcept;
    // Two bodies that would come too near; first is kNone when none do. Before the drives are spoken to.
    struct Finding {
        std::uint32_t first, second;
        double distance = 0;
    };
    static constexpr std::uint32_t kNone = ~0u;
    Finding step(const Core& core) noexcept;
    bool protects(std::uint32_t channel) const noexcept;   // its carrier (N2000)
    // The turret of the channel (from 1) may turn anywhere while its axes drive this much further (mm by machine axis, from 0): nothing
    // that moves or stands comes within PT_GUARD_DISTANCE of the circle of its tools. False where protection is off, where the turret's
    // axis is not known, or where something stands of which nobody knows the place.
    bool circle_is_free(std::uint32_t channel, const std::array<double, kMaxAxes>& way) const noexcept;
    ChannelSet movers(const Core& core, std::uint32_t body) const noexcept;    // channels whose axes carry it
    bool carries(std::uint32_t body, std::uint32_t axis) const noexcept;
    std::string_view name(std::uint32_t body) const noexcept { return {bodies_[body].name.data()}; }
    // Bodies and shapes that there was no room for are not guarded; told once behind each configure(). 0: all are.
    std::size_t unguarded() noexcept { return std::exchange(left_out_, 0); }
    bool any() const noexcept { return body_count_ > 1 && watched_; }
    void publish(GuardStatus& out) const noexcept;

private:
    static constexpr std::size_t kBodies = 64, kBoxes = 1536, kCarriers = 4;
    struct Vector {
        double x = 0, z = 0;
    };
    struct Box {
        double x_low, x_high, z_low, z_high;
        std::uint32_t station;             // in work as it is drawn, else turned with the turret; 0 always
        bool goes = false;                 // with the tip of the tool
        Vector tip{};                      // that it is drawn with
    };
    struct Tool {
        bool known = false;
        Vector tip;                        // from the carrier's point, in the room
    };
    enum class Kind : std::uint8_t { Carrier, Chuck, Tailstock };
    struct Body {
        std::array<char, 32> name{};
        Kind kind = Kind::Carrier;
        std::uint32_t channel = 0;         // a tool carrier's; 0: a chuck, a tailstock
        std::array<std::uint32_t, kCarriers> axis{};   // from 0
        std::array<Vector, kCarriers> way{};
        std::size_t carriers = 0;
        Vector origin;
        std::size_t first = 0, count = 0;  // boxes
        bool in_z = true, by_hand = true, without_tool = true;
        std::uint32_t stations = 0;        // of a turret whose axis is known; 0: tools count only while they are in work
        bool looks_along_x = true;         // its tools point along X of the room, else along Z
        double outwards = 1, axis_at = 0;  // the sign of that, and where the axis is, from the carrier's point
        std::int64_t turned_for = -1;      // station that turned_ holds its boxes for; 0 anywhere, -1 none yet
        // now
        Vector at, velocity, before, rest, bend;
        double way_left = 0;               // mm until it rests
        bool moving = false, watched = false;
        bool known = false;                // its axes are referenced: it stands where it seems to stand
        std::size_t shown = 0, shown_count = 0;   // boxes of now, in the room
        Box outline{};
    };
    struct Relative {                      // way of the second body against the first at the points looked at
        std::array<double, 8> x{}, z{};
    };
    Box* add_box(Body& body, const Box& box);
    Body& add_body(std::string_view name, Kind kind);
    void add_carrier(Body& body, unsigned axis_number);
    void place(const Core& core, Body& body) noexcept;
    void show(const Core& core, Body& body) noexcept;
    static Box turned(const Body& body, const Box& own, double steps, bool anywhere) noexcept;
    void turn_tools(const Core& core, Body& body) noexcept;
    bool off(const Core& core, const Body& a, const Body& b) const noexcept;
    double gaps(const Body& a, const Body& b, double reach, const Relative& way, std::array<double, 8>& then) const noexcept;

    Room room_;
    bool has_room_ = false, watched_ = false;
    MachineConfig machine_;
    ToolShapes shapes_;
    std::array<Body, kBodies> bodies_{};
    Body spare_;                           // takes what there is no room for
    std::array<Box, kBoxes> boxes_{}, shown_{}, turned_{};   // turned_: as boxes_, those of other stations as the turret stands
    std::size_t shown_count_ = 0;
    std::array<std::uint32_t, kMaxChannels> station_{};   // in work
    std::array<Tool, kMaxChannels> tools_{};
    std::size_t body_count_ = 0, box_count_ = 0, left_out_ = 0;
    double distance_ = 1;
    Finding nearest_{kNone, kNone, 0};
};

}  // namespace polyturn::kernel
