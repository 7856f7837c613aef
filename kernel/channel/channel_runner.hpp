// A channel in the machine's tick: executes the records of its process, in ring order (architecture
// 5): motion through the planner, everything else at standstill or at the instant between two moves
// where the record lies in the ring (channel_path.hpp draws the ring).
//
// A tick: supply() shows the planner what is visible (at most the horizon: PT_HORIZON); run()
// executes the record at the boundary, drives the path and reports what began and ended. The
// machine releases waits between the channels' runs.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "kernel/channel/channel_view.hpp"
#include "kernel/gate/motion_gate.hpp"

namespace polyturn::kernel {

class ChannelRunner : public ChannelView {
public:
    using ChannelView::ChannelView;
    using ChannelView::panel;
    OperatorPanel& panel() noexcept { return c_.panel; }

    // Once its process has made its segment; again for a successor.
    void attach(const ChannelSegment& segment);
    void prepare();  // takes its memory; not in the cyclic thread

    // --- once a tick, in this order ---
    void supply() noexcept;
    void run() noexcept;
    void release_wait(Permit permit) noexcept;  // the meeting took place
    // messages and alarms of those that still wait
    void after_waits(std::span<ChannelRunner* const> all) noexcept;
    // a channel that waits during retrace passes the wait when the others are there
    void pass_waits(std::span<ChannelRunner* const> all) noexcept;
    void queue_up() noexcept;   // for its positioning axis, where its program is about to begin
    void run_steps() noexcept;  // of that program
    void publish(ChannelStatus& status) noexcept;
    // what the channel must know, after the status of this tick is published
    void send_events() noexcept;
    // Virtual time may go on: enough records for the horizon, or the process has nothing more to
    // say.
    bool supplied() noexcept;

    // --- commands, at a tick's start (channel_commands.cpp) ---
    // only_by_hand: a block of the MDI list, or nothing
    void cycle_start(bool only_by_hand = false) noexcept;
    // The program waits at a dialogue: a value that the operator has entered, and the key that ends
    // it.
    void dialogue_value(double value, std::string_view variable) noexcept;
    void dialogue_key(double key) noexcept;
    std::uint32_t check_start_conditions() noexcept;  // ChannelStatus::start_missing, now
    void feed_hold() noexcept;  // the operator: a program may suppress it (#3004)
    void safe_hold() noexcept;  // a door, a dead partner: cannot be suppressed
    // From a block of the program on; `together`: channels that restart too, bit 0 is channel 1;
    // `group`: their restart. False: refused.
    bool restart(double block, ChannelSet together, std::uint32_t group) noexcept;
    // all of its restart group are at their blocks
    void let_restart_begin(bool complete) noexcept { c_.restart.complete = complete; }
    // it goes back to reset with the others; a start that was meant for its block begins nothing
    void end_restart() noexcept;
    // by operator, scenario, or what its machine group does when a partner dies
    void reset() noexcept;
    // language: a Dialect, 0 as PT_LANGUAGE says
    void select(std::string_view file, double language) noexcept;
    // INIT says none: as before
    void init_program(std::string_view file) noexcept {
        select(file, static_cast<double>(c_.process.language));
    }
    void start_program() noexcept;
    // a block comes into the list, and nothing moves; the list is emptied; a key whose label is a
    // start
    void enter(std::string_view text) noexcept;
    void clear_entered() noexcept;
    void hand_key(std::string_view text) noexcept;
    // set by the operator only; for_block: kStartByHand
    void set_mode(ChannelMode mode, bool for_block = false) noexcept;
    void stop_after_part(bool on) noexcept { c_.production.stops_after_part = on; }
    // a program that repeats itself ends with its part after so many seconds; 0: no warm-up
    void warm_up(double seconds) noexcept { c_.production.warm_up_s = seconds; }
    // Axes are moved by hand in a hold; the machine stores the return path and reports when they
    // are back.
    bool allow_jog_in_hold() noexcept;
    // The machine moves axes off a path at standstill, whatever record the program is at; it
    // continues when they are back.
    void step_aside() noexcept;
    void on_path_again() noexcept { c_.resume.aside = false; }
    void retrace(bool on) noexcept;
    void set_handwheel(bool on, double rate) noexcept;
    void superpose(bool on) noexcept;
    // of an axis' limits, that a path leaves to a superposed handwheel
    static constexpr double kOverlayShare = OperatorPanel::kOverlayShare;
    void overlay_moves(std::uint32_t axis, bool moves) noexcept;
    void quit() noexcept;

    // --- what happens to it ---
    void store_changed() noexcept { c_.outbox.store_changed = c_.resume.change_due = true; }
    void process_died(Alarm reason, std::string_view detail = {}) noexcept;
    void turn_away() noexcept;  // its process has sent what cannot be
    void process_stopped(bool stopped) noexcept;
    // The machine stops for a reason that is not the channel's: along the path, until reset.
    void interrupt() noexcept;
    void fault(Alarm number, std::string_view detail, double value) noexcept {
        c_.raise(number, detail, value);
    }
    void emergency() noexcept;  // forget the path: the axes brake by themselves
    // What was driven until now was planned for other limits or coordinates: it is not driven back.
    void forget_trail() noexcept { c_.retrace.forget_driven(); }

private:
    bool partners_let_through(std::span<ChannelRunner* const> all) const noexcept;
};

}  // namespace polyturn::kernel
