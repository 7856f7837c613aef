// The machine as one channel's program sees it: its axes under their names, what the parameters
// say, and what the store holds for it. Made at cycle start, renewed at barriers; the interpreter
// writes into `store` what its program writes, so that it sees its own values at once (architecture
// 5.4).
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "channels/sink.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/table.hpp"
#include "ipc/path/stroke_zones.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::channels {

struct ChannelAxis {
    std::string name;               // its own copy: a view can be moved
    std::uint8_t machine_axis = 0;  // from 0: whose drive the address has now
    std::uint8_t home_axis = 0;     // from 0: its own one
    bool negated = false;           // exchanged, and the two move opposite ways (N2105 MMI)
    bool mirrored = false;          // exchanged, and programmed for the virtual side (N2105 MCO)
    bool counts_on = false;         // has a factor: rolls over no more while it has it
    double mirror_at = 0.0;         // address coordinate of the workpiece zero, kept by Core
    bool turned_round() const { return negated || mirrored; }
    bool reversed() const { return negated != mirrored; }
    double to_drive(double address) const {
        const double side = mirrored ? 2.0 * mirror_at - address : address;
        return negated ? -side : side;
    }
    double from_drive(double drive) const {
        const double side = negated ? -drive : drive;
        return mirrored ? 2.0 * mirror_at - side : side;
    }
    PlaneRole role = PlaneRole::None;
    bool diameter = false, rotary = false, hypothetical = false;
    // what a tool offset of the axis is in its table, whatever programs and displays count in
    // (F5004 #1)
    bool offset_diameter = false;
    // it is a rotary axis, though a transformation may have it count millimetres (rotary is false
    // then)
    bool turns = false;
    bool rolls_over = false;  // likewise
    bool named_y = false;     // and is programmed as Y
    bool rollover = false, rollover_shortest = false, rollover_sign_is_direction = false,
         rollover_reduces_increments = false;
    double rollover_deg = 360.0;
    double increment = 0.001;      // smallest step that can be programmed, mm (metric) or degrees
    double max_feed_mm_min = 0.0;  // N0305
    double rapid_mm_min = 0.0;     // N0304
    std::array<double, 4> reference_mm{};
    // the PLC may switch between radius and diameter (N0106 MGD = 0)
    bool by_plc = true;
    bool inverted = false;   // AP_DIARAD as of the last barrier
    AxisStroke stroke;       // ranges that are watched
    bool referenced = true;  // as of the last barrier
    // an interval holds for this axis by itself, as of the last barrier:
    bool limited = false;
    double limit_max = 0.0, limit_min = 0.0;
};

struct MachineView {
    unsigned channel = 1;
    MachineConfig machine;
    std::unique_ptr<params::Table> parameters;
    std::unique_ptr<ChannelStore> store;
    std::array<ChannelAxis, kChannelAxes> axes;
    unsigned axis_count = 0;
    // stays where it is when the view is moved
    std::unique_ptr<std::array<std::array<char, 4>, kChannelAxes>> names;
    ChannelStroke stroke;
    // Variables that all channels share, as of the last barrier: #100.. and #500.. by number less
    // 100. NaN is empty.
    std::unique_ptr<std::array<double, 900>> shared;
    // axes that only programs of their own move, which other channels may have as well (fanuc F8250
    // = 3)
    AxisSet own_programs = 0;
    AxisValues start{};             // machine coordinates at cycle start; X as a radius
    bool tables_in_radius = false;  // zero offsets of diameter axes are kept as radii (fagor)

    const ChannelConfig& config() const { return machine.channel(channel); }
    const params::Table& table() const { return *parameters; }
    int axis_by_role(PlaneRole role) const;         // place; -1 none
    int axis_by_name(std::string_view name) const;  // place; -1 none
    // True millimetres from what a screen or a table of zeros shows on that axis.
    double from_shown(unsigned place, double value) const {
        return axes[place].diameter ? value * 0.5 : value;
    }
    double from_table(unsigned place, double value) const {
        return tables_in_radius ? value : from_shown(place, value);
    }
    double to_shown(unsigned place, double value) const {
        return axes[place].diameter ? value * 2.0 : value;
    }
    // Tool offsets of the tables.
    double from_offset(unsigned place, double value) const {
        return axes[place].offset_diameter ? value * 0.5 : value;
    }
    double to_offset(unsigned place, double value) const {
        return axes[place].offset_diameter ? value * 2.0 : value;
    }
};

// N1401, N1412: how many offsets, from number 1 on, all channels of this one's kind have in common,
// and in whose table.
struct CommonOffsets {
    unsigned count = 0, channel = 0;
};
CommonOffsets common_offsets(const MachineView& view);
void take_common_offsets(ChannelStore& store, const ChannelStore& from,
                         const CommonOffsets& common);

// `channel` must exist in the machine (config().exists()); the store begins empty: zeros, variables
// null.
// Which drives are behind the addresses: `route` by machine axis (from 0), 0 its own, else that
// axis (from 1) in its place. True: something has changed.
bool take_routes(MachineView& view, std::span<const std::uint8_t> route);
MachineView make_machine_view(const params::Table& table, unsigned channel);
// An axis of another channel (number from 1) gets the next place. False: there is none left.
bool add_axis(MachineView& view, unsigned number);
void clear_store(ChannelStore& store);

}  // namespace polyturn::channels
