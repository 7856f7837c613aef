// What holds from block to block in the fanuc family besides positions, calls and variables. Which
// of it a resume point keeps, Interpreter::modal() says.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "channels/fanuc/interpreter_state.hpp"

namespace polyturn::channels::fanuc {

struct ModalState {
    const GCode* motion_ = nullptr;
    std::array<const GCode*, static_cast<std::size_t>(GGroup::Count)> active_{};
    AxisValues cycle_end_{};  // of G90 G92 G94 (G77 to G79), for the axes of cycle_set_
    AxisSet cycle_set_ = 0;
    double cycle_taper_ = 0.0;
    const GCode* drilling_ = nullptr;  // active drilling cycle
    DrillWords drill_;
    Finishing finishing_;  // G70 drives the blocks P to Q
    // what first blocks have said (fanuc: it stays; nct: for the next block)
    CycleData cycle_data_;
    bool absolute_ = true, inch_ = false;
    // moved in the hold (N1337 REL): the next block with axis words decides
    std::optional<AxisValues> away_;
    std::int64_t last_m_ = 0, last_t_ = 0, last_n_ = 0;
    bool parameter_input_ = false;  // between G10 L50 and G11
    LifeInput life_;                // between G10 L3 and G11
    OneBlockShift one_block_;       // mefi G58, G59: what holds again behind the block
    Interrupting interrupting_;
    FrameChain frames_of_;
    LengthState length_;
    Plane plane_before_ = Plane::ZX;  // what G13.1 goes back to
    CornerThen corner_then_;
    CornerBefore corner_before_;
    bool polar_ = false, polar_known_ = false;
    double polar_radius_ = 0.0, polar_angle_ = 0.0;
    double angle_dp_ = 0.0, angle_dq_ = 0.0;  // direction of a line whose end the next block gives
    BlockContext angle_at_;
    corners::Call angle_corner_;  // ,C or ,R at that line's end; of no size: none
    corners::Call block_corner_;  // of the block that is read
    // of the newest blocks with a chamfer or corner R
    std::array<std::uint32_t, 8> corner_lines_{};
    std::array<char, 8> corner_letters_{};  // its word; 0: ,C or ,R
    unsigned corner_count_ = 0;
    std::uint64_t comp_moves_ = ~0ull;  // moves delivered when compensation was switched on
    std::uint16_t comp_code_ = 0;       // G41 or G42, in tenths, as it was programmed last
    double unit_ = 1.0;                 // mm in a programmed millimetre or inch
    double lead_ = 0.0;                 // of the last thread, mm

    // what programs have set in the control
    double parts_ = 0, parts_wanted_ = 0;
    double pattern_ = 0;         // #5900
    std::uint32_t outputs_ = 0;  // #1132
    double outputs_wide_ = 0;    // #1133
    // #3005 without a further effect
    bool settings_iso_ = false, settings_sequence_ = false, settings_tv_ = false;
    double timer_ms_offset_ = 0, timer_h_offset_ = 0;  // #3001, #3002 as the program has set them
    bool printing_ = false;                            // between POPEN and PCLOS
    bool print_blanks_ = false;
    bool polygon_on_ = false, balance_on_ = false;
    bool single_block_off_ = false, no_finish_wait_ = false;  // #3003
    int automatic_control_ = 0;                               // #3004
};

}  // namespace polyturn::channels::fanuc
