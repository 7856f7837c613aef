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
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/kinematics/kinematics.hpp"
#include "kernel/by_hand/positioning_program.hpp"
#include "kernel/channel/parts/block_shown.hpp"
#include "kernel/channel/parts/channel_path.hpp"
#include "kernel/channel/parts/hand_blocks.hpp"
#include "kernel/channel/parts/interrupt_watch.hpp"
#include "kernel/channel/parts/operator_panel.hpp"
#include "kernel/channel/parts/outbox.hpp"
#include "kernel/channel/parts/path_axes.hpp"
#include "kernel/channel/parts/process_link.hpp"
#include "kernel/channel/parts/production.hpp"
#include "kernel/channel/parts/program_state.hpp"
#include "kernel/channel/parts/restart_stage.hpp"
#include "kernel/channel/parts/resume.hpp"
#include "kernel/channel/parts/retrace.hpp"
#include "kernel/channel/parts/standing_record.hpp"
#include "kernel/channel/parts/thread_executor.hpp"
#include "kernel/gate/motion_gate.hpp"
#include "kernel/gate/start_conditions.hpp"
#include "kernel/tick/core.hpp"
#include "kernel/waits/restart_fate.hpp"

namespace polyturn::kernel {

class ChannelRunner {
public:
    ChannelRunner(Core& core, unsigned index);

    // Once its process has made its segment; again for a successor.
    void attach(const ChannelSegment& segment);
    bool attached() const noexcept { return process_.attached(); }
    // Its process is gone and its axes rest.
    bool may_be_replaced() const noexcept {
        return !process_.segment || (process_.dead() && at_rest());
    }
    void prepare();  // takes its memory; not in the cyclic thread

    // --- once a tick, in this order ---
    void supply() noexcept;
    void begin_function_early() noexcept;
    // The turret turns meanwhile because this channel has commanded it before the end of its rapid
    // move.
    bool turns_in_rapid() const noexcept {
        return path_.rapid && standing_.handshake.early != kNoRecord;
    }
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
    bool at_restart_block() const noexcept { return restart_.at_block(); }
    // Of a member of a restart group (restart_groups.hpp): what has become of it; all of the group
    // are at their blocks.
    RestartFate restart_fate() const noexcept;
    void let_restart_begin(bool complete) noexcept { restart_.complete = complete; }
    // it goes back to reset with the others; a start that was meant for its block begins nothing
    void end_restart() noexcept;
    // by operator, scenario, or what its machine group does when a partner dies
    void reset() noexcept;
    // language: a Dialect, 0 as PT_LANGUAGE says
    void select(std::string_view file, double language) noexcept;
    // INIT says none: as before
    void init_program(std::string_view file) noexcept {
        select(file, static_cast<double>(process_.language));
    }
    void start_program() noexcept;
    // channel_by_hand.cpp: a block comes into the list, and nothing moves; the list is emptied; a
    // key whose label is a start
    void enter(std::string_view text) noexcept;
    void clear_entered() noexcept;
    void hand_key(std::string_view text) noexcept;
    // what runs, or is held, is no program
    bool by_hand() const noexcept { return hand_.block.runs != HandBlock::Of::Nobody; }
    // set by the operator only; for_block: kStartByHand
    void set_mode(ChannelMode mode, bool for_block = false) noexcept;
    ChannelMode mode() const noexcept { return program_.mode; }
    void stop_after_part(bool on) noexcept { production_.stops_after_part = on; }
    // channel_production.cpp: a program that repeats itself ends with its part after so many
    // seconds; 0: no warm-up.
    void warm_up(double seconds) noexcept;
    // Axes are moved by hand in a hold; the machine stores the return path and reports when they
    // are back.
    bool allow_jog_in_hold() noexcept;
    bool jogs_in_hold() const noexcept { return resume_.aside; }
    // The machine moves axes off a path at standstill, whatever record the program is at; it
    // continues when they are back.
    void step_aside() noexcept;
    bool rests() const noexcept { return !path_.planner || at_rest(); }
    bool resets() const noexcept { return program_.resets(); }
    void on_path_again() noexcept { resume_.aside = false; }
    void quit() noexcept;
    void store_changed() noexcept { outbox_.store_changed = resume_.change_due = true; }
    void process_died(Alarm reason, std::string_view detail = {}) noexcept;
    // channel_refusal.cpp: its process has sent what cannot be. It is believed no more.
    bool sends_what_cannot_be() const noexcept {
        return process_.segment && !process_.dead() && path_.inbox.refusal().field;
    }
    void turn_away() noexcept;
    void process_stopped(bool stopped) noexcept;
    // The machine stops for a reason that is not the channel's: along the path, until reset.
    void interrupt() noexcept;
    void fault(Alarm number, std::string_view detail, double value) noexcept {
        raise(number, detail, value);
    }
    void emergency() noexcept;  // forget the path: the axes brake by themselves
    // The effective feed override.
    // The language of what runs: of the selected program, where its job says one; a block by hand
    // is in that of the machine.
    Dialect speaks() const noexcept {
        return program_.mode != ChannelMode::Mdi && !by_hand() &&
                       process_.language != Dialect::Polyturn
                   ? process_.language
                   : core_.config.channels[index_].language;
    }
    double feed_factor() const noexcept {
        constexpr double kMost = 2.0;
        return std::min(panel_.feed_override,
                        speaks() == Dialect::Fagor
                            ? core_.config.channels[index_].fagor_feed_override_max
                            : kMost);
    }
    // The program has set the spindle override: the operator's rests (fagor PRGSSO).
    bool own_spindle_override() const noexcept {
        return program_.control & kControlOwnSpindleOverride;
    }
    // The program only asks for a value of the machine, and asks again.
    bool polls() const noexcept;
    // Switches and keys, as they are set and as they act.
    OperatorPanel& panel() noexcept { return panel_; }
    const OperatorPanel& panel() const noexcept { return panel_; }

    // --- the path driven back and forth (channel_trail.cpp) ---
    void retrace(bool on) noexcept;
    void set_handwheel(bool on, double rate) noexcept;
    bool by_handwheel() const noexcept { return retrace_.wheel.on; }
    // it cannot go further back
    bool handwheel_blocked() const noexcept { return retrace_.wheel.blocked; }
    void pass_waits(std::span<ChannelRunner* const> all) noexcept;

    // --- positioning axes (positioning_axis.cpp), superposed handwheel (superpose.cpp) ---
    // of an axis' limits, that a path leaves to a superposed handwheel
    static constexpr double kOverlayShare = 0.2;
    bool holds_positioning() const noexcept;
    // it moves asynchronously to the path, or its own program is not over
    bool runs_positioning(std::uint32_t axis) const noexcept;
    bool has_steps(std::uint32_t axis) const noexcept { return positioning_.moves(axis); }
    // for its axis, where its program is about to begin
    void queue_up() noexcept;
    void run_steps() noexcept;
    bool breaks_off_positioning() const noexcept {
        return program_.resets() || program_.interrupted() || process_.dead() ||
               program_.emergency();
    }
    double handwheel_share() const noexcept { return retrace_.wheel.share(); }
    void superpose(bool on) noexcept;
    bool superposes() const noexcept { return (panel_.pressed & kKeySuperpose) != 0; }
    // the path that is driven was planned with the handwheel superposed
    bool leaves_room() const noexcept;
    void overlay_moves(std::uint32_t axis, bool moves) noexcept {
        if (moves)
            path_.overlays |= std::uint64_t{1} << (axis % 64);
        else
            path_.overlays &= ~(std::uint64_t{1} << (axis % 64));
    }

    // --- for the clock ---
    // Virtual time may go on: enough records for the horizon, or the process has nothing more to
    // say.
    bool supplied() noexcept;
    bool listens() const noexcept { return process_.listens(); }
    void wake() const noexcept { core_.image.channel_bell[index_].ring(); }
    bool silent_too_long() const noexcept;
    bool can_go_on() const noexcept;  // something of it moves, counts down or waits for an answer
    bool operates() const noexcept { return program_.operates(); }
    // fanuc_lathe 6.3.4: nothing of the block is in progress but the code that the PLC has; not
    // where the program does not wait for its end.
    bool distribution_ended() const noexcept {
        return standing_.phase == Phase::Handshake && !standing_.handshake.unfinished && at_rest();
    }
    bool cuts() const noexcept { return operates() && path_.moving && !path_.rapid; }
    // channel_early.cpp: rapid moves, and what follows them, keep the speed of constant
    // surface speed as it is; one under way gives it the speed of the cut that follows directly,
    // which begins with this axis there.
    bool holds_surface_speed() const noexcept;
    std::optional<double> cut_begins_at(std::uint32_t axis) const noexcept;
    std::uint32_t number() const noexcept { return number_; }
    bool path_moves() const noexcept { return path_.moving; }
    double path_speed() const noexcept { return path_.moving ? path_.step.speed : 0.0; }  // mm/s
    // What was driven until now was planned for other limits or coordinates: it is not driven back.
    void forget_trail() noexcept {
        if (!retrace_.trail.active()) retrace_.trail.clear();
    }
    // Nothing is planned ahead: it is idle, or its program waits for the answer to what is being
    // executed. What changes routes, limits or coordinates then is read by the program before it
    // goes on.
    bool stands() const noexcept {
        if (!process_.segment || !program_.runs()) return true;
        if (retrace_.trail.active()) return false;
        return path_.cursor >= path_.inbox.head(path_.cursor) ||
               (path_.inbox.flags_of(path_.cursor) & kDrains) != 0;
    }
    bool in_handshake() const noexcept { return standing_.phase == Phase::Handshake; }
    std::int32_t m_code() const noexcept {
        return standing_.handshake.m_code;
    }  // given to the PLC last; -1 none

    ChannelState state() const noexcept { return program_.state(); }
    bool idle() const noexcept { return program_.idle(); }
    StopReason stop_reason() const noexcept { return program_.reason(); }
    bool program_runs() const noexcept { return program_.runs(); }
    // Its axes move by the revolutions of this spindle (from 1).
    bool cuts_with(std::uint32_t spindle) const noexcept;
    std::uint32_t line() const noexcept { return shown_.line; }
    // Block of the record that began last.
    std::uint64_t serial() const noexcept { return shown_.serial; }
    // File name of the running record, without folders.
    std::string_view program() noexcept { return process_.program(shown_.file); }

private:
    void strobe_end(StopReason reason) noexcept;
    // State of the record in front of which the path is stopped.
    using Phase = StandingRecord::Phase;

    const PathRecord& record(std::uint64_t index) const noexcept {
        return path_.inbox.record(index);
    }
    // The transformation that leads from the record's coordinates to its axes; none: they are its
    // axes.
    const Kinematics* kinematics_of(const PathRecord& r) const noexcept {
        return path_.inbox.kinematics(r.transform);
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
        return path_.planner->at_rest() && !thread_.moving() && retrace_.trail.at_rest() &&
               !axes_.off_path.any();
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
    bool is_stopped_for_interrupt() noexcept;
    void announce_interrupt() noexcept;
    bool obey_ahead() noexcept;
    void break_off() noexcept;
    // channel_hold.cpp: changes that act in a hold, blocks entered in one
    ResumePlace place_now() const noexcept;
    std::uint64_t first_not_begun() const noexcept;
    bool is_at_late_stop() const noexcept;
    bool rests_in_hold() const noexcept;
    bool stands_in_hold() const noexcept { return !resume_.aside && rests_in_hold(); }
    bool resumes_elsewhere() const noexcept;
    void settle_hold() noexcept;
    void ask_to_go_back(Resume::BackFor why) noexcept;
    void take_answer() noexcept;
    void go_back_to(const ResumePlace& place, bool away = false) noexcept;
    void enter_by_hand(StartPermit permit) noexcept;
    bool may_leave_for_block() const noexcept {
        return program_.is(ChannelState::Held) && !resume_.runs_by_hand() &&
               (resume_.program_left() || stands_in_hold());
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
        return program_.runs() ||
               (retrace_.wheel.on && program_.is(ChannelState::Ended) && !resume_.runs_by_hand());
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
    bool await(const PathRecord& r) noexcept;
    bool limit_torque(const PathRecord& r) noexcept;
    bool find_reference(const PathRecord& r) noexcept;
    void release_stops() noexcept;
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
    ProcessLink process_;
    ProgramState program_;
    OperatorPanel panel_;
    ChannelPath path_;
    PathAxes axes_;
    BlockShown shown_;
    StandingRecord standing_;
    ThreadExecutor thread_;
    PositioningProgram positioning_;
    InterruptWatch interrupts_;
    Retrace retrace_;
    Resume resume_;
    HandBlocks hand_;
    RestartStage restart_;
    Production production_;
    Outbox outbox_;
};

}  // namespace polyturn::kernel
