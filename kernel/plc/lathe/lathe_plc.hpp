// The built-in PLC: a lathe with chucks on its spindles, turrets with driven tools, and coolant.
//
//   code            what happens                                              finished
//   M3 M4           CN_SSEL's spindle turns right, left; refused while its    speed reached (SN_NS, not SN_N0),
//                   chuck is open                                             or standing for a second: S0
//   M5              CN_SSEL's spindle stops                                   standstill (SN_N0)
//   M19             CN_SSEL's spindle is oriented                             in position (SN_INPOS)
//   M8 M9           coolant of the channel on, off                            at once
//   M10 M11         chuck of CN_SSEL's spindle clamps, opens; opening is      after PT_CHUCK_TIME
//                   refused unless the spindle stands
//   M13 M14 M15     driven tool of the channel's turret right, left, stop     speed reached, standstill
//   T               turret goes the shorter way to the station of that        PT_TURRET_TIME a station;
//                   number; T0 and the present station need no movement       at once when there is no movement
//   M2 M30          the spindles that this channel started stop, its          at once
//                   coolant and driven tool too; a reset does the same
//   S, other M      nothing                                                   at once
//
// Whose spindle: who gave the last M3, M4 or M19 to it. So the end of one turret's program leaves a spindle alone that
// the other turret has started. Emergency stop and machine off stop everything; the turret halts between stations.
//
// A refused code is not finished: the channel stands, PLC_ALARM names the reason, the channel's reset clears both.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/plc/plc_api.h"

namespace polyturn::plc {

inline constexpr double kSpindleTimeS = 15.0;
inline constexpr std::size_t kChannels = 16, kSpindles = 32;

// Values of PLC_ALARM.
enum Message : std::int32_t {
    kNoMessage = 0,
    kChuckWhileTurning = 1,  // M11 while the spindle turns
    kTurningWhileOpen = 2,   // M3, M4, M19 while the chuck is open
    kNoSuchStation = 3,      // T beyond PT_TURRET_STATIONS
    kNoSpindle = 4,          // a spindle code, and neither CN_SSEL nor a driven tool names a spindle
    kSpindleTooSlow = 5,     // speed, standstill or position was not reached within kSpindleTimeS
};

// Digital outputs (from 0), for each channel and each spindle.
inline constexpr std::size_t kOutputsPerChannel = 8, kCoolant = 0, kTurretTurns = 1, kTurretLocked = 2;
inline constexpr std::size_t kOutputsPerSpindle = 2, kFirstSpindleOutput = 128, kChuckClamp = 0, kChuckOpen = 1;

class LathePlc {
public:
    // nullptr, or the name of the signal or parameter that is missing.
    const char* resolve(const PolyturnPlcHost& host);
    void cycle(const PolyturnPlcInputs& in, PolyturnPlcOutputs& out);

private:
    enum class Rotation : std::int32_t { Right = 3, Left = 4, Stop = 5, Orient = 19 };
    enum class Task : std::uint8_t { None, Speed, Standstill, InPosition, Chuck, Refused };
    struct Pending {  // the M code that a channel waits for
        Task task = Task::None;
        std::uint32_t spindle = 0;       // from 1
        std::uint64_t believe_cycle = 0; // from this cycle on the spindle's flags speak of the new command
        std::int64_t due_tick = 0;       // Chuck: done; spindle: given up
        std::int64_t stood_tick = 0;     // Speed: when the spindle was last seen to turn, or the code came
    };
    struct Turret {
        std::int32_t station = 1, target = 1;
        std::int32_t step = 0;           // +1, -1 while it turns, 0 at rest
        std::int64_t due_tick = 0;       // when it passes the next station
    };
    struct Channel {
        std::int32_t reset_seen = 0, m_seen = 0, s_seen = 0, t_seen = 0;  // strobes already taken
        std::int32_t finished = 0;       // CP_FIN
        bool coolant = false, t_pending = false;
        Pending pending;
        Turret turret;
        Message message = kNoMessage;
    };
    struct Spindle {
        Rotation rotation = Rotation::Stop;
        std::uint32_t started_by = 0;    // channel from 1; 0 nobody
        bool chuck_open = false;
    };
    struct ChannelSlots {
        std::int32_t reset, m_strobe, m_code, s_strobe, t_strobe, t_code, selected;
        std::int32_t m_fin, s_fin, t_fin, fin, active_tool;
    };
    struct SpindleSlots {
        std::int32_t reached, stands, in_position, rotation, close_loop;
    };

    struct View {  // one cycle's inputs and outputs, by meaning
        const PolyturnPlcInputs& in;
        PolyturnPlcOutputs& out;
    };

    void take_codes(View view, std::uint32_t channel);
    void start_m(View view, std::uint32_t channel, std::int32_t code);
    void start_t(View view, std::uint32_t channel, std::int32_t code);
    void turn(View view, std::uint32_t channel, std::uint32_t spindle, Rotation rotation);
    void refuse(std::uint32_t channel, Message message);
    void finish_m(View view, std::uint32_t channel);
    void watch_pending(View view, std::uint32_t channel);
    void move_turret(View view, std::uint32_t channel);
    void end_of_channel(std::uint32_t channel);
    void stop_everything();
    void write_outputs(View view) const;
    std::int64_t ticks(double seconds) const;
    Channel& at(std::uint32_t channel) { return channels_[channel - 1]; }
    const ChannelSlots& slots(std::uint32_t channel) const { return channel_slots_[channel - 1]; }

    std::array<Channel, kChannels> channels_{};
    std::array<Spindle, kSpindles> spindles_{};
    std::array<ChannelSlots, kChannels> channel_slots_{};
    std::array<SpindleSlots, kSpindles> spindle_slots_{};
    std::array<double, kChannels> turret_time_s_{};
    std::array<double, kSpindles> chuck_time_s_{};
    std::array<std::int32_t, kChannels> stations_{};
    std::array<std::uint32_t, kChannels> driven_spindle_{};  // from 1; 0 none
    std::int32_t machine_on_slot_ = 0, emergency_slot_ = 0, message_slot_ = 0;
    double tick_s_ = 0.001;
    bool first_ = true;
};

}  // namespace polyturn::plc
