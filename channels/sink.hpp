// Where an interpreted program goes: elementary results in path order, one call each.
//
//   program text -> language -> machine state, cycles, compensation -> Sink
//                                                        check: prints events
//                                                        run:   makes path records and notes
//
// Invariants
//   I1  Calls come in the order in which the machine must execute them.
//   I2  Positions are machine coordinates: mm (X as a radius) and degrees, by the axis' index in
//       its channel (MachineView::axes says which machine axis that is). Programmed positions in
//       addition to them only serve the event.
//   I3  What is passed by reference is good until the call returns.
//   I4  A block without any call before block_end() does not call block_end() either.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "ipc/capacities.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/enums.hpp"

namespace polyturn {
struct Kinematics;
}

namespace polyturn::channels {

using AxisValues = std::array<double, kChannelAxes>;  // by the axis' place in the channel
using AxisSet = std::uint32_t;                        // bit i: axis at place i

enum class MoveKind : std::uint8_t { Rapid, Linear, ArcCw, ArcCcw, Thread, Skip, Reference };
enum class CompSide : std::uint8_t { Off, Left, Right };

// The tool as an event names it. A negative number or edge does not apply.
struct ToolRef {
    std::int64_t number = -1;
    std::int32_t offset = -1;
    std::int32_t edge = -1;
    std::string_view name;
};

// Which block of which text causes it, and what holds while it is made.
struct BlockContext {
    std::uint16_t file = 0;        // index into the runner's program names
    std::uint8_t stack_depth = 0;  // 0 in the main program
    std::uint32_t line = 0;        // from 1
    std::int64_t block = -1;       // block number N; -1 none
    // counts the blocks read since cycle start, from 1 (Language::resume_at)
    std::uint64_t serial = 0;
    std::uint32_t part = 0;  // counts what the block causes (ResumeSink)
    ToolRef tool;
    CompSide comp = CompSide::Off;
    // axes that the program counts the other way than the machine shows them: radius, not diameter
    AxisSet display_swapped = 0;
    std::string_view cycle;  // name of the cycle that makes it; empty none
    bool by_code = false;    // within a program that a code has called (N1338 DSM)
    bool statement = false;  // a macro statement: for single block it is no block
    // index of the axis that runs this by itself, asynchronously (B programs); -1: the path does
    // it
    std::int8_t own_axis = -1;
    // and its moves count from its position when its program begins
    bool own_by_way = false;
};

inline constexpr double kTorqueOfPlc = -1.0;

struct Move {
    MoveKind kind = MoveKind::Rapid;
    FeedMode feed_mode = FeedMode::Rapid;
    bool exact_stop = false;       // G9, G61
    bool in_position = false;      // and wait for the measured position
    bool override_locked = false;  // feed override is 100 %
    bool thread_chained = false;   // goes on from the thread before without a new start angle
    std::uint8_t skip_input = 0;   // Skip: number of the input; 0 it has a name only
    std::string_view skip_name;    // Skip: name of the input (SKIP, XAE) or its number
    bool skip_release = false;     // Skip: ends when the signal goes
    // Skip: where the signal comes is reported, and the move goes on to its end
    bool skip_passes = false;
    // Skip: ends where something resists with so many thousandths of the rated torque; kTorqueOfPlc
    // as the PLC allows; 0 it does not
    double skip_torque = 0.0;
    // machine spindle (from 1) of feed per revolution and thread; 0 none
    std::uint16_t spindle = 0;
    AxisSet moved = 0;                      // axes whose machine coordinate changes
    AxisValues machine_start{}, machine{};  // I2; arcs: the plane axes turn about `centre`
    // as programmed, workpiece system, true mm and radius; see cli.md 3 `pos`
    AxisValues pos{};
    // what compensation of the nose radius has added to the programmed end
    AxisValues nose{};
    double feed = 0.0;  // mm/min (deg/min), mm/rev, 1/min; 0 for rapid
    // way along the path (linear axes; rotary ones when they are alone) in one unit of what the
    // feed counts
    double feed_scale = 1.0;
    double speed_limit = 0.0;  // along the path, mm/min, whatever the feed; 0 none
    // Inner corners are cut slowly: so many mm of the path at its beginning and at its end with
    // this share of the feed.
    double slow_head = 0.0, slow_tail = 0.0, slow_share = 1.0;
    // Arcs. The plane's axes are places in the channel; the others move in proportion to the angle.
    std::uint8_t plane_p = 0, plane_q = 0;          // G18: Z, X
    double centre_p = 0.0, centre_q = 0.0;          // machine coordinates
    double pos_centre_p = 0.0, pos_centre_q = 0.0;  // workpiece system
    double radius = 0.0, radius_end = 0.0;          // they differ by the tolerance at the most
    double sweep = 0.0;      // rad, positive from p to q; more than 2 pi with several turns
    std::int32_t turns = 0;  // full turns beyond the first
    // A curve: machine points that the path passes between start and end, so close together that
    // straight lines between them are the curve. It is one move to whoever reads events; null:
    // none.
    std::shared_ptr<const std::vector<AxisValues>> through;
    // Threads; one on an arc has the arc's members too and a sweep that is not 0
    double lead = 0.0;         // mm along the programmed lead axis, for the event
    double lead_path = 0.0;    // mm along the path
    double lead_change = 0.0;  // mm along the lead axis a revolution
    double start_angle = 0.0;  // deg
    std::int32_t starts = 0;   // 0 not given
    // Way out of the thread when it is held, mm (radius) of the axis at that place; nobody: a hold
    // acts behind the thread.
    std::array<std::int8_t, 3> withdraw_axis{-1, -1, -1};
    std::array<double, 3> withdraw{};
    // Rigid tapping: the positioned spindle turns along with the move
    double tap_turns = 0.0;  // revolutions, positive like M3; 0: it does not
    double tap_rpm = 0.0;    // the programmed speed, 1/min
    // in a floating holder: the feed follows the spindle's measured speed
    bool tap_floats = false;
    bool tap_out = false;          // the way out of the hole
    bool tap_feedforward = false;  // N1503 RFF
    bool offset_alone = false;     // only the tool's offset changes: the contour does not go on
    // a positioning axis: it moves with its own feed, asynchronously, and is not waited for
    // (Wait::Act::Arrive does)
    bool beside = false;
    bool fixed_stop = false;      // Skip: ends where the axes meet something, too
    bool stop_must_come = false;  // and must meet it
    // A transformation is on: the path runs from path_start to path in its coordinates (arcs:
    // centre, radius, sweep as well), machine_start and machine are the axes. Its roles name places
    // in the channel.
    const Kinematics* kinematics = nullptr;
    AxisValues path_start{}, path{};
};

[[nodiscard]] constexpr bool is_arc(const Move& m) {
    return m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw;
}

struct Dwell {
    bool revolutions = false;
    double value = 0.0;  // seconds or revolutions
    std::uint16_t spindle = 0;
    // name of an input that ends it early; lives as long as the program
    std::string_view until;
    bool rest = false;  // it was interrupted, and only what is left of it is waited for
};

struct Aux {
    char letter = 'M';  // M, S, T, H, B ...
    double value = 0.0;
    std::string_view text;  // "M8", "T0303": as the machine sees it
    bool drained = false;   // nothing behind it is read before it has been executed
    bool silent = false;    // for the PLC only, no event: the program did not write it
    // the program does not wait until the PLC has finished it; the next code does
    bool beside = false;
    ToolCallBy by = ToolCallBy::Type;  // T: how it names the tool
    std::string_view name;             // T by name
};

enum class SpindleTurn : std::int8_t { Stop = 0, Cw = 1, Ccw = -1 };
struct Spindle {
    std::uint16_t spindle = 1;  // machine number
    SpindleModeCode mode = SpindleModeCode::Rpm;
    double value = 0.0;  // 1/min, m/min or degrees
    SpindleTurn turn = SpindleTurn::Stop;
    double limit = 0.0;                                    // 1/min; 0 none
    double least = 0.0;                                    // SurfaceSpeed: 1/min; 0 the machine's
    SpindleApproach approach = SpindleApproach::Shortest;  // Position
    double way = 0.0;       // Position, Incremental: degrees; `value` is where it leads
    double feed_rpm = 0.0;  // Position: how fast; 0: in rapid
    // Position: no M code follows that closes the loop; an open one is a mistake
    bool needs_loop = false;
    // Watch: seconds, % to begin with, %, 1/min; NaN: the parameter's
    std::array<double, 4> watch{};
    // Couple: `follower` (a machine axis from 0, or kMaxAxes + spindle from 0) makes `turns` for
    // `master_turns` of `spindle`;
    // `value` 1/min of its own lie over that. Uncouple: it is free again, and `spindle` is the
    // channel's master. cutter: its direction is the sign of `turns`, whichever way the master
    // turns.
    // helix: machine axis whose way turns the follower too
    std::uint8_t follower = 0, helix = kNoHelix;
    double turns = 1.0, master_turns = 1.0, helix_deg_mm = 0.0;
    double phase_deg = std::numeric_limits<double>::quiet_NaN();  // NaN: as it comes
    bool gear = false, cutter = false;
    std::int32_t css_axis = -1;  // SurfaceSpeed: place of the turning axis
    double css_zero = 0.0;       // SurfaceSpeed: machine coordinate of that axis at diameter 0
    bool mode_changed = false, speed_changed = false, turn_changed = false, limit_changed = false;
    bool silent = false;  // a record for the kernel (G96 follows a new zero), no event
    // Rpm: of a follower, which turns like that from its Uncouple on
    bool for_release = false;
    bool beside = false;  // Position: nobody waits (Wait::Act::Arrive does)
};

struct Wait {
    std::int64_t code = 0;
    std::string_view marker;     // a marker name instead of a code; empty none
    std::uint32_t channels = 0;  // bit 0 is channel 1
    bool flying = false;
    // A marker that is set counts as an arrival at its code until it is cleared; whoever sets it
    // goes on (code -1: all). Arrive: the positioning axes of `axes` and the positioned spindles of
    // `spindles` are waited for, no other channel.
    enum class Act : std::uint8_t { Meet, SetMarker, ClearMarker, Arrive } act = Act::Meet;
    AxisSet axes = 0;
    std::uint32_t spindles = 0;  // bit 0 is spindle 1
};

struct Variable {
    std::string_view name;
    double value = 0.0;            // NaN: empty
    std::int32_t persistent = -1;  // index into ChannelStore::variables; -1 it is not kept
    std::uint32_t channel = 0;     // of that store; 0: the own one
    bool is_text = false;          // its value is `text`: a STRING, the name of an axis
    std::string_view text{};
};

struct OffsetWrite {
    std::string_view table;      // geometry, wear, work or the language's own name
    std::string_view axis;       // X, Z, R, T ...
    std::string_view zero_name;  // work: G54
    std::int32_t number = 0;
    std::uint32_t channel = 0;  // whose table; 0: the own one (N1401, N1412: offsets in common)
    OffsetTable store_table = OffsetTable::Geometry;
    OffsetField field = OffsetField::X;
    bool work = false;             // a zero offset: row and place of ChannelStore::zeros
    bool until_power_off = false;  // it is not kept on the disk (mefi G92, G93)
    std::int32_t row = 0, place = 0;
    double value = 0.0;  // as the table shows it (X as a diameter on a diameter axis)
};

// A value of the tool table that the program writes ($TC_..., TLFR): a column of the tool, or of
// its edge the parameter DP.
struct ToolWrite {
    std::int32_t tool = 0;   // data number
    std::string_view field;  // ipc/model/machine/store/tool_fields.hpp; empty: `dp` of `edge`
    std::int32_t edge = 0, dp = 0;
    double value = 0.0;
    std::string_view text;  // of a text column
};

// One step of registering tool life groups (G10 L3 ... G11), in the order of the program:
//   ForgetAll (G10 L3), Forget group, Open group with its life, then its tools in the order in
//   which they are to be used.
struct LifeGroup {
    LifeGroupStep step = LifeGroupStep::Open;
    std::int32_t group = 0;          // all but ForgetAll
    LifeKind kind = LifeKind::Uses;  // Open: Uses or Minutes
    double life = 0.0;               // Open
    std::int32_t station = 0;        // Tool: of the channel's turret
    std::int32_t offset = 0;         // Tool: its offset number
};

// From here on a signal interrupts the program (M96), or no more (M97).
struct Interrupts {
    bool on = false;
    bool at_block_end = false;  // otherwise within the running block
    bool by_level = false;      // again and again while the signal is on; otherwise at its edge
    bool mint = false;          // the signal is MINT, not UINT
    std::uint32_t inputs = 0;   // bit n: INT<n+1>; then no other signal counts
    // and the program's input n+1 itself (#1000 and on, $A_IN[n+1]), wherever it comes from
    bool wires = false;
};

struct DialoguePage;
struct Stop {
    StopReason reason = StopReason::M00;
    const DialoguePage* page = nullptr;  // Dialogue: what is asked
    // false: an M01 whose key was off when it was read; whether it stops is seen when the machine
    // comes to it
    bool asked = true;
};

class Sink {
public:
    virtual ~Sink() = default;
    virtual void move(const Move&, const BlockContext&) = 0;
    virtual void dwell(const Dwell&, const BlockContext&) = 0;
    virtual void aux(const Aux&, const BlockContext&) = 0;
    virtual void spindle(const Spindle&, const BlockContext&) = 0;
    // the runner is then AtBarrier
    virtual void wait(const Wait&, const BlockContext&) = 0;
    virtual void variable(const Variable&, const BlockContext&) = 0;
    virtual void offset(const OffsetWrite&, const BlockContext&) = 0;
    virtual void message(std::string_view text, const BlockContext&) = 0;
    virtual void stop(const Stop&, const BlockContext&) = 0;
    virtual void part(double count, const BlockContext&) = 0;
    virtual void alarm(const Diagnosis&, const BlockContext&) = 0;  // errors end the program
    virtual void interrupts(const Interrupts&, const BlockContext&) {}
    // sent to an external device by the program
    virtual void print(std::string_view, const BlockContext&) {}
    // the program gives a parameter a value: a line of a parameter file
    virtual void parameter(std::string_view /*line*/, const BlockContext&) {}
    // a flag of the channel, in path order
    virtual void signal(std::string_view /*name*/, double /*value*/, const BlockContext&) {}
    virtual void tool_write(const ToolWrite&, const BlockContext&) {}
    virtual void life_group(const LifeGroup&, const BlockContext&) {}
    // everything before must be executed; the runner is AtBarrier
    virtual void barrier(const BlockContext&) = 0;
    virtual void block_end(const BlockContext&) = 0;
};

}  // namespace polyturn::channels
