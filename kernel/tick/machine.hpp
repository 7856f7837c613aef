// The cyclic thread's whole machine and the order of a tick (architecture 6, nct_parameters_part1
// 21.6):
//
//   commands   what operator and scenario ask at this tick
//   answers    what other processes owe to this tick: parameter changes, PLC outputs
//   channels   records, path, threads; then the waits, so that all channels of a meeting leave in
//              the same tick
//   spindles   speed and ramp, surface speed from where the axes will be
//   axes       limits, position loop, drives
//   publish    signals, status, then events to the channels, trace, PLC inputs
//
// Commands and answers act at the start of the tick, so a tick is a pure function of what was there
// when it began. The machine knows no clock: the real one (clock_real) and the virtual one
// (clock_virtual) call tick().
#pragma once
#include <array>
#include <memory>

#include "ipc/image/commands.hpp"
#include "kernel/axes/compensation.hpp"
#include "kernel/axes/couplings.hpp"
#include "kernel/axes/inclined_slides.hpp"
#include "kernel/by_hand/axis_jog.hpp"
#include "kernel/by_hand/homing.hpp"
#include "kernel/channel/channel_runner.hpp"
#include "kernel/drives/segment_drives.hpp"
#include "kernel/drives/shared_drive.hpp"
#include "kernel/gate/motion_gate.hpp"
#include "kernel/plc/link/plc_link.hpp"
#include "kernel/protection/guard.hpp"
#include "kernel/spindles/spindle_couplings.hpp"
#include "kernel/tick/command_queue.hpp"
#include "kernel/tick/core.hpp"
#include "kernel/tick/scope.hpp"
#include "kernel/tools/tool_in_work.hpp"
#include "kernel/waits/restart_groups.hpp"

namespace polyturn::kernel {

class Machine {
public:
    Machine(KernelSegment& image, const SupervisorSegment& supervisor, const StoreSegment& store);
    ~Machine();
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    // Not in the cyclic thread.
    // reads parameters and options, opens the drives
    void start();
    // Before start(): where PT_DRIVE 1 and 2 find their drives. What is not given is missing.
    void take_drives(const PolyturnDriveApi* library,
                     std::unique_ptr<SegmentDrives> process) noexcept {
        drive_library_ = library;
        segment_drives_ = std::move(process);
    }
    SegmentDrives* segment_drives() const noexcept { return segment_drives_.get(); }
    void attach_channel(unsigned index, const ChannelSegment& segment);
    void attach_plc(const PlcSegment& segment);
    void take_tables(CompensationTables tables);  // before start()
    void take_room(const Room& room, const MachineConfig& machine) {
        guard_.take_room(room, machine);
    }
    // before the first tick; later by Core::next_shapes
    void take_tool_shapes(const ToolShapes& shapes) { guard_.take_tools(shapes); }

    void tick() noexcept;
    bool ended() const noexcept { return core_.end_run; }

    // The table in core() has changed: everything that parameters say is taken anew. At a tick's
    // start.
    void adopt_parameters() noexcept;
    // Stops everything along the paths, spindles too, until reset.
    void stop_all(Alarm reason, double value = 0) noexcept;
    // The supervisor has died: stops everything; no command that it has left behind acts any
    // more. The run ends at standstill, or after kLeftAloneMostS. At a tick's start.
    void left_alone() noexcept;
    bool is_left_alone() const noexcept { return alone_since_ >= 0; }
    static constexpr double kLeftAloneMostS = 120;  // a large chuck needs time to stop

    Core& core() noexcept { return core_; }
    PlcLink& plc() noexcept { return plc_; }
    CommandQueue& commands() noexcept { return commands_; }
    ChannelRunner& channel(unsigned index) noexcept { return *channels_[index]; }
    const StoreSegment& store_segment() const noexcept { return *store_segment_; }
    bool trace_has_room() const noexcept {
        // P3: how much room; claim() looks itself (P2)
        return trace_ring_.head() -
                   core_.supervisor.trace_tail.tail.load(std::memory_order_acquire) + 1 <
               1024;
    }
    // Virtual time: called when a command that the supervisor must carry out itself is due; returns
    // when it is done.
    void (*on_action)(void*) = nullptr;
    void* on_action_context = nullptr;
    // Nothing moves, counts down or waits for an answer: only a command can change anything
    // (virtual time is stopped).
    bool idle() noexcept;

private:
    friend class CommandTable;
    void take_restarted_processes() noexcept;
    void take_answers() noexcept;
    void take_commands() noexcept;
    bool all_stands() noexcept;
    void start_channels(const Command& command) noexcept;
    void run_command(const Command& command) noexcept;
    void run_channels() noexcept;
    void restart_channel(const Command& command, std::uint32_t channel) noexcept;
    void judge_restarts() noexcept;
    void end_restart(const RestartGroups::Refusal& refusal) noexcept;
    RestartGroups restarts_;
    void jog_command(const Command& command) noexcept;
    double jog_feed(std::uint32_t axis) const noexcept;
    // tool_setter.cpp
    void look_at_setters() noexcept;
    // it must not be moved further in that direction
    bool touches_setter(std::uint32_t channel, std::uint32_t axis, double sign) const noexcept;
    struct Setter {
        // tool setter of spindle 1, 2; workpiece setter of spindle 1, 2
        std::array<bool, 4> on{};
        bool touches() const noexcept { return on[0] || on[1] || on[2] || on[3]; }
        // axis (from 1), negative: travelling in its negative direction
        std::int32_t touched = 0;
        std::uint32_t at = 0;  // which of them touched last, from 1
        // tick of the last refusal: a panel repeats that its key is held
        std::int64_t told = -1'000'000;
    };
    std::array<Setter, kMaxChannels> setters_{};
    bool may_be_moved(std::uint32_t axis, Door door) noexcept;
    void begin_return(std::uint32_t channel) noexcept;
    double by_hand(std::uint32_t axis) const noexcept;
    double handwheel_increment(std::uint32_t address) const noexcept;
    void turn_on(std::uint32_t a, double sign, double way) noexcept;
    void start_jog(Permit permit, std::uint32_t axis, double sign, double speed, double distance,
                   double seconds, bool by_key = false) noexcept;
    // The axis whose drive an address has, and 1 or -1: the direction in which the address counts
    // (nct_parameters_part2 22.4).
    std::uint32_t behind_address(std::uint32_t axis) const noexcept;
    double address_sign(std::uint32_t axis) const noexcept;
    // jogged by its key: address (from 1), whose feed it follows
    std::array<std::uint32_t, kMaxAxes> jog_address_{};
    void go_back() noexcept;
    void turn_handwheels() noexcept;
    void refuse_coupling() noexcept;
    std::array<ToolInWork, kMaxChannels> tool_in_work_;
    void program_wheel(std::uint32_t channel, bool on) noexcept;
    void turn_program(std::uint32_t channel, double clicks) noexcept;
    void give_time(Permit permit, std::uint32_t group, double seconds) noexcept;
    void watch_interlocks() noexcept;
    bool spindle_may_turn(std::uint32_t spindle, std::int32_t wanted) noexcept;
    // interlocks that are broken while a program runs: bit by row
    std::array<std::uint32_t, kMaxChannels> broken_{};
    // SP_ROT was not obeyed: it must come anew, or a program of the spindle's owner be started.
    // Nothing turns when the door is closed.
    struct TurnRefusal {
        std::int32_t code = 0;  // SP_ROT then; 0: nothing is refused
        std::uint64_t run = 0;  // of the owner's program
    };
    std::array<TurnRefusal, kMaxSpindles> turn_refused_{};
    void open_direct_device(unsigned axis);
    void run_jogs() noexcept;
    // inclined_by_hand.cpp
    const InclinedSlides::Slide* slide_of(std::uint32_t axis) const noexcept;
    bool square_rests(const InclinedSlides::Slide& slide) const noexcept;
    bool square_may_come(const InclinedSlides::Slide& slide, std::uint32_t channel) noexcept;
    AxisJog::Limits limits_by_hand(std::uint32_t axis, double speed) const noexcept;
    double room_by_hand(std::uint32_t axis, double sign) const noexcept;
    void stop_carrier(std::uint32_t axis) noexcept;
    void run_inclined_slides() noexcept;
    void open_spindle(unsigned index);
    void open_axis(unsigned index, double at);
    const PolyturnDriveApi& drive_api(DriveSource source, char letter, std::size_t index) noexcept;
    void share_drives() noexcept;
    void reference_command(const Command& command) noexcept;
    void reference_axis(std::uint32_t axis, bool alone) noexcept;
    void run_homing() noexcept;
    void reference_gantry(std::uint32_t master) noexcept;
    void stop_homing() noexcept;
    void watch_drive_reference(std::uint32_t axis) noexcept;
    void check_absolute(std::uint32_t axis, double at) noexcept;
    void watch_absolute(std::uint32_t axis) noexcept;
    void guard_stroke(std::uint32_t axis) noexcept;
    void attach_and_detach(std::uint32_t axis) noexcept;
    void position_signals() noexcept;
    void choose_spindles() noexcept;
    std::int32_t rotation_for(std::uint32_t spindle) noexcept;
    double operator_share(const SpindleUnit& spindle) const noexcept;
    // that acts: SP_ROT, unless a cut still needs the one before
    std::array<std::int32_t, kMaxSpindles> rotation_{};
    std::array<std::int32_t, kMaxChannels> chosen_spindle_{};  // CP_SSEL as it was
    void run_spindles() noexcept;
    double surface_position(SpindleUnit& spindle) const noexcept;
    void retract_gear(std::uint32_t channel) noexcept;
    // retract.cpp: retract when a partner has died or power fails
    void retract_work(std::uint32_t channel) noexcept;
    void run_retracts() noexcept;
    void watch_power() noexcept;
    enum class Retract : std::uint8_t { None, Stopping, Moving };
    std::array<Retract, kMaxChannels> retracts_{};
    bool power_failed_ = false, power_was_out_ = false;
    // superpose.cpp: a handwheel adds its travel to axes of a running program
    void superpose(std::uint32_t axis, double way) noexcept;
    void run_overlays() noexcept;
    struct Overlay {
        AxisJog jog;
        double left = 0;  // turned and not driven yet, mm
    };
    std::array<Overlay, kMaxAxes> overlays_{};
    void run_gear_retracts() noexcept;
    void reset_couplings(std::uint32_t channel) noexcept;
    void spindle_fault(std::uint32_t index) noexcept;
    void run_axes() noexcept;
    void axis_fault(std::size_t a) noexcept;
    // positioning_axis.cpp
    bool start_positioning_axis(std::uint32_t axis, const Core::PositioningRequest& wish) noexcept;
    bool end_positioning(std::uint32_t axis) noexcept;
    double positioning_speed(std::uint32_t axis) const noexcept;
    void run_positioning() noexcept;
    std::array<Core::PositioningRequest, kMaxAxes> positioning_axes_{};  // what is being driven
    void watch_contours() noexcept;
    std::array<bool, kMaxAxes> pax_request_{};  // AP_PAXR as it was
    void protect() noexcept;
    void watch_fixed_stop(std::uint32_t axis) noexcept;
    std::array<double, kMaxAxes> last_measured_{};
    std::array<bool, kMaxAxes> coming_back_{};  // released from its fixed stop
    void supervise() noexcept;
    void publish() noexcept;
    void trace() noexcept;
    void watch_signals() noexcept;
    void set_state(MachineState state) noexcept;
    // power_on.cpp
    MachineStep step_now() const noexcept;
    void watch_step() noexcept;
    ShortText missing_for_on() const noexcept;
    void release_stop() noexcept;
    void press_machine_on() noexcept;
    void switch_on() noexcept;
    void watch_stop_circuit() noexcept;
    MachineStep step_ = MachineStep::Off;
    // machine on was pressed: the tick at which it is on; -1: it was not
    std::int64_t switch_on_at_ = -1;
    // for the axes to rest: the emergency stop's release, and machine on behind it
    bool release_waits_ = false, on_waits_ = false;
    void show_free_parameters() noexcept;
    void count_totals() noexcept;
    void emergency_stop(Alarm reason, std::uint32_t channel, std::string_view detail,
                        double value) noexcept;
    void partner_death(unsigned index) noexcept;
    void process_died(std::uint32_t slot) noexcept;
    void process_stopped(std::uint32_t slot, bool stopped) noexcept;
    void reset_machine() noexcept;
    template <class Act>
    void each_channel(const Command& command, Act act) noexcept;

    const StoreSegment* store_segment_;
    Core core_;
    CommandQueue commands_;
    PlcLink plc_;
    std::array<std::unique_ptr<ChannelRunner>, kMaxChannels> channels_;
    std::array<ChannelRunner*, kMaxChannels> runners_{};
    std::array<AxisJog, kMaxAxes> jogs_{};
    const PolyturnDriveApi* drive_library_ = nullptr;
    std::unique_ptr<SegmentDrives> segment_drives_;  // PT_DRIVE 2
    std::array<std::unique_ptr<SharedDrive>, kMaxSpindles> shared_drives_{};
    Couplings couplings_;
    InclinedSlides slides_;
    Compensation compensation_;
    Guard guard_;
    std::array<bool, kMaxAxes> guarded_{};  // AN_GUARD
    SpindleCouplings spindle_couplings_;
    // G81.8 taken out of the work: the axes stop, go N1804 away with the gear closed, and it opens
    // if N1800 says so.
    enum class GearRetract : std::uint8_t { None, Stopping, Moving };
    std::array<GearRetract, kMaxChannels> gear_retract_{};
    std::array<bool, kMaxChannels> gear_request_{};  // CP_EGBRRQ as it was
    std::array<Homing, kMaxAxes> homing_{};
    // Jog in hold: positions that the axes of a channel left, last first for the return.
    struct ReturnPath {
        static constexpr std::size_t kMost = 64;
        std::array<std::uint8_t, kMost> axis{};
        std::array<double, kMost> from{};
        std::array<bool, kMost> alone{};  // an inclined slide that did not take Z along
        std::size_t count = 0;
        bool going = false;
        void add(std::uint32_t which, double where, bool by_itself = false) noexcept {
            axis[count] = static_cast<std::uint8_t>(which);
            alone[count] = by_itself;
            from[count++] = where;
        }
    };
    std::array<ReturnPath, kMaxChannels> return_path_{};
    // By machine group: a handwheel is the time of its programs; what it has been turned and is not
    // driven yet, s.
    std::array<bool, kMaxChannels + 1> program_handwheel_{}, program_handwheel_shown_{};
    std::array<double, kMaxChannels + 1> program_time_{};
    // collected pulses that wait for the axis, mm
    std::array<double, kMaxAxes> handwheel_left_{};
    // N2400 HnM: last tick in which the handwheel that moves it was turned; 0: none
    std::array<std::int64_t, kMaxAxes> handwheel_turned_{};
    // wanted, and not begun: an axis of a lower order comes first
    std::array<bool, kMaxAxes> to_reference_{};
    std::array<bool, kMaxAxes> absolute_seen_{};  // its encoder has reported the axis' position
    std::array<bool, kMaxAxes> drive_ready_{};    // AP_RPE at the last tick
    std::array<double, kMaxAxes> lubricated_{};   // travel since AN_LUBR, mm
    struct Watch {
        bool plc = false, is_double = false;
        std::uint32_t slot = 0;
        double last = 0;
    };
    double watched_value(const Watch& watch) const noexcept;
    void note_coupling(CoupledSince& kept, std::uint32_t master, std::uint32_t added,
                       std::uint32_t route, std::uint32_t owner) noexcept;
    std::array<CoupledSince, kMaxAxes> axis_coupled_{};
    std::array<CoupledSince, kMaxSpindles> spindle_coupled_{};
    Scope scope_;
    std::array<Watch, kMaxWatches> watches_{};
    std::size_t watch_count_ = 0;
    bool plc_late_ = false;
    std::int64_t alone_since_ = -1;  // tick at which the supervisor had died; -1: it lives
    std::int32_t builder_message_ = 0, builder_note_ = 0;
    RingProducer<RingHead<TraceSample, 1024>> trace_ring_;
    TraceSample pending_trace_{};
    bool trace_pending_ = false;
    std::uint64_t trace_dropped_ = 0;
    std::uint64_t store_version_ = 0;
};

}  // namespace polyturn::kernel
