// A drive as CiA 402 describes it, with a motor behind it: what a real slave would do with the
// words of drive.h. It shares no code with the kernel, and it is strict: a transition that the
// profile does not know does not happen.
//
//   switch on disabled --06h--> ready --07h--> switched on --0Fh--> operating --0Bh--> quick stop
//        ^        ^                                                     |                  |
//        |        '------------------ 00h, 06h (ready) -----------------'<-----------------'
//        '-- 80h (edge) -- fault <-- fault reaction: brakes by its own ramp <-- whatever goes wrong
#pragma once
#include <array>
#include <cstdint>

#include "kernel/drives/drive.h"

namespace polyturn::drives {

class Cia402 {
public:
    explicit Cia402(const PolyturnDriveSetup& setup);
    // One cycle: the command acts for its whole length; the status is that of its end. False: no
    // answer leaves the drive.
    bool cycle(const PolyturnDriveCommand& command, PolyturnDriveStatus& status);
    // No command has come for too long.
    void lost_master() { fault(kHeartbeat); }
    // Answers leave so many cycles late.
    unsigned delay() const { return delay_; }

private:
    enum class State : std::uint8_t {
        SwitchOnDisabled,
        Ready,
        SwitchedOn,
        Operating,
        QuickStop,
        FaultReaction,
        Fault
    };
    static constexpr std::uint16_t kHeartbeat = 0x8130, kFollowing = 0x8611, kEncoder = 0x7305,
                                   kUnderVoltage = 0x3220, kUnknownMode = 0x8612;
    void fault(std::uint16_t code);
    void obey(std::uint16_t control);
    void simulate(std::uint16_t what);
    double wanted_speed(const PolyturnDriveCommand& command);
    double homing_speed(const PolyturnDriveCommand& command);
    void turn(double wanted);
    [[nodiscard]] std::uint16_t status_word() const;
    [[nodiscard]] std::int64_t counts(double position) const;
    [[nodiscard]] bool find_mark(double from, double to, double& at) const;

    PolyturnDriveSetup setup_;
    bool caught_ = false;  // the slide was above hold_at
    State state_ = State::SwitchOnDisabled;
    double position_, speed_ = 0, acceleration_ = 0;  // motor: units, units/s, units/s2
    // told_: csp, last target; ramp_: speed while it brakes by itself
    double slide_, told_ = 0, ramp_ = 0;
    // units that homing has added to what the encoder shows
    double home_shift_ = 0;
    std::uint16_t last_control_ = 0, error_ = 0, simulated_ = 0;
    unsigned delay_ = 0, loses_ = 0, count_ = 0;
    bool positioning_ = false, homing_ = false, homed_ = false, silent_ = false, dead_ = false;
};

}  // namespace polyturn::drives
