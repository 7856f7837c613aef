// What a program asks of the machine. All answers belong to the barrier at which the runner is
// (architecture 5.5): the runner reports AtBarrier, the driver waits until everything before it has
// been executed, then lets it go on; only then are the answers read. In check mode they come from
// setup and from what the program has commanded itself.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "channels/dialogue.hpp"
#include "ipc/capacities.hpp"
#include "ipc/path/stroke_zones.hpp"

namespace polyturn {
struct ToolTable;
struct ToolEdgeTable;
}  // namespace polyturn

namespace polyturn::channels {

struct MachineView;

struct CalendarTime {
    int year = 2000, month = 1, day = 1, hour = 0, minute = 0, second = 0;
};

class Port {
public:
    virtual ~Port() = default;
    // Machine coordinate (mm, X as a radius; degrees) of a machine axis (from 0); nothing: it
    // is where it was commanded.
    virtual std::optional<double> axis_command(unsigned machine_axis) = 0;
    // From where the program goes on behind a barrier: its command too, but nothing for an axis
    // that the program has sent somewhere beside its path and that is not there yet.
    virtual std::optional<double> axis_taken_over(unsigned machine_axis) {
        return axis_command(machine_axis);
    }
    virtual std::optional<double> axis_measured(unsigned machine_axis) = 0;
    // Where it is: measured while something moves it, and where it was brought while it is at
    // standstill (what the loop still lags behind is no position).
    virtual std::optional<double> axis_position(unsigned machine_axis) {
        return axis_measured(machine_axis);
    }
    // What a superimposed master has added to it: neither number above holds it.
    virtual double axis_added(unsigned) { return 0.0; }
    // Where a skip move ended; nothing: the signal did not come, the move went to its end.
    virtual std::optional<double> axis_at_skip(unsigned machine_axis) = 0;
    // Keys of the operator.
    virtual bool block_skip(unsigned number) = 0;  // 1..10
    virtual bool optional_stop() = 0;
    virtual bool single_block() = 0;
    // Interface inputs and outputs of the program (#1000.., #1100..).
    virtual double interface_value(std::int32_t variable) = 0;
    // A value that the setup gives to any other variable of the language; nothing: not given.
    virtual std::optional<double> given_variable(std::string_view name) = 0;
    // Is this input on, the axes standing at `machine` (coordinates of the channel's places)? For
    // inputs of measuring.
    virtual bool measuring_input(std::string_view /*name*/, const MachineView&,
                                 const std::array<double, kChannelAxes>& /*machine*/) {
        return false;
    }
    virtual CalendarTime clock() = 0;
    virtual double running_ms() = 0;  // #3001
    // #3002: how long the cycle start lamp has been lit
    virtual double lamp_ms() = 0;
    // NOZAGC: the X slide is inclined, and what it does shall not move Z.
    virtual bool angular_correction_off() { return false; }
    // What a program sends to an external device (DPRNT, BPRNT): bytes; `control`: signs around a
    // transmission. False: they cannot be kept.
    virtual bool print(const MachineView&, std::string_view /*bytes*/, bool /*control*/) {
        return true;
    }
    // A text of this channel that survives power-off (check mode and runs without a store keep
    // none). False: the disk refuses it.
    virtual bool keep(std::string_view /*name*/, std::string_view /*text*/) { return true; }
    virtual std::string kept(std::string_view /*name*/) { return {}; }
    // Where check mode keeps the variables that all channels share (MachineView::shared); nullptr:
    // in the view.
    virtual double* shared_variables() { return nullptr; }
    // CP_SGOEN and CP_SGOX, Y, Z: the second geometry offset acts on this axis (0 X, 1 Y, 2 Z).
    virtual bool second_geometry(unsigned /*axis*/) { return false; }
    // The second travel limits act (fagor ACTLIM2).
    virtual bool second_limits() { return false; }
    // What the PLC says now about the stroke ranges of a machine axis: the set it selects, ranges
    // it has switched off. It has its reference point.
    virtual bool axis_referenced(unsigned /*machine_axis*/) { return true; }
    virtual StrokeFlags stroke_flags(unsigned machine_axis) = 0;
    // The operator's overrides as of the last barrier, 1 is 100 %, and what a spindle turns at,
    // 1/min; nothing: nobody drives.
    virtual double feed_override() { return 1.0; }
    virtual double spindle_override(unsigned /*spindle*/) { return 1.0; }
    virtual std::optional<double> spindle_speed(unsigned /*spindle*/) { return std::nullopt; }
    // its speed with the sign of its direction
    virtual std::optional<double> spindle_turns(unsigned /*spindle*/) { return std::nullopt; }
    // Machine spindle that the PLC has chosen for this channel (CP_SSEL); 0: it has chosen none.
    virtual unsigned selected_spindle() { return 0; }
    // Machine axis (from 1) that this one (from 0) follows synchronously now; 0: it moves by
    // itself.
    virtual unsigned synchronous_master(unsigned /*machine_axis*/) { return 0; }
    // AP_DIARAD: a diameter axis is programmed and shown in radii now, a radius axis in diameters.
    virtual bool diameter_inverted(unsigned /*machine_axis*/) { return false; }
    // The tool that works, as tool management has answered: a turret's since its T has been
    // executed (which must be drained), a spindle's since the tool change; -1: the program is only
    // interpreted, nobody knows. Nothing: check mode.
    struct ToolAtWork {
        std::int32_t number = 0;                     // data number; 0: an empty place
        std::int32_t offset = 0, radius_offset = 0;  // its cells in the offset table
    };
    virtual std::optional<ToolAtWork> tool_at_work() { return std::nullopt; }
    // The tools of the store as of the last barrier; null: no tool management, or check mode.
    virtual const ToolTable* tool_table() { return nullptr; }
    virtual const ToolEdgeTable* tool_edges() { return nullptr; }
    // What the operator has answered to the dialogue at whose barrier the program waits.
    virtual DialogueAnswers dialogue_answers() { return {}; }
    // This program cuts per revolution on a spindle that it has not started itself. Has somebody
    // else?
    // Watched: the kernel sees to it, nothing to say here
    enum class Turning : unsigned char { No, Unknown, Watched };
    virtual Turning started_by_others(unsigned spindle) = 0;
    // An alarm that the program raises itself by what it has read of the machine. False: only the
    // machine knows whether it would.
    virtual bool program_alarm_is_sure() { return true; }
};

}  // namespace polyturn::channels
