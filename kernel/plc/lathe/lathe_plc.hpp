// The built-in PLC: a lathe with chucks on its spindles, turrets with driven tools, gear ranges,
// coolant and helpers.
//
//   code            what happens                                             finished
//   M3 M4 M5        CN_SSEL's spindle turns right, left, stops; M3 M4 are    at once: a feed waits
//                   refused while its chuck is open                          for the speed, not
//                                                                            this code
//   M19             CN_SSEL's spindle is oriented (SP_ROT 19, SP_OREQ)       in position (SN_INPOS)
//   N0823's code    its position loop closes where it stops                  in position
//   N0689 to N0690  the builder's own states of the spindle: SP_ROT          at once
//   M41 to M48      gear range 1 to 8, as far as PT_GEAR_RANGES goes: the    after PT_GEAR_TIME
//                   spindle creeps (SP_PAR) until the range is engaged; M40  at creep speed
//                   chooses by S                                             (M40 at once)
//   M8 M9           coolant of the channel on, off                           at once
//   M10 M11         chuck of CN_SSEL's spindle clamps, opens; opening waits  PT_CHUCK_TIME after
//                   for a spindle that M5 stops, and is refused while it turns  that
//   M13 M14 M15     driven tool of the channel's turret right, left, stop    at once
//   T               turret turns in the shorter direction, or forwards only  PT_TURRET_TIME a
//                   (PT_TURRET_FORWARD), to the station of that number, or   station, then
//                   to CN_POTNO where tool management has found the tool in  PT_TURRET_CLAMP; at
//                   its magazine (CN_MGZNO); T0 needs no movement            once without movement
//   M2 M30          the spindles that this channel started stop, its coolant at once
//                   and driven tool too; a reset does the same
//   helpers         each has the codes n and n+1 that its parameter gives, 0:after the time of
//                   there is none (list below)                               the helper
//   PT_M_FOLLOW     n, n+1: the spindle follows its master, as it comes or   when the NC says so
//                   with the phase N0685; n+2: it is free                    (SN_SYNCA): refused
//                                                                            after kSpindleTimeS
//   PT_M_TORQUE     the drive of the axis gives only PT_STOP_TORQUE; n+1: allwhen the NC has let
//                                                                            it go (AN_FIXED)
//   S, B, other M   nothing                                                  at once
//   of an axis      M3 M4 M5 as above; nothing else (AN_PAXFSTR: the codes ofat once
//                   a program that the axis runs by itself)
//
// Helpers: tailstock forwards and back (PT_M_TAILSTOCK), bar feed (PT_M_BAR: opens the chuck,
// feeds, clamps), parts catcher out and in (PT_M_CATCHER), door open and closed (PT_M_DOOR), C axis
// and spindle (PT_M_C_AXIS), and PT_M_SPINDLE + k makes S k+1 the spindle of the channel; axes are
// coupled and set free again by PT_M_SYNC (AP_SYNCR), PT_M_MIX (AP_MIXR), PT_M_SUPER (AP_SPRPNR).
//
// Whose spindle: who gave the last M3, M4 or M19 to it. So the end of one turret's program leaves a
// spindle alone that the other turret has started. Emergency stop and machine off stop everything;
// the turret halts between stations. Lubrication: an impulse of PT_LUBE_TIME whenever an axis has
// travelled its distance (AN_LUBR). Inputs that must be on, 0 for one that is not wired: door
// closed (PT_IN_DOOR), clamping pressure (PT_IN_CHUCK), lubricant (PT_IN_LUBE), bar (PT_IN_BAR),
// emergency stop circuit (PT_IN_ESTOP), power supply (PT_IN_POWER). PT_IN_SETUP is on in setup
// mode. What they say, the kernel's interlocks judge: CP_DOOROPEN, SP_UNCLAMPED, CP_NOLUBE,
// CP_BAREND, CP_TURRETOPEN, CP_TAILOPEN, PLC_ESTOP; at PLC_POWER the axes retract. PT_IN_KEY and
// the two inputs behind it are the key switch (PLC_KEY).
//
// Two spindles may hold one part: one that turns may open when its synchronous partner clamps, and
// clamp what turns along; and a chuck that has been brought against a part (AN_FIXED) clamps only
// when its master is stopped or it runs with it. A reset leaves them coupled until both stand. What
// a program can ask: #1000 + S - 1 spindle S is synchronous (S1 to S8), #1008 + k the channel's
// axis k (from 0) presses against its fixed stop, #1016 no tailstock supports the part.
//
// A refused code is not finished: the channel is stopped, PLC_ALARM names the reason, the channel's
// reset clears both.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/plc/plc_api.h"

namespace polyturn::plc {

inline constexpr double kSpindleTimeS = 15.0;
// after PT_COUPLE_TIMEOUT: the kernel has refused by then
inline constexpr double kCoupleAnswerS = 0.5;
// An output acts one PLC cycle later, and the flags that answer it come with the inputs after that.
inline constexpr std::uint64_t kCyclesUntilAnswer = 3;
// CP_JOGFD without a switch of its own: 12.6 m/min, so that N0315 decides
inline constexpr std::int32_t kJogStep = 20;
inline constexpr std::size_t kChannels = 16, kSpindles = 32, kAxes = 96, kRanges = 8, kMGroups = 16;

// Values of PLC_ALARM; their texts: kernel/plc/lathe/messages.csv.
enum Message : std::int32_t {
    kNoMessage = 0,
    kChuckWhileTurning = 1,  // M11 while the spindle turns
    kTurningWhileOpen = 2,   // M3, M4, M19 while the chuck is open
    kNoSuchStation = 3,      // T beyond PT_TURRET_STATIONS
    // a spindle code, and neither CN_SSEL nor a driven tool names a spindle
    kNoSpindle = 4,
    kSpindleTooSlow = 5,    // standstill or position was not reached within kSpindleTimeS
    kSpindleIsAxis = 6,     // M3, M4, M19 while the drive is a C axis
    kDoorOpen = 7,          // M3, M4 while the door is open
    kTailstockTurning = 8,  // the tailstock goes back while its spindle turns
    kNoPressure = 9,        // M3, M4, M19 without clamping pressure
    kBarEnd = 10,           // bar feed without a bar
    kClampsTurning = 11,    // M10 while the spindle turns and holds nothing together with another
    kNotSynchronous = 12,   // the spindle did not come to its master within kSpindleTimeS
    kStillPressed = 13,     // the axis did not leave its fixed stop
    kNotCoupled = 14,       // the axes were not switched within PT_COUPLE_TIMEOUT
};

// Digital outputs (from 0), for each channel and each spindle.
inline constexpr std::size_t kOutputsPerChannel = 8, kCoolant = 0, kTurretTurns = 1,
                             kTurretLocked = 2, kTailstockOut = 3, kCatcherOut = 4,
                             kDoorUnlocked = 5, kLubricates = 6, kBarFeeds = 7;
inline constexpr std::size_t kOutputsPerSpindle = 2, kFirstSpindleOutput = 128, kChuckClamp = 0,
                             kChuckOpen = 1;

class LathePlc {
public:
    // nullptr, or the name of the signal or parameter that is missing.
    const char* resolve(const PolyturnPlcHost& host);
    void cycle(const PolyturnPlcInputs& in, PolyturnPlcOutputs& out);
    // Int0: the switches that orient spindles (PT_IN_ORIENT) go to SP_OSW at every tick
    // (nct_parameters_part1 8.4).
    const char* resolve_fast(const PolyturnPlcInt0Host& host);
    void run_fast(const std::int32_t* read, std::int32_t* write) const;
    // Saved over power-off: the turrets' positions.
    static PolyturnPlcRetained retained();

private:
    enum Rotation : std::int32_t { kRight = 3, kLeft = 4, kStop = 5, kOrient = 19 };
    enum class Task : std::uint8_t {
        None,
        Coupled,
        Follow,
        Torque,
        Reversed,
        InPosition,
        Standstill,
        Chuck,
        Gear,
        Helper,
        BarOpen,
        BarFeed,
        BarClamp,
        Refused
    };
    enum Helper : std::uint8_t { kTailstock, kBar, kCatcher, kDoor, kHelpers };
    static constexpr std::int32_t kThenNothing = 0, kThenChuck = 1, kThenBar = 2, kThenHelper = 3;
    struct Pending {  // the M code that a channel waits for
        Task task = Task::None;
        std::uint32_t spindle = 0;  // from 1
        // from this cycle on the spindle's flags speak of the new command
        std::uint64_t believe_cycle = 0;
        std::int64_t due_tick = 0;  // done; or a spindle is given up
        std::int32_t range = 0;     // Gear: the new one; Standstill: what follows
        std::int32_t slot = 0;      // Coupled: its code; kThenHelper: its code
    };
    struct Turret {
        std::int32_t station = 1, target = 1;
        std::int32_t step = 0;      // +1, -1 while it turns, 0 at rest
        std::int64_t due_tick = 0;  // when it passes the next station, or is locked
        bool clamping = false;
    };
    struct Channel {
        // strobes already taken
        std::int32_t reset_seen = 0, m_seen = 0, s_seen = 0, t_seen = 0, b_seen = 0;
        std::int32_t finished = 0;  // CP_FIN
        std::int32_t m_code = 0;
        std::int64_t lubricates_until = 0;
        std::uint32_t selected = 0;  // CP_SSEL
        std::array<bool, kHelpers> out{};
        bool coolant = false, t_pending = false;
        Pending pending;
        Turret turret;
        Message message = kNoMessage;
    };
    struct Spindle {
        std::int32_t rotation = kStop;
        std::uint32_t started_by = 0;  // channel from 1; 0 nobody
        std::int32_t range = 1;
        bool chuck_open = false, closes = false, creeps = false, automatic_range = false,
             is_axis = false;
        std::uint8_t follow = 0;   // 1 its master, 2 with the phase
        bool ends_follow = false;  // once it is stopped
    };
    struct ChannelSlots {
        std::int32_t reset, m_strobe, m_code, s_strobe, s_code, t_strobe, t_code, b_strobe,
            selected, magazine, pot;
        std::int32_t m_fin, s_fin, t_fin, b_fin, fin, active_tool, group, door_open, no_lube,
            bar_end, select, turret_open, tail_open, setup, jog_feed, inputs;
    };
    struct SpindleSlots {
        std::int32_t reached, stands, in_position, rotation, close_loop, creep, range, detach,
            unclamped, active_tool, synchronous, follows, follow, phase;
    };
    struct ChannelSettings {
        double turret_time_s, turret_clamp_s, lube_time_s;
        std::array<double, kHelpers> time_s;
        std::array<std::int32_t, kHelpers> code;
        std::array<std::int32_t, kMGroups> group_low, group_high;
        std::int32_t default_spindle;  // N0604
        // turret: its magazine of tool management, 0 none
        std::int32_t stations, magazine, first_pot;
        bool half;  // it also stops between its stations
        std::int32_t first_spindle_code, in_door, in_setup, in_lube, in_bar;
        std::uint32_t driven_spindle;  // from 1; 0 none
        bool forward_only;
    };
    struct SpindleSettings {
        double chuck_time_s, gear_time_s;
        std::array<double, kRanges> range_max;
        std::int32_t ranges, closing_code, state_low, state_high, c_axis_code, in_chuck, in_orient,
            follow_code, master;
    };
    struct View {  // one cycle's inputs and outputs, by meaning
        const PolyturnPlcInputs& in;
        PolyturnPlcOutputs& out;
    };

    // lathe_plc.cpp: strobes, codes, what they wait for
    void take_codes(View view, std::uint32_t channel);
    void start_m(View view, std::uint32_t channel, std::int32_t code);
    void refuse(std::uint32_t channel, Message message);
    void finish_m(View view, std::uint32_t channel);
    void take_axis_codes(View view);
    void watch_pending(View view, std::uint32_t channel);
    void end_of_channel(std::uint32_t channel);
    void stop_everything();
    void write_outputs(View view) const;
    // spindles.cpp
    std::uint32_t selected_of(View view, std::uint32_t channel);
    bool spindle_code(View view, std::uint32_t channel, std::uint32_t selected, std::int32_t code);
    void turn(View view, std::uint32_t channel, std::uint32_t spindle, std::int32_t rotation,
              bool closes = false);
    void chuck(View view, std::uint32_t channel, std::uint32_t spindle, bool open);
    void change_gear(View view, std::uint32_t channel, std::uint32_t spindle, std::int32_t range);
    void choose_range(View view, std::uint32_t spindle, double rpm);
    [[nodiscard]] bool presses(View view, std::uint32_t channel) const;
    bool follow_code(View view, std::uint32_t channel, std::int32_t code);
    void end_follow(View view);
    // The spindle that holds the same part in step with this one and whose chuck is closed; 0 none.
    [[nodiscard]] std::uint32_t partner(View view, std::uint32_t spindle) const;
    [[nodiscard]] Message why_not_turn(View view, std::uint32_t channel,
                                       std::uint32_t spindle) const;
    // devices.cpp
    void start_t(View view, std::uint32_t channel, std::int32_t code);
    void move_turret(View view, std::uint32_t channel);
    std::int32_t step_of(const ChannelSettings& set, std::int32_t station) const;
    std::int32_t station_at(const ChannelSettings& set, std::int32_t step) const;
    // PT_TURRET_TIME is from one station to the next; a half station is half way.
    static double step_time(const ChannelSettings& set) {
        return set.half ? set.turret_time_s / 2 : set.turret_time_s;
    }
    bool helper_code(View view, std::uint32_t channel, std::uint32_t selected, std::int32_t code);
    bool coupling_code(View view, std::uint32_t channel, std::int32_t code);
    bool coupling_step(View view, std::int32_t code, bool give_up);
    bool bar_step(View view, std::uint32_t channel);
    bool torque_code(View view, std::uint32_t channel, std::int32_t code);
    [[nodiscard]] bool torque_step(View view, Pending& pending) const;
    [[nodiscard]] std::int32_t program_inputs(View view, std::uint32_t channel) const;
    void lubricate(View view, std::uint32_t channel);
    [[nodiscard]] bool in_setup(View view, std::uint32_t channel) const {
        const std::int32_t input = channel_settings_[channel - 1].in_setup;
        return input > 0 && view.in.input[input - 1] != 0;
    }
    [[nodiscard]] bool missing(View view, std::int32_t input) const {
        return input > 0 && view.in.input[input - 1] == 0;
    }

    std::int64_t ticks(double seconds) const;
    Channel& at(std::uint32_t channel) { return channels_[channel - 1]; }
    const ChannelSlots& slots(std::uint32_t channel) const { return channel_slots_[channel - 1]; }
    const ChannelSettings& settings(std::uint32_t channel) const {
        return channel_settings_[channel - 1];
    }

    std::array<Channel, kChannels> channels_{};
    std::array<Spindle, kSpindles> spindles_{};
    std::array<ChannelSlots, kChannels> channel_slots_{};
    std::array<SpindleSlots, kSpindles> spindle_slots_{};
    std::array<ChannelSettings, kChannels> channel_settings_{};
    std::array<SpindleSettings, kSpindles> spindle_settings_{};
    enum Coupling : std::uint8_t { kSync, kExchange, kSuper, kCouplings };
    struct AxisCouplings {
        std::array<std::int32_t, kCouplings> code, request, answer;
    };
    std::array<AxisCouplings, kAxes> couplings_{};
    struct AxisTorque {
        std::int32_t code, limit, request, fixed, moves;
        bool on;
    };
    std::array<AxisTorque, kAxes> torque_{};
    std::array<std::int32_t, kAxes> lube_slot_{};
    struct AxisCodes {  // of an axis that runs a program of its own
        std::int32_t strobe, letter, code, fin, enabled;
    };
    std::array<AxisCodes, kAxes> axis_codes_{};
    std::array<std::uint32_t, kAxes> axis_channel_{};
    std::int32_t machine_on_slot_ = 0, emergency_slot_ = 0, message_slot_ = 0, stop_slot_ = 0,
                 in_stop_ = 0, power_slot_ = 0, in_power_ = 0, key_slot_ = 0, in_key_ = 0,
                 group_stride_ = 0;
    double tick_s_ = 0.001, couple_time_s_ = 0;
    bool first_ = true;
    // by the fast task: place of what it reads, place of what it writes
    struct Copied {
        std::int32_t from, to;
    };
    std::array<Copied, kSpindles> copied_{};
    std::size_t copies_ = 0;
    struct Kept {
        std::uint32_t used = 0;  // 0: nothing was kept
        std::array<std::int32_t, kChannels> station{};
    } kept_;
};

}  // namespace polyturn::plc
