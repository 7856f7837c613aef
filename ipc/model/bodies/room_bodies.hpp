// The bodies of a machine that must not touch each other, from machine.toml (room.hpp), the
// outlines of tools and N19xx, N20xx: tool carriers, chucks, tailstocks. Rectangles in the room's
// plane of X and Z. Protection (kernel/protection/guard.hpp) guards them, the HMI draws them; both
// take them from here, so that the picture is what is guarded.
//
// A turret whose model says where its axis is (stations, reach, direction) carries the tools of its
// other stations along: they stand turned about that axis, seen from the side, and while the turret
// turns each of them is anywhere on its circle.
//
//        axis o----- reach ---->| tool in work
//              '. t
//                '. ---> [tool of the next station]
//
// A box from u to u' outwards of the axis, w wide across: turned by t it covers u cos t to
// u' cos t, and w |sin t| on both sides (across, the width of a tool is taken as its width along
// Z).
//
// Configuring allocates nothing: it happens at a tick start too.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/bodies/tool_shapes.hpp"

namespace polyturn {

// What the parameters say of channels and axes, from whichever form of them is at hand. By number
// less one.
struct BodyFacts {
    std::array<bool, kMaxChannels> channel{}, inch{};
    // from 1; 0: of none, or there is no such axis
    std::array<std::uint32_t, kMaxAxes> axis_channel{};
    std::array<bool, kMaxAxes> rotary{};
};
BodyFacts body_facts(const MachineConfig& machine);

class RoomBodies {
public:
    static constexpr std::size_t kBodies = 64, kBoxes = 1536, kCarriers = 4;
    struct Vector {
        double x = 0, z = 0;
    };
    struct Box {
        double x_low, x_high, z_low, z_high;
        // in work as it is drawn, else turned with the turret; 0 always
        std::uint32_t station;
        bool goes = false;  // with the tip of the tool
        Vector tip{};       // that it is drawn with
    };
    enum class Kind : std::uint8_t { Carrier, Chuck, Tailstock };
    struct Body {
        std::array<char, 32> name{};
        Kind kind = Kind::Carrier;
        std::uint32_t channel = 0;  // a tool carrier's; 0: a chuck, a tailstock
        // whose barriers (N1900 to N1914) these are; 0: they stand in machine.toml
        std::uint32_t of_channel = 0;
        std::uint32_t number = 0;                     // of the channel, spindle or tailstock
        std::array<std::uint32_t, kCarriers> axis{};  // from 0
        std::array<Vector, kCarriers> way{};
        std::size_t carriers = 0;
        Vector origin;
        std::size_t first = 0, count = 0;  // boxes
        bool guarded = true;               // false: only drawn
        bool in_z = true, by_hand = true, without_tool = true;
        // of a turret whose axis is known; 0: tools count only while they are in work
        std::uint32_t stations = 0;
        bool looks_along_x = true;  // its tools point along X of the work area, else along Z
        // the sign of that, and where the axis is, from the carrier's point
        double outwards = 1, axis_at = 0;
        double reach = 0;  // from there to the seats
    };
    // Of the carrier of a channel: what turns with it now.
    struct Turret {
        std::uint32_t station = 0;    // in work
        std::uint32_t stands_at = 1;  // that the turret shows
        // it is turning: its tools are anywhere on their circle
        bool turns = false;
        bool tip_known = false;
        // of the tool in work, from the carrier's point, in the work area
        Vector tip;
    };

    // `all`: also what nothing guards, for pictures; else no more than the barriers when no carrier
    // is guarded.
    void configure(const Room& room, const params::Table& table, const BodyFacts& facts,
                   const ToolShapes& shapes, bool all) noexcept;
    // Where a body's point is at these positions of the machine's axes (from 0; mm, X as a radius).
    static Vector point(const Body& body, const double* axes) noexcept;
    // A box at its present position; false: it does not count (a tool that is not in work, of a
    // turret whose axis is not known).
    static bool placed(const Body& body, const Box& own, Vector at, const Turret& turret,
                       Box& out) noexcept;
    // Of a station that is `steps` away from the one in work; anywhere: on its whole circle.
    static Box turned(const Body& body, const Box& own, double steps, bool anywhere) noexcept;

    std::array<Body, kBodies> bodies{};
    std::array<Box, kBoxes> boxes{};
    // left_out: bodies and shapes that there was no room for
    std::size_t body_count = 0, box_count = 0, left_out = 0;
    bool watched = false;  // some carrier is guarded

private:
    Box* add_box(Body& body, const Box& box) noexcept;
    Body& add_body(std::string_view name, Kind kind, std::uint32_t number) noexcept;
    void add_carrier(Body& body, const Room& room, const BodyFacts& facts,
                     unsigned axis_number) noexcept;
    void add_tool_carrier(unsigned channel, bool guarded, const Room& room,
                          const params::Table& table, const BodyFacts& facts,
                          const ToolShapes& shapes, double unit) noexcept;
    void add_barriers(unsigned channel, const Room& room, const params::Table& table,
                      const BodyFacts& facts, double unit) noexcept;

    Body spare_;  // takes what there is no room for
};

// Where the tip of a tool is, from its carrier's point: `shift` by place in the channel, what the
// offset in use takes from the axes (machine coordinate less programmed coordinate). The room's
// axes are axes of motion; rotary ones do not count.
RoomBodies::Vector tip_of(const Room& room, const MachineConfig& machine, unsigned channel,
                          const std::array<double, kChannelAxes>& shift) noexcept;

}  // namespace polyturn
