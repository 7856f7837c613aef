// The state of a channel's program and its changes word by word: positions, zeros, offsets, feed,
// spindle. Every language translates into calls of this class; nothing in here knows a G code
// (architecture 5.12).
//
//   machine = frame(programmed) + zero + shift + vector (+ whole turns of a roll-over axis)
//
//   programmed  in the active workpiece system, X as a radius
//   frame       programmable: translation, rotation, scale, mirror (frame.hpp; none: programmed
//               itself). frame(programmed) is what `pos` of an event shows. Tool offsets lie
//               outside of it: neither mirrored nor turned.
//   zero        external, G54.., G92/G50, G52: changing it moves nothing, the programmed position
//               becomes another number
//   shift       tool offset that acts as a shift of the system (fanuc geometry with LGT=0, nct):
//               likewise
//   vector      tool offset that is travelled (wear): `wanted` by the last T, taken over by the
//               next move
//
// Invariants
//   I1  The equation above holds for every axis of the channel between two calls. A frame, a zero
//   or a shift that changes
//       moves nothing: machine stays, programmed becomes the number that belongs to it.
//   I2  A call that returns false has changed nothing and put the reason into fault().
//   I3  No call allocates, except to report a fault.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "channels/compensation/options.hpp"
#include "channels/corners/corner_stage.hpp"
#include "channels/machine_view.hpp"
#include "channels/port.hpp"
#include "channels/sink.hpp"
#include "channels/state/fixture.hpp"
#include "channels/state/frame.hpp"
#include "channels/state/transformation.hpp"
#include "channels/state/work_zone.hpp"
#include "channels/state/zero_rows.hpp"

namespace polyturn::channels {

enum class Plane : std::uint8_t { XY, ZX, YZ };  // G17 G18 G19: first axis, second axis

namespace compensation {
class Compensator;
}
class FactorSink;
class InclinedSink;
class RouteSink;
class TransformSink;

// Why something cannot be done. `letter` names the word to point at; 0: the block.
struct Fault {
    Alarm alarm{};
    char letter = 0;
    double value0 = 0.0, value1 = 0.0;
    std::string detail;
    // it lies in this other block; nothing: in the block being interpreted
    std::optional<BlockContext> block;
    std::uint32_t column = 0, length = 0;  // in that block, when known
};

struct ToolState {
    ToolRef ref;
    std::int32_t geometry = 0, wear = 0;  // offset numbers in use; 0 none
    double nose_radius = 0.0;
    // mm that the nose stays off the contour in addition to its radius (OFFN); not part of the tip
    double allowance = 0.0;
    std::int32_t tip = 0;
    bool nose_off = false;  // offset number 0: compensation waits for another one
};

struct SpindleState {
    std::uint16_t spindle = 0;  // machine number; 0 none
    SpindleModeCode mode = SpindleModeCode::Rpm;
    SpindleTurn turn = SpindleTurn::Stop;
    bool commanded = false;      // this program has commanded it at all
    double rpm = 0.0;            // last S in G97
    double surface_m_min = 0.0;  // last S in G96
    double limit_rpm = 0.0;      // 0: none
    double least_rpm = 0.0;      // of surface speed; 0: the machine's
    double angle_deg = 0.0;      // of a positioned spindle
};

// A spindle that was last given its speed by name; feed per revolution and surface speed stay with
// the channel's own.
struct NamedSpindle {
    // 0: none, M3 and its fellows mean the channel's spindle
    std::uint16_t spindle = 0;
    double rpm = 0.0;
    SpindleTurn turn = SpindleTurn::Stop;
};

// Which axes the feed counts, when they are not the linear ones.
struct FeedPath {
    // false: the linear axes, and the rotary ones where they move alone
    bool active = false;
    AxisSet counted = 0;
    AxisValues weight{};        // mm that a millimetre or degree of the axis counts
    AxisValues limit_mm_min{};  // speed of the axis that the path must keep; 0 none
    double scale = 1.0;         // programmed override of the feed
    double rapid_scale = 1.0;   // and of rapid, 1 at the most
    // rotary axes whose feed is one of degrees where no counted linear axis moves,
    AxisSet degrees = 0;
    // though the feed was said in units of so many millimetres
    double degree_unit = 1.0;
    // fanuc, nct: what a degree counts where linear axes move along; 0: the linear axes alone count
    double degree_mm = 0.0;
};

// All of it, plain: a resume state is a copy.
struct PathState {
    AxisValues programmed{}, machine{};
    AxisValues shift{}, vector{}, wanted{};
    AxisValues zero{};  // sum of the following
    AxisValues external{}, work{}, preset{}, local{};
    AxisValues turns_deg{};               // whole turns of roll-over axes
    std::int32_t zero_row = kZeroG54Row;  // row of ChannelStore::zeros
    bool framed = false;                  // `frame` is more than nothing; inverse belongs to it
    Frame frame, inverse;
    bool factored = false;  // some axes have a factor that acts behind compensation
    AxisValues factor{};    // by axis index, while there is one; `frame` has them too
    FixtureOffset fixture;  // its vector is in `shift`
    // machine and programmed are coordinates of its path while it is on
    Transformation transformation;
    FeedMode feed_mode = FeedMode::PerMinute;
    double feed = 0.0;  // mm/min, mm/rev
    FeedPath feed_path;
    // index of the axis of constant surface speed; -1 the machine's
    std::int32_t surface_axis = -1;
    Plane plane = Plane::ZX;
    // indices of a plane of any two axes (fagor G16); -1: by `plane`
    std::int8_t plane_p = -1, plane_q = -1;
    bool exact_stop_mode = false, override_locked = false;
    bool exact_stop_off = false;    // no exact stop whatever is programmed (#3004)
    bool stroke2_off = false;       // G23: stroke range 2 does not count
    std::array<WorkZone, 5> zones;  // guarded before each move
    // of the axes themselves (fagor LIMPL, LIMMI); guarded while the PLC wants them
    WorkZone second_limits;
    bool after_thread = false;  // the move before was a thread: a further one chains
    double thread_lead = 0.0;
    // sign of the last movement of each axis; 0: none yet
    std::array<std::int8_t, kChannelAxes> last_travel{};
    // rigid tapping is on: mm a revolution, positive: right-hand; 0 off
    double tap_pitch = 0.0;
    std::uint8_t tap_axis = 0;    // index of the axis that goes into the hole
    double tap_depth_sign = 1.0;  // its direction into the hole
    bool tap_feedforward = false, tap_own_acceleration_out = false;
    bool tap_floats = false;  // a tap in a floating holder is on
    ToolState tool;
    SpindleState spindle;
    NamedSpindle named;
};

struct ArcCall {
    bool clockwise = true;  // seen against the third axis: G2
    bool has_radius = false;
    double radius = 0.0;                    // true mm; negative: more than half a turn
    double centre_p = 0.0, centre_q = 0.0;  // workpiece system, when not has_radius
    std::int32_t turns = 0;
    double tolerance = 0.02;
};

// The difference of programmed point and machine, except for the tool: to suspend it for a block
// (G53) and restore it.
struct Zeros {
    AxisValues external{}, work{}, preset{}, local{};
    Frame frame;
};

struct ThreadCall {
    double lead = 0.0;         // mm along the axis that travels most
    double lead_change = 0.0;  // mm a revolution
    double start_angle = 0.0;  // deg
    std::int32_t starts = 0;
    bool by_axis = false;  // lead counts along `axis`, not along the longest
    std::uint8_t axis = 0;
    // Retract when the thread is held, as Move has it. Not given: PT_THREAD_RETRACT against the
    // last infeed.
    std::array<std::int8_t, 3> withdraw_axis{-1, -1, -1};
    std::array<double, 3> withdraw{};
    // what is given here counts, PT_THREAD_RETRACT does not: nothing given, no retract
    bool own_withdrawal = false;
    const ArcCall* arc = nullptr;  // on an arc, by its centre
};

class Core {
public:
    Core(MachineView& view, Sink& sink, Port& port);
    ~Core();

    PathState path;
    BlockContext at;  // filled by the language for each block
    // What absolute positions on screens contain in addition to what is programmed. A tool offset
    // that shifts coordinates is no part of them.
    struct Shows {
        bool tool_vector = false;  // the tool offset that is travelled
        bool nose = true;          // what nose-radius compensation adds
    } shows;
    MachineView& view() { return *view_; }
    const MachineView& view() const { return *view_; }
    Sink& sink() { return *sink_; }
    Port& port() { return *port_; }
    const Fault& fault() const { return fault_; }
    bool fail(Alarm alarm, char letter = 0, std::string detail = {}, double v0 = 0.0,
              double v1 = 0.0);
    // An alarm of the program's own (#3000, ERROR, SETAL): a fault, unless only the machine can
    // decide whether it would come; then that is reported, and the program goes on behind it.
    bool program_alarm(const std::string& text, double number);
    void set_fault(Fault fault) { fault_ = std::move(fault); }
    bool emitted() const { return emitted_; }  // something was delivered since begin_block()
    void begin_block() { emitted_ = false; }
    void end_block() {
        if (emitted_) sink_->block_end(at);
    }
    void mark_emitted() { emitted_ = true; }
    std::uint64_t moves() const { return moves_; }  // delivered so far
    // asked for so far, those of no length too: what a modal call counts
    std::uint64_t ways() const { return ways_; }

    // --- positions
    void start_at_machine(const AxisValues& machine);
    // drives: the point moves with the axes, and what is programmed from it
    void displaced(const AxisValues& by);
    // after a barrier: where the axis really is
    void take_machine(unsigned place, double drive);
    // Offsets or zeros have other values now. `load` brings the tool's into shift and wanted; the
    // programmed point stays what it is, so the machine coordinate of the point becomes another
    // one. Where the axes are is not considered.
    template <class Load>
    void change_offsets(Load&& load) {
        const AxisValues programmed = path.programmed, before = chain_offset();
        const bool pending = vector_pending();
        load_zeros();
        load();
        if (!pending) take_wanted();
        follow_offsets(programmed, before);
    }
    // at barriers: stroke limits and routes that hold now
    void refresh_limits();
    AxisSet plane_axes(int& p, int& q) const;  // indices of the plane's axes; -1 missing

    // --- transformations: switched while the axes rest and the interpreter waits at a barrier;
    // nothing moves. Centres are filled in here: where the programmed coordinates are 0.
    bool transform(const Transformation& transformation);
    void transform_off();
    bool transformed() const { return path.transformation.active(); }
    void transformation_restored();  // path was put back: the view follows
    // a move could not be made; fault() says why
    bool transformation_failed();

    // --- zeros and offsets: nothing moves
    // from the store: external and the active row
    void load_zeros();
    void select_zero(std::int32_t row);
    // the present point gets this coordinate (G92, G50)
    void preset(unsigned place, double programmed);
    void preset_by(unsigned place, double increment);
    void local_zero(unsigned place, double value);  // G52
    void clear_preset();
    // what is active becomes a preset; the settable offset is off (fagor G92)
    void hold_zeros_as_preset();
    void set_shift(const AxisValues& shift);    // tool offset as a shift
    void set_wanted(const AxisValues& vector);  // tool offset that the next move travels
    bool vector_pending() const;
    // at once, where the programmed point is: no piece of the contour that is compensated
    bool travel_offset(bool rapid);
    // the vector holds without a move: the programmed numbers change
    void take_wanted();
    // The whole chain of programmable frames as one, invertible; Frame{} for none.
    void set_frame(const Frame& frame);
    // Factors of single axes that multiply the motion behind compensation (fagor G72 X..); `frame`
    // has them already. Not while blocks are read ahead.
    void set_factors(const AxisValues& factor, const Frame& frame);
    // some may come while compensation is active: what multiplies comes behind it from the
    // beginning
    void await_factors();
    Zeros zeros() const {
        return {path.external, path.work, path.preset, path.local,
                path.framed ? path.frame : Frame{}};
    }
    void set_zeros(const Zeros& zeros);
    AxisValues framed(const AxisValues& programmed) const;  // frame(programmed)
    AxisValues unframed(const AxisValues& point) const;     // programmed
    // the tool's position, in the system around the frame
    AxisValues framed_now() const;
    // Compensation that begins from now on, and corner elements, lie in the plane of a frame that
    // inclines it; else in the machine's.
    void lie_in_frame(bool compensation, bool corners) {
        comp_in_frame_ = compensation;
        corners_in_frame_ = corners;
    }
    // into a plane that is none of the machine's, in which circles stay circles
    bool frame_inclines() const;
    // what reads ahead works in such a plane
    bool inclined() const { return inclined_; }
    // The plane's directions outside the frame turn in the opposite direction: it mirrors, and the
    // sides of the path are exchanged.
    bool frame_mirrors_plane() const;

    // --- moves; target in the workpiece system (X as a radius). A block that moves nothing makes
    // no move.
    bool rapid(const AxisValues& target);
    bool linear(const AxisValues& target);
    bool arc(const AxisValues& target, const ArcCall& call);
    // Along the points between, which lie on the curve as close together as a straight line may
    // replace it.
    bool curve(const AxisValues& target, const std::vector<AxisValues>& between);
    bool thread(const AxisValues& target, const ThreadCall& call);
    // Until the input comes; a barrier follows, then take_skip(). feed 0: the modal one. release:
    // until the signal goes instead. torque: until something resists with so many thousandths of
    // the drive's own; then nothing may be named as the input.
    bool skip(const AxisValues& target, double feed, FeedMode mode, std::string_view input,
              bool release = false, double torque = 0.0);
    // Towards something that the axes meet (Move::fixed_stop); a barrier follows, then take_skip().
    bool fixed_stop(const AxisValues& target, double feed, FeedMode mode, bool must_come,
                    std::string_view input = {});
    // The next linear or rapid move of one of these axes is such a one.
    void meet_stop(AxisSet which) { stops_ = which; }
    AxisSet meets_stop() const { return stops_; }
    AxisSet stops_met() const { return stops_met_; }  // are at a fixed stop and press
    // A skip move whose end is taken at the next barrier without a further call. passes: it goes on
    // to its end all the same.
    bool measure(const AxisValues& target, std::string_view input, bool release,
                 bool passes = false);
    bool stop_alone(const AxisValues& target, double feed) {
        skip_due_ = true;
        return fixed_stop(target, feed, FeedMode::PerMinute, true);
    }
    // --- asynchronous to the path (core_positioning.cpp)
    // The axis goes to its target with its own feed (mm/min or deg/min, 0 rapid; per_turn: mm a
    // revolution of `spindle`) and the program does not wait.
    bool beside(unsigned place, const AxisValues& target, double feed, bool per_turn = false,
                std::uint16_t spindle = 0);
    void arrive(AxisSet axes, std::uint32_t spindles);  // waits until they are there
    // The axis' drive may give only so many thousandths of its torque; 0: all of it (a barrier,
    // then take_positions).
    void limit_torque(unsigned place, double thousandths, double window_mm);
    // At the end of the block the program must be at a barrier: positions that differ then are
    // taken over there.
    bool due_at_barrier() const {
        return resync_ != 0 || skip_due_ || measure_due_ || home_due_ != 0;
    }
    AxisSet skip_moved() const { return skip_moved_; }  // axes of the last skip move
    // axes are where the signal stopped them; the set of those that ended before their target
    AxisSet take_skip();
    // Programmed coordinate at which the signal came (the axes brake behind it): for measuring.
    // axes whose signal in measure() came before their end
    AxisSet measured() const { return measured_; }
    double skip_point(unsigned place) const { return skip_point_[place]; }
    bool machine_rapid(const AxisValues& machine, AxisSet which);  // G53
    // the next move leaves compensation
    void suspend_for(AxisSet which) {
        if (compensating_) suspend_compensation(which);
    }
    // end point of G28, G30
    bool reference(const AxisValues& machine, AxisSet which, MoveKind kind);
    // A word of a roll-over axis as its target: absolute or incremental, see the parameters.
    double rollover_target(unsigned place, double word, bool absolute);
    void force_exact_stop() { exact_once_ = true; }
    // A cut per revolution waits for a stopped spindle, and is a warning only (sinumerik);
    // otherwise it is an alarm.
    void wait_for_spindle(bool on) { waits_for_spindle_ = on; }

    // --- nose-radius compensation (channels/compensation). While it is on, blocks are read ahead
    // of what has been delivered:
    // the language reports the end of each block and stops at barriers when halted() says so.
    // F of a helix counts in the plane of its arc
    void helix_in_plane(bool on) { helix_in_plane_ = on; }
    void compensation_options(const compensation::Options& options);
    // likewise, and from the next move on while it is on
    void update_compensation(const compensation::Options& options);
    bool compensation(CompSide side);  // G41, G42
    // the next move goes straight to the vector at its end
    void compensation_resumes();
    // G40; direction in which the contour would go on, 0 0 none
    bool compensation_off(double wish_p, double wish_q);
    // reset, cycle start: nothing is delivered any more
    void compensation_reset();
    bool compensating() const { return compensating_; }
    // Compensation or a corner element is on: blocks are read ahead of what has been delivered.
    bool reads_ahead() const { return compensating_ || staged_; }
    // counts: a block that does nothing but what moves nothing counts as one without movement.
    // false: fault()
    bool end_compensated_block(bool counts, bool wants_barrier, bool program_ends);
    bool compensation_failed();  // false: fault()
    bool holds_block() const;    // it waits for the next one
    // a barrier behind what has been delivered; what is held stays held
    void barrier_before_held();
    // what was delivered last must be executed first
    bool halted() const;
    // true: nothing is held, Core's position is the machine's
    bool barrier_passed();
    // Around the moves of a cycle that compensation must leave alone: as programmed, or shifted by
    // the present vector.
    enum class CycleMoves : std::uint8_t { Plain, Shifted };
    void begin_cycle(CycleMoves how);
    void end_cycle();
    // How far the ends of a cycle's oblique cut from `a` to `b` must move along the axis `along` of
    // the plane, so that the nose touches it on the side of `outside`; 0 without compensation.
    double cut_shift(const AxisValues& a, const AxisValues& b, unsigned along,
                     const AxisValues& outside) const;
    // machine coordinate with the vector in it
    double machine_now(unsigned place) const;
    // where the axes were sent, as a program names it
    AxisValues programmed_now() const { return programmed_at(path.machine, ~AxisSet{0}); }

    // --- chamfers, roundings (channels/corners)
    bool corner(const corners::Call& call);  // at the end of the next move
    // own feed of an element that belongs to the next block; 0 its
    void corner_feed(double feed) {
        if (staged_) stage_->next_feed(feed);
    }
    // The next block decides where this one ends (a line by its angle): what comes meanwhile waits
    // for it.
    bool reserve_move(Alarm lost = {});  // lost: where it is never made
    bool move_reserved() const { return staged_ && stage_->reserved(); }
    template <class Make>
    void insert_reserved(Make&& make) {
        stage_->insert(std::forward<Make>(make));
    }

    // --- everything else
    // the next dwell is one that an interrupt macro has broken off
    bool rest_of_dwell = false;
    // until: a signal that ends it early
    bool dwell(double value, bool revolutions, std::string_view until = {});
    void signal(std::string_view name, double value) {
        emitted_ = true;
        sink_->signal(name, value, at);
    }
    void aux(char letter, double value, std::string_view text, bool drained, bool silent = false,
             ToolCallBy by = ToolCallBy::Type, std::string_view name = {});
    // ProgramControl: what the program takes out of the operator's hands
    void tell_control(std::uint32_t bits);
    // A statement that waits for a value of the machine, reported before its barrier. Coming back
    // to the same place with nothing done in between, the program polls: only the machine can end
    // such a loop, and where nothing there changes any more a run in virtual time has to (cli.md
    // 5).
    void asks_at(std::uint16_t file, std::uint64_t offset, std::size_t column = 0);
    // words, a variable that has another value now, a clock read: next time is another time
    void did() { ++doings_; }
    // as the machine begins a program
    void begin_control() {
        control_ = 0;
        asked_ = {};
        polls_ = false;
    }
    // A cycle taps from here on, or no more: a feed hold waits until the tool is out, the spindle's
    // override rests.
    void taps(bool on);
    // How the loop of the channel's spindle closes for a rigid tap (nct part 1 16.4): M19 orients
    // it (N1503 TSC), or N0823's code closes it at its position. `oriented`: only M19 will do.
    // False: it cannot, and the alarm names the spindle.
    struct TapLoop {
        bool orients = false;
        double code = 0.0;
    };
    bool rigid_loop(TapLoop& loop, bool oriented = false);
    // What a block says about the spindle is gathered and reported once, by commit_spindle().
    // `spindle`: another one than the channel's, by its name; reported at once or with the turn
    // that follows in the block.
    bool named_spindle(unsigned spindle, double rpm);
    bool spindle_speed(double value);  // S word: 1/min, or m/min with G96
    bool spindle_turn(SpindleTurn turn);
    bool surface_speed(bool on);
    // the axis that constant surface speed looks at from now on
    bool surface_axis_is(int place);
    bool spindle_limit(double rpm);
    bool spindle_least(double rpm);  // surface speed turns it no slower
    // Until switched off, positions are output asynchronously: the program does not wait for them
    // (SPOSA).
    void position_outside_path(bool on) { spindle_positioning_ = on; }
    // of the angles that follow; 0: in rapid
    void position_feed(double rpm) { position_feed_rpm_ = rpm; }
    bool spindle_position(double degrees, SpindleApproach approach = SpindleApproach::Shortest);
    // Another spindle than the one that S means: absolute in the shorter direction, or by so much.
    // `closed`: its loop is closed already (a word under the spindle's own address, N0817), else
    // the M code behind it closes it. feed_rpm 0: in rapid.
    bool spindle_angle(unsigned spindle, double degrees, bool incremental, bool closed,
                       double feed_rpm = 0);
    // turns the closed loop by so much, with its sign
    bool spindle_index(double way_deg);
    // An angle that is not taken modulo a turn; `way`: the loop is closed, turn it by so much.
    bool spindle_unwrapped(double degrees, std::optional<double> way_deg);
    // stopping the channel's spindle gives its drive to an axis of the channel
    bool frees_axis() const;
    // fluctuation; values as in Spindle::watch
    bool spindle_watch(bool on, const std::array<double, 4>& values = {});
    bool couple_spindle(const Spindle& told);  // Couple or Uncouple; a barrier follows
    // Feed per revolution counts those of another spindle while a gear box is closed (nct part 2
    // 19): 0 its own.
    struct GearFeed {
        unsigned spindle = 0;
        double factor = 1.0;
    };
    GearFeed gear_feed;
    bool commit_spindle();
    // after PathState was put back
    void forget_pending() {
        mode_changed_ = speed_changed_ = turn_changed_ = limit_changed_ = named_speed_changed_ =
            named_turn_changed_ = false;
        transformation_restored();
    }
    void refresh_surface_zero();                     // G96: the zero of X may have changed
    void set_fixture(const FixtureOffset& fixture);  // G54.2 (core_fixture.cpp)
    void fixture_off();
    // axes that the block has words for
    void fixture_names(AxisSet named) { fixture_named_ = named; }

private:
    bool spindle_to(double degrees, SpindleApproach approach, double way_deg,
                    bool whole_turns = false);
    void turn_with_move();
    void follow_with_holder();
    bool begin_move(const AxisValues& target, MoveKind kind);
    bool shape_arc(ArcCall call, unsigned p, unsigned q, bool& moves);
    bool feed_ready();
    double rapid_speed() const;
    bool only_degrees() const;
    void set_feed_path();
    bool spindle_ready(Alarm otherwise);
    void choose_withdrawal(const ThreadCall& call, unsigned along);
    double picked_up(const ThreadCall& call, unsigned along) const;
    bool within_stroke(const AxisValues& machine, AxisSet moved);
    // move_ does not violate a guarded work zone
    bool zones_allow();
    bool zones_allow(const Move& move);
    bool within_second_limits(const Move& move);
    void deliver();
    bool stage_corners();
    void chain(bool in_frame);
    template <class Told>
    void tell_comp(Told&& told);
    void tell_nose();
    void select_side();
    void tell_zero_distance();
    void suspend_compensation(AxisSet which);
    void drop_compensation_vector();
    void accept(const AxisValues& target);
    std::array<double, 3> fixture_at(const AxisValues& point) const;
    bool follow_fixture(const AxisValues& target, MoveKind kind);
    void take_fixture_step();
    void shift_by(const std::array<double, 3>& vector, double sense);
    AxisValues chain_offset() const;  // what is added to frame(programmed)
    void follow_offsets(const AxisValues& programmed, const AxisValues& before);
    void sum_zeros();
    void refresh_routes();
    void show_transformation();
    std::array<double, 2> centre_offsets() const;
    bool on_machine(AxisValues& values) const;  // path coordinates -> axes, for limits
    void rebase(unsigned place);
    void rebase_all();
    void settle_turns();  // framed roll-over axes
    AxisValues programmed_at(const AxisValues& machine, AxisSet which) const;
    bool frame_reachable(const AxisValues& target);
    bool frame_arc(ArcCall& call, const AxisValues& target, unsigned& p, unsigned& q);
    void show_factors();
    AxisValues before_factors(AxisValues point) const;
    double behind_factors(unsigned place, double machine, double offset) const;
    Frame frame_before_factors() const;
    void take_factors_off();
    void change_factors(AxisValues was, bool were);
    void add_bias();
    bool inclined_plane(Frame& plane) const;
    Sink& incline(bool wanted);
    void take_incline_off();
    void incline_arc(ArcCall& call, const AxisValues& target, unsigned p, unsigned q) const;
    AxisValues behind_incline(AxisValues machine) const;
    double displaced_along(unsigned place, double p, double q) const;
    const AxisValues& move_end() const { return factors_off_ ? real_end_ : move_.machine; }
    Point3 geo_of(const AxisValues& values) const;
    void put_geo(AxisValues& values, const Point3& point) const;
    double surface_zero(int place) const;
    int surface_axis() const;
    double spindle_rpm_at(double radius_mm) const;  // 0: not known

    MachineView* view_;
    std::array<int, 3> geo_{-1, -1, -1};  // indices of X, Y, Z
    std::uint32_t control_ = 0;           // as tell_control() said it
    struct Asked {
        std::uint16_t file = 0;
        std::uint64_t offset = 0;
        std::size_t column = 0;
        std::uint64_t doings = ~0ull;
        bool operator==(const Asked&) const = default;
    };
    Asked asked_;
    std::uint64_t doings_ = 0;
    bool polls_ = false;  // said to the machine
    Sink* sink_;          // out_, or the compensator in front of it
    Sink* out_;
    Sink* outermost_;                                 // behind RouteSink
    std::unique_ptr<RouteSink> routes_;               // while an address has another axis' drive
    std::array<double, 2> transformation_offsets_{};  // centre_offsets() when it was switched on
    // in front of the following once an axis has had a factor
    std::unique_ptr<FactorSink> factors_;
    // in front of out_ while what reads ahead lies in an inclined plane
    std::unique_ptr<InclinedSink> incline_;
    bool inclined_ = false, comp_in_frame_ = false, corners_in_frame_ = false;
    // move_ is what it is before the factors, or inside the inclined plane
    bool factors_off_ = false;
    AxisValues real_end_{};  // where it ends then
    // in front of it once a transformation has been on
    std::unique_ptr<TransformSink> transforms_;
    Port* port_;
    Move move_;
    // X Y Z: what the move that is begun adds to the fixture offset
    std::array<double, 3> fixture_step_{};
    AxisSet fixture_named_ = 0;
    AxisValues framed_{};  // target of the move that is begun, outside the frame
    Fault fault_;
    std::unique_ptr<compensation::Compensator> comp_;
    compensation::Options comp_options_;
    std::unique_ptr<corners::CornerStage> stage_;
    bool staged_ = false;  // stage_ and comp_ are in the chain
    bool compensating_ = false;
    CompSide comp_side_ = CompSide::Off;  // as programmed; a mirroring frame changes it
    // axes that the next move takes along although they are where it wants them
    AxisSet forced_ = 0;
    bool emitted_ = false;
    bool exact_once_ = false;
    std::uint64_t moves_ = 0, ways_ = 0;
    bool warned_spindle_ = false, waits_for_spindle_ = false, spindle_positioning_ = false;
    StrokeZones zones_;  // where the axes may be, as of the last barrier
    void find_reference(AxisSet which, const AxisValues& then);
    void take_due();
    AxisSet resync_ = 0;  // their position is another one behind the next barrier
    // they find their reference points before it, and go to home_then_ behind it
    AxisSet home_due_ = 0;
    AxisValues home_then_{};
    AxisSet stops_ = 0, stops_met_ = 0;  // meet_stop(); and those that met it
    bool skip_due_ = false, measure_due_ = false, skip_passes_ = false;
    AxisSet measured_ = 0;
    bool offset_alone_ = false;
    double surface_zero_told_ = 0.0;
    AxisSet skip_moved_ = 0;
    AxisValues skip_target_{}, skip_point_{};
    bool mode_changed_ = false, speed_changed_ = false, turn_changed_ = false,
         limit_changed_ = false;
    bool helix_in_plane_ = false;
    double position_feed_rpm_ = 0;
    bool position_closed_ = false;
    bool named_speed_changed_ = false, named_turn_changed_ = false;
};

}  // namespace polyturn::channels
