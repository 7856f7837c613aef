// What holds from block to block in the fanuc family besides positions, calls and variables: just
// what a resume point keeps. Whoever adds a member here has it in every resume point, interrupt and
// contour.
#pragma once
#include <array>
#include <cstdint>

#include "channels/fanuc/cycles/cycle_state.hpp"
#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/motion/corner_state.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fanuc {

// How words count.
struct InputMode {
    bool absolute = true, inch = false;
    double unit = 1.0;  // mm in a programmed millimetre or inch
};

struct LastCodes {  // #4113, #4114, #4120
    std::int64_t m = 0, n = 0, t = 0;
};

struct BlockControl {  // #3003, #3004
    bool single_block_off = false, no_finish_wait = false;
    int automatic = 0;
};

struct RunningProgram {
    std::int64_t number = 0;    // its O
    bool tape_begun = false;    // a % was read
    bool blocks_begun = false;  // of its text
};

struct Interrupting {  // M96 in force
    bool on = false;
    std::int64_t program = 0;
};

struct LifeInput {  // G10 L3
    enum Mode : std::uint8_t { Off, Register, Change, Forget } mode = Off;
    std::int32_t group = 0;  // that was opened last; 0 none
};

struct FrameChain {
    Frame mirror, scaling, rotation;
};

struct LengthState {  // G43 G44 G43.7, D
    std::int32_t number = 0, radius = 0;
    int sign = 1;
    bool turning = false;
    AxisSet axes = 0;
};

struct PolarPoints {  // G16
    bool on = false, known = false;
    double radius = 0.0, angle = 0.0;
};

struct ModalState {
    // the row of a group that is in force
    const GCode*& in_force(GGroup group) { return active[static_cast<std::size_t>(group)]; }
    const GCode* in_force(GGroup group) const { return active[static_cast<std::size_t>(group)]; }

    const GCode* motion = nullptr;
    const GCode* drilling = nullptr;  // active drilling cycle
    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> active{};
    InputMode input;
    double lead = 0.0;  // of the last thread, mm
    CycleState cycles;
    CornerThen corner_then;
    FrameChain frames;
    PolarPoints polar;
    LengthState length;
    Plane plane_before = Plane::ZX;  // what G13.1 goes back to
    bool parameter_input = false;    // between G10 L50 and G11
    LifeInput life;                  // between G10 L3 and G11
    Interrupting interrupting;
    RunningProgram program;
    LastCodes last;
    BlockControl control;
    double parts = 0;  // #3901
};

}  // namespace polyturn::channels::fanuc
