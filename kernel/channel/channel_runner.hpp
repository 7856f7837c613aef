// Executes the records of one channel, in ring order (architecture 5): motion through the planner,
// everything else at standstill or at the instant between two moves where the record lies in the
// ring.
//
//   ring   ... | done | running | planned ...      | seen, not planned | not to be used this tick |
//              tail ^ (published)   planner.next_record() ^      visible_end_ ^          head ^
//
// A tick: supply() shows the planner what is visible (at most the horizon: PT_HORIZON); run()
// executes the record at the boundary, drives the path and reports what began and ended. The
// machine releases waits between the channels' runs.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/kinematics/kinematics.hpp"
#include "kernel/by_hand/positioning_program.hpp"
#include "kernel/channel/hand_block.hpp"
#include "kernel/channel/mdi_lines.hpp"
#include "kernel/channel/thread_retract.hpp"
#include "kernel/channel/trail.hpp"
#include "kernel/gate/motion_gate.hpp"
#include "kernel/gate/start_conditions.hpp"
#include "kernel/motion/path_planner.hpp"
#include "kernel/motion/thread_follower.hpp"
#include "kernel/records/moved_axes.hpp"
#include "kernel/records/record_inbox.hpp"
#include "kernel/tick/core.hpp"
#include "kernel/waits/restart_fate.hpp"

namespace polyturn::kernel {

class ChannelRunner {
public:
    ChannelRunner(Core& core, unsigned index);

    // Once its process has made its segment; again for a successor.
    void attach(const ChannelSegment& segment);
    bool attached() const noexcept { return segment_ != nullptr; }
    // Its process is gone and its axes rest.
    bool may_be_replaced() const noexcept { return !segment_ || (dead_ && at_rest()); }
    void prepare();  // takes its memory; not in the cyclic thread

    // --- once a tick, in this order ---
    void supply() noexcept;
    void begin_function_early() noexcept;
    // The turret turns meanwhile because this channel has commanded it before the end of its rapid
    // move.
    bool turns_in_rapid() const noexcept { return moving_rapid_ && early_ != kNoRecord; }
    void strobe(const PathRecord& r) noexcept;
    [[nodiscard]] bool starts_in_rapid() noexcept;
    bool tool_may_begin(const PathRecord& move, const PathRecord& tool, double until) noexcept;
    [[nodiscard]] std::uint64_t end_of_few_blocks(std::uint64_t most) const noexcept;
    void run() noexcept;
    // State that the wait board needs (waits.hpp): this channel's half of a rendezvous counts while
    // its program runs.
    WaitBoard::Standing standing() const noexcept;
    void release_wait(Permit permit) noexcept;  // the meeting took place
    // messages and alarms of those that still wait
    void after_waits(std::span<ChannelRunner* const> all) noexcept;
    void publish(ChannelStatus& status) noexcept;
    // what the channel must know, after the status of this tick is published
    void send_events() noexcept;

    // --- commands, at a tick's start ---
    // only_by_hand: a block of the MDI list, or nothing
    void cycle_start(bool only_by_hand = false) noexcept;
    // The program waits at a dialogue: a value that the operator has entered, and the key that ends
    // it.
    void dialogue_value(double value, std::string_view variable) noexcept;
    void dialogue_key(double key) noexcept;
    std::uint32_t check_start_conditions() noexcept;  // ChannelStatus::start_missing, now
    StartView start_view() const noexcept;            // what the start conditions must know of it
    // A start would begin something, and nothing is selected or entered: of several that start
    // together it is passed over.
    bool lacks_program_or_block() const noexcept;
    void feed_hold() noexcept;  // the operator: a program may suppress it (#3004)
    void safe_hold() noexcept;  // a door, a dead partner: cannot be suppressed
    // From a block of the program on; `together`: channels that restart too, bit 0 is channel 1;
    // `group`: their restart. False: refused.
    bool restart(double block, ChannelSet together, std::uint32_t group) noexcept;
    bool at_restart_block() const noexcept { return restart_ == RestartState::AtBlock; }
    // Of a member of a restart group (restart_groups.hpp): what has become of it; all of the group
    // are at their blocks.
    RestartFate restart_fate() const noexcept;
    void let_restart_begin(bool complete) noexcept { restart_complete_ = complete; }
    // it goes back to reset with the others; a start that was meant for its block begins nothing
    void end_restart() noexcept;
    // by operator, scenario, or what its machine group does when a partner dies
    void reset() noexcept;
    // language: a Dialect, 0 as PT_LANGUAGE says
    void select(std::string_view file, double language) noexcept;
    // INIT says none: as before
    void init_program(std::string_view file) noexcept {
        select(file, static_cast<double>(job_language_));
    }
    void start_program() noexcept;
    // channel_by_hand.cpp: a block comes into the list, and nothing moves; the list is emptied; a
    // key whose label is a start
    void enter(std::string_view text) noexcept;
    void clear_entered() noexcept;
    void hand_key(std::string_view text) noexcept;
    // what runs, or is held, is no program
    bool by_hand() const noexcept { return hand_.runs != HandBlock::Of::Nobody; }
    // set by the operator only; for_block: kStartByHand
    void set_mode(ChannelMode mode, bool for_block = false) noexcept;
    ChannelMode mode() const noexcept { return mode_; }
    void stop_after_part(bool on) noexcept { stop_after_part_ = on; }
    // channel_production.cpp: a program that repeats itself ends with its part after so many
    // seconds; 0: no warm-up.
    void warm_up(double seconds) noexcept;
    // Axes are moved by hand in a hold; the machine stores the return path and reports when they
    // are back.
    bool allow_jog_in_hold() noexcept;
    bool jogs_in_hold() const noexcept { return jog_in_hold_; }
    // The machine moves axes off a path at standstill, whatever record the program is at; it
    // continues when they are back.
    void step_aside() noexcept;
    bool rests() const noexcept { return !planner_ || at_rest(); }
    bool resets() const noexcept { return resetting_; }
    void on_path_again() noexcept { jog_in_hold_ = false; }
    void quit() noexcept;
    void store_changed() noexcept { store_changed_ = change_due_ = true; }
    void process_died(Alarm reason, std::string_view detail = {}) noexcept;
    // channel_refusal.cpp: its process has sent what cannot be. It is believed no more.
    bool sends_what_cannot_be() const noexcept {
        return segment_ && !dead_ && inbox_.refusal().field;
    }
    void turn_away() noexcept;
    void process_stopped(bool stopped) noexcept;
    // The machine stops for a reason that is not the channel's: along the path, until reset.
    void interrupt() noexcept;
    void fault(Alarm number, std::string_view detail, double value) noexcept {
        raise(number, detail, value);
    }
    void emergency() noexcept;                     // forget the path: the axes brake by themselves
    double feed_override = 1, rapid_override = 1;  // as the switches are set
    // The effective feed override.
    // The language of what runs: of the selected program, where its job says one; a block by hand
    // is in that of the machine.
    Dialect speaks() const noexcept {
        return mode_ != ChannelMode::Mdi && !by_hand() && job_language_ != Dialect::Polyturn
                   ? job_language_
                   : core_.config.channels[index_].language;
    }
    double feed_factor() const noexcept {
        constexpr double kMost = 2.0;
        return std::min(feed_override, speaks() == Dialect::Fagor
                                           ? core_.config.channels[index_].fagor_feed_override_max
                                           : kMost);
    }
    // The program has set the spindle override: the operator's rests (fagor PRGSSO).
    bool own_spindle_override() const noexcept { return control_ & kControlOwnSpindleOverride; }
    // The program only asks for a value of the machine, and asks again.
    bool polls() const noexcept;
    std::uint32_t pressed_keys = 0;  // ChannelKey, by the operator
    // ChannelKey as they act: the operator's and those that the PLC's marks hold
    std::uint32_t keys = 0;

    // --- the path driven back and forth (channel_trail.cpp) ---
    void retrace(bool on) noexcept;
    void set_handwheel(bool on, double rate) noexcept;
    bool by_handwheel() const noexcept { return handwheel_; }
    // it cannot go further back
    bool handwheel_blocked() const noexcept { return handwheel_blocked_; }
    void pass_waits(std::span<ChannelRunner* const> all) noexcept;

    // --- positioning axes (positioning_axis.cpp), superposed handwheel (superpose.cpp) ---
    // of an axis' limits, that a path leaves to a superposed handwheel
    static constexpr double kOverlayShare = 0.2;
    bool holds_positioning() const noexcept;
    // it moves asynchronously to the path, or its own program is not over
    bool runs_positioning(std::uint32_t axis) const noexcept;
    bool has_steps(std::uint32_t axis) const noexcept { return positioning_program_.moves(axis); }
    // for its axis, where its program is about to begin
    void queue_up() noexcept;
    void run_steps() noexcept;
    bool breaks_off_positioning() const noexcept {
        return resetting_ || interrupted_ || dead_ || emergency_;
    }
    double handwheel_share() const noexcept { return handwheel_ ? handwheel_rate_ : 1.0; }
    void superpose(bool on) noexcept;
    bool superposes() const noexcept { return (pressed_keys & kKeySuperpose) != 0; }
    // the path that is driven was planned with the handwheel superposed
    bool leaves_room() const noexcept;
    void overlay_moves(std::uint32_t axis, bool moves) noexcept {
        if (moves)
            overlays_ |= std::uint64_t{1} << (axis % 64);
        else
            overlays_ &= ~(std::uint64_t{1} << (axis % 64));
    }

    // --- for the clock ---
    // Virtual time may go on: enough records for the horizon, or the process has nothing more to
    // say.
    bool supplied() noexcept;
    bool listens() const noexcept { return segment_ && !dead_ && !stopped_; }
    void wake() const noexcept { core_.image.channel_bell[index_].ring(); }
    bool silent_too_long() const noexcept;
    bool can_go_on() const noexcept;  // something of it moves, counts down or waits for an answer
    bool operates() const noexcept {
        return mode_ == ChannelMode::Auto &&
               (state_ == ChannelState::Running || state_ == ChannelState::Waiting);
    }
    // fanuc_lathe 6.3.3: the lamp is out from feed hold and in a single block stop, and lit while
    // tools and pallets are changed.
    bool start_lamp() const noexcept {
        return (state_ == ChannelState::Running || state_ == ChannelState::Waiting) && !hold_;
    }
    // fanuc_lathe 6.3.4: nothing of the block is in progress but the code that the PLC has; not
    // where the program does not wait for its end.
    bool distribution_ended() const noexcept {
        return phase_ == Phase::Handshake && !unfinished_ && at_rest();
    }
    bool cuts() const noexcept { return operates() && moving_ && !moving_rapid_; }
    // channel_early.cpp: rapid moves, and what follows them, keep the speed of constant
    // surface speed as it is; one under way gives it the speed of the cut that follows directly,
    // which begins with this axis there.
    bool holds_surface_speed() const noexcept;
    std::optional<double> cut_begins_at(std::uint32_t axis) const noexcept;
    std::uint32_t number() const noexcept { return number_; }
    bool path_moves() const noexcept { return moving_; }
    double path_speed() const noexcept { return moving_ ? step_.speed : 0.0; }  // mm/s
    // What was driven until now was planned for other limits or coordinates: it is not driven back.
    void forget_trail() noexcept {
        if (!trail_.active()) trail_.clear();
    }
    // Nothing is planned ahead: it is idle, or its program waits for the answer to what is being
    // executed. What changes routes, limits or coordinates then is read by the program before it
    // goes on.
    bool stands() const noexcept {
        if (!segment_ || !program_runs()) return true;
        if (trail_.active()) return false;
        return cursor_ >= inbox_.head(cursor_) || (inbox_.flags_of(cursor_) & kDrains) != 0;
    }
    bool in_handshake() const noexcept { return phase_ == Phase::Handshake; }
    std::int32_t m_code() const noexcept { return m_code_; }  // given to the PLC last; -1 none

    ChannelState state() const noexcept { return state_; }
    bool idle() const noexcept {  // no program of it runs
        return state_ == ChannelState::Reset || state_ == ChannelState::Ended ||
               state_ == ChannelState::Dead || state_ == ChannelState::Absent;
    }
    StopReason stop_reason() const noexcept { return stop_reason_; }
    bool program_runs() const noexcept {
        return state_ == ChannelState::Running || state_ == ChannelState::Held ||
               state_ == ChannelState::Waiting || state_ == ChannelState::ProgramStop;
    }
    // Its axes move by the revolutions of this spindle (from 1).
    bool cuts_with(std::uint32_t spindle) const noexcept;
    std::uint32_t line() const noexcept { return line_; }
    // block of the record that began last
    std::uint64_t serial() const noexcept { return serial_; }
    std::string_view program() noexcept;  // file name of the running record, without folders

private:
    void strobe_end(StopReason reason) noexcept;
    // State of the record in front of which the path is stopped.
    enum class Phase : std::uint8_t {
        None,
        Dwell,
        Handshake,
        Waiting,
        Stopped,
        Thread,
        Spindle,
        Home,
        Released
    };
    static constexpr std::uint64_t kNoRecord = ~0ull;

    const PathRecord& record(std::uint64_t index) const noexcept { return inbox_.record(index); }
    // The transformation that leads from the record's coordinates to its axes; none: they are its
    // axes.
    const Kinematics* kinematics_of(const PathRecord& r) const noexcept {
        return inbox_.kinematics(r.transform);
    }
    static bool is_motion(const PathRecord& r) noexcept {
        return r.kind >= 1 && r.kind <= static_cast<std::uint8_t>(RecordKind::Curve);
    }
    static bool stops_path(const PathRecord& r) noexcept;
    bool block_ends_at(std::uint64_t index) const noexcept;
    static bool writes_store(const PathRecord& r) noexcept;
    void plan_anew(std::uint64_t from) noexcept;
    void drop_old_epochs(std::uint64_t most) noexcept;
    void judge_stroke_anew() noexcept;
    bool ends_at_limit(const PathRecord& r) noexcept;
    void stop_at_limit() noexcept;
    void execute_standing(double& left) noexcept;
    // true: done, the next one may begin
    bool execute(const PathRecord& r, double& left) noexcept;
    void allow_torque(const PathRecord* r) noexcept;
    bool leaves_stop() const noexcept;
    bool execute_instant(const PathRecord& r, double offset_s) noexcept;
    bool handshake(const PathRecord& r) noexcept;
    bool tool_is_known(const PathRecord& r) noexcept;
    void flag(const PathRecord& r) noexcept;
    bool dwell(const PathRecord& r, double& left) noexcept;
    bool arrive(const PathRecord& r) noexcept;
    void stand_at(const PathRecord& r) noexcept;
    WaitBoard::Phase wait_phase() const noexcept;
    bool flies_unmet() noexcept;
    bool thread(double& left) noexcept;
    bool commit_thread() noexcept;
    bool withdraws(const PathRecord& first) const noexcept;
    void begin_withdrawal(const PathRecord& r, const ThreadStep& step) noexcept;
    bool go_back(const PathRecord& first) noexcept;
    void withdrawn(const ThreadStep& step) noexcept;
    bool thread_may_start(const PathRecord& r) noexcept;
    void report_thread(const ThreadStep& step) noexcept;
    bool at_rest() const noexcept {
        return planner_->at_rest() && !thread_moving_ && trail_.at_rest() && !off_path_.any();
    }
    void describe_wait(ShortText& text) noexcept;
    void write_code(ShortText& text) const noexcept;
    bool needed_elsewhere(std::uint32_t follower) const noexcept;
    bool calls_follower(std::uint32_t follower) noexcept;
    bool stop(const PathRecord& r) noexcept;
    void finished(const PathRecord& r, std::uint64_t index, double offset_s) noexcept;
    void begin_record(const PathRecord& r, double offset_s) noexcept;
    static bool is_optional_stop(const PathRecord& r) noexcept;
    void take_keys() noexcept;
    void drive() noexcept;
    void settle() noexcept;
    void report_progress() noexcept;
    bool skip_signal() noexcept;
    void end_skipped_move() noexcept;
    void watch_interrupt() noexcept;
    std::uint32_t interrupt_signals() noexcept;
    bool is_stopped_for_interrupt() noexcept;
    void announce_interrupt() noexcept;
    bool obey_ahead() noexcept;
    void break_off() noexcept;
    // channel_hold.cpp: changes that act in a hold, blocks entered in one
    struct Place {                 // in the program, of a path that rests
        std::uint64_t serial = 0;  // block; 0: behind everything that was pushed
        std::uint32_t part = 0;
        bool begun = false;
    };
    Place place_now() const noexcept;
    std::uint64_t first_not_begun() const noexcept;
    bool is_at_late_stop() const noexcept;
    // Why the channel is asked: offsets have changed, a block is entered by hand, or it starts
    // where its axes were moved to.
    enum class BackFor : std::uint8_t { Change, ByHand, Away };
    bool rests_in_hold() const noexcept;
    bool stands_in_hold() const noexcept { return !jog_in_hold_ && rests_in_hold(); }
    bool resumes_elsewhere() const noexcept;
    void settle_hold() noexcept;
    void ask_to_go_back(BackFor why) noexcept;
    void take_answer() noexcept;
    void go_back_to(const Place& place, bool away = false) noexcept;
    void enter_by_hand(StartPermit permit) noexcept;
    bool may_leave_for_block() const noexcept {
        return state_ == ChannelState::Held && !held_mdi_ && (program_left_ || stands_in_hold());
    }
    bool line_is_next() const noexcept;
    void begin_line(StartPermit permit) noexcept;
    void begin_in_hold(StartPermit permit, HandBlock::Of what) noexcept;
    void answered_for_block(bool goes_back) noexcept;
    void next_line() noexcept;
    void block_is_over() noexcept;
    void discard() noexcept;
    PathInput path_input() noexcept;
    bool may_leave_path() const noexcept;
    bool leave_path() noexcept;
    bool axes_are_on(const PathRecord& r, double s) const noexcept;
    bool start_retrace(StartPermit permit) noexcept;
    bool handwheel_drives_trail() noexcept;
    // A program runs; or it has ended, and the handwheel takes it back.
    bool drives_by_handwheel() const noexcept {
        return program_runs() || (handwheel_ && state_ == ChannelState::Ended && !held_mdi_);
    }
    bool partners_let_through(std::span<ChannelRunner* const> all) const noexcept;
    void drive_trail() noexcept;
    void tell_obstacle() noexcept;
    bool stops_for_tool(const PathRecord& r) noexcept;
    bool ready_to_continue() noexcept;
    // Nothing of a program begins or goes on without a permit (kernel/gate): a refused one has been
    // said.
    std::optional<StartPermit> permit_of(Door door, const StartView& view) noexcept;
    Door door_of_start() const noexcept;
    void start_by(std::optional<Door> door) noexcept;
    void go_on(StartPermit permit) noexcept;
    void begin_program(StartPermit permit, ChannelEventKind how, double value, std::uint64_t record,
                       std::string_view text) noexcept;
    void watch_standstill(const PathRecord* running) noexcept;
    double tap_gain_of(const PathRecord& r) const noexcept;
    void limit_tapping(const PathRecord& r, PlannedRecord& planned) const noexcept;
    bool place_spindle(const PathRecord& r, double s) noexcept;
    std::uint32_t awaited_spindle() const noexcept;
    bool refuses_detached(std::uint32_t spindle) noexcept;
    bool waits_for_drive() noexcept;
    bool drive_is_coming() const noexcept;
    void know_positions() noexcept;
    void raise_not_in_position() noexcept;
    bool axes_in_position() const noexcept;
    double dry_run_feed() const noexcept;
    double emergency_deceleration() const noexcept;
    void place_axes(const PathRecord& r, double s) noexcept;
    void watch_commands() noexcept;
    void leave_off_path(std::size_t axis) noexcept;
    void brake_off_path() noexcept;
    bool brake_axes() noexcept;
    void take_records() noexcept;
    void begin_behind_all() noexcept;
    void report(KernelEventKind kind, const PathRecord& r, double offset_s) noexcept;
    void finish_reset() noexcept;
    void stand(ChannelState state, StopReason reason) noexcept;
    void raise(Alarm number, std::string_view detail = {}, double value = 0) noexcept;
    void spindle_mode(const PathRecord& r) noexcept;
    void refuse_bound(const PathRecord& r) noexcept;
    bool couple_spindle(const PathRecord& r) noexcept;
    // channel_positioning.cpp
    bool begin_positioning(const PathRecord& r) noexcept;
    void take_step(const PathRecord& r) noexcept;
    bool step_done(const PositioningTask& task) noexcept;
    bool give_function(const PositioningTask& task) noexcept;
    bool takes_axis(const PositioningTask& task) noexcept;
    bool axis_enabled(std::uint32_t axis) noexcept;
    void leave_axis() noexcept;
    void report_step(
        KernelEventKind kind, const PositioningTask& task,
        std::int32_t code = static_cast<std::int32_t>(RecordKind::PositioningAxis)) noexcept;
    PositioningProgram positioning_program_;
    // the PLC has ended its program, and the channel does not know the axis' position yet; kMaxAxes
    // none
    std::uint32_t limited_axis_ = kMaxAxes;
    bool await(const PathRecord& r) noexcept;
    bool limit_torque(const PathRecord& r) noexcept;
    bool find_reference(const PathRecord& r) noexcept;
    void release_stops() noexcept;
    std::uint64_t superposed_from_ = 0;  // records from this one on leave limits for the handwheel
    std::uint64_t overlays_ = 0;         // axes that it moves just now
    void part_made() noexcept;
    void end_lap() noexcept;
    bool part_counter(std::string_view variable, double value) noexcept;
    void watch_production() noexcept;
    double setup_ceiling() const noexcept;
    double ceiling_before_reference(const PathRecord& r) const noexcept;
    bool position_spindle(const PathRecord& r) noexcept;
    bool take_spindle(const PathRecord& r, std::uint32_t number, bool lock) noexcept;
    void tell(ChannelEventKind kind, std::uint64_t record, double value = 0,
              std::string_view text = {}) noexcept;

    Core& core_;
    unsigned index_;        // from 0
    std::uint32_t number_;  // from 1
    const ChannelSegment* segment_ = nullptr;
    RecordInbox inbox_;                 // nothing else reads records of the segment
    MovedAxes placed_, placed_before_;  // by the path in this tick, and in the one before
    // brake by themselves: a record led one of them beyond its limits
    MovedAxes off_path_;
    std::unique_ptr<PathPlanner> planner_;
    std::unique_ptr<ThreadFollower> thread_;
    std::uint64_t thread_end_ = 0;  // its last record
    ThreadRetract retract_;
    bool thread_committed_ = false, thread_moving_ = false;
    ChannelState state_ = ChannelState::Absent;
    ChannelMode mode_ = ChannelMode::Auto;
    StopReason stop_reason_ = StopReason::None;
    std::uint32_t epoch_ = 0;
    // running record, or the one before which the path is stopped
    std::uint64_t cursor_ = 0;
    // limit_: end of what a dead or stopped process had announced
    std::uint64_t visible_end_ = 0, limit_ = ~0ull;
    bool at_boundary_ = true;  // at standstill, and the record at cursor_ may begin
    // The record that leads out of the travel limits, how far along it the path may go, and why;
    // judged when it is planned.
    struct Cut {
        std::uint64_t record = kNoRecord;
        double s = 0;
        StrokeFault fault;
        std::uint64_t version = 0;  // of the limits that it was judged by
        // of the channel's axes at the end of what is planned
        StrokeGuard::Places places{};
        bool places_known = false;
    } cut_;
    std::uint32_t writes_ahead_ = 0;    // records that are planned and will write to the store
    std::uint64_t flying_ = kNoRecord;  // nearest flying wait that still stops the path
    // the one that does not, because its partners are there, and that the path has not come to yet
    std::uint64_t let_pass_ = kNoRecord;
    // the wait was passed before they arrived: the path is stopped behind it until they do
    bool owes_rendezvous_ = false;
    Phase phase_ = Phase::None;
    std::int32_t m_code_ = -1;
    bool begun_ = false;        // the stationary record has reported its beginning
    bool passes_stop_ = false;  // it is an M01 whose key was off when it began
    bool jog_in_hold_ = false, stop_after_part_ = false, ends_with_part_ = false;
    bool hold_ = false, dead_ = false, stopped_ = false, resetting_ = false, interrupted_ = false,
         alarm_ = false, continue_ = false, answered_ = false;
    bool skipped_ = false;  // the signal of the last skip move came
    // kControlNoSingleBlock has ended in single block: the path is to rest here
    bool group_ended_ = false;
    bool rest_reported_ = false, released_ = false, passing_ = false, judged_ = false,
         emergency_ = false, skipping_ = false, torque_given_ = false;
    // M96: the signal is watched; it has come and the path is to stop; as it was at the last tick.
    bool interrupts_on_ = false, interrupt_due_ = false;
    // InterruptBit; bit n: input n + 1; those that were on at the last tick
    std::uint32_t interrupt_bits_ = 0, interrupt_inputs_ = 0, interrupt_seen_ = 0;
    // The channel was notified ahead: the question it answers (0 none), and the first record that
    // may act at once.
    std::uint64_t ahead_asked_ = 0, ahead_ = kNoRecord;
    std::uint32_t control_ = 0;  // ProgramControl
    // feed hold that did not count yet; the code before runs asynchronously to the program
    bool hold_later_ = false, unfinished_ = false;
    std::uint32_t interrupt_input_ = 0;  // number of the input that came; 0: there is but one
    std::uint64_t last_serial_ = 0;      // block of the record that ended last
    std::uint32_t last_part_ = 0;
    std::uint64_t question_ = 0;  // AskResume that is not answered yet; 0 none
    // where it would go back to; where the program was left for a block by hand
    Place asked_, left_;
    BackFor asked_for_ = BackFor::Change;
    bool change_due_ = false, start_wanted_ = false;
    // a block by hand runs in the hold; one has run
    bool held_mdi_ = false, program_left_ = false;
    RestartState restart_ = RestartState::None;
    std::uint32_t restart_group_ = 0;  // of the search
    bool restart_complete_ = false;    // all of its group are at their blocks
    // a start would begin the program at its first block, which was not requested
    bool restart_refused_ = false;
    std::uint64_t run_ = 0;  // grows with each start and each reset
    // its process died while a program ran: that has not come to its end, whatever a successor is
    bool cut_off_ = false;
    Trail trail_;
    // chosen by the operator: -1 cycle start drives backwards, 1 forwards again
    int retrace_ = 0;
    bool on_trail_ = false;  // it moves there
    bool handwheel_ = false, handwheel_blocked_ = false, handwheel_reported_ = false;
    double handwheel_rate_ = 0;
    // from a wait at which it waited: it arrives there once more
    bool came_back_ = false;
    std::uint64_t meeting_ = 0;             // that released the wait which ends now
    std::uint64_t tool_shown_ = kNoRecord;  // first-part mode has stopped before it
    MdiLines lines_;                        // entered by hand
    HandBlock hand_;
    bool selected_ = false;  // a program, in the process that is there now
    // line at which it was; 0: it has ended, or has not begun
    std::uint32_t broken_off_ = 0;
    Dialect job_language_ = Dialect::Polyturn;  // of the selected program; Polyturn: PT_LANGUAGE
    bool store_changed_ = false, moving_rapid_ = false, moving_ = false;
    std::int64_t stopped_since_ = 0, phase_since_ = 0, wait_since_ = 0, stands_since_ = 0,
                 watched_ = 0;
    // of the last move: who must be in position
    std::array<std::uint8_t, kMaxPathAxes> last_axes_{};
    std::uint32_t last_axis_count_ = 0;
    // dwell_broken_: of the one that the interrupt signal broke off
    double dwell_left_ = 0, dwell_broken_ = 0;
    std::int64_t dwell_since_ = 0;  // tick at which it began
    // record that is placed; and the last tapping one of them
    std::uint64_t cursor_record_ = 0, tapped_ = kNoRecord;
    double tap_from_ = 0;  // revolutions at which that began
    std::int32_t strobe_ = 0;
    // this function has begun while the rapid move before it still brakes (N0421 ROL)
    std::uint64_t early_ = kNoRecord;
    std::uint32_t warned_ = 0;  // partners of this wait that were reported to the operator
    std::uint64_t events_sent_ = 0, rung_at_ = 0;
    std::int32_t resets_ = 0;
    PathStep step_{};
    std::uint64_t serial_ = 0;
    std::uint32_t line_ = 0, file_ = 0;
    std::int64_t block_ = -1;
    std::uint32_t parts_ = 0;
    // of cycle time after which the program ends with its part; 0: none
    double warm_up_s_ = 0;
    double cutting_s_ = 0, rapid_s_ = 0, waiting_s_ = 0, cycle_s_ = 0;
    double lit_s_ = 0;  // the cycle start lamp, since power-on
    // Parts, or runs of programs that count none: how many since a program was selected, how long.
    double part_from_s_ = 0, last_cycle_s_ = 0, cycles_s_ = 0;
    std::uint32_t cycles_ = 0, start_missing_ = 0;
    bool lap_ended_ = false;  // a part was made in this run
    std::uint64_t blocks_ = 0;
    std::unique_ptr<ProgramNames> names_;
    std::array<ChannelEvent, 16> outbox_{};
    std::size_t outbox_count_ = 0;
};

}  // namespace polyturn::kernel
