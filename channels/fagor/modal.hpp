// Everything that holds from block to block in the language fagor besides positions, calls and
// parameters. Plain: a resume state is a copy.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "channels/fagor/settings.hpp"
#include "channels/fagor/variables/values.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

// MCALL, MEXEC: run after each block that moves.
struct ModalCall {
    enum class Kind : std::uint8_t { None, Subroutine, Program } kind = Kind::None;
    std::int64_t number = 0;
    LocalSet arguments{};
    std::uint32_t given = 0;  // bit n: P<n> was assigned
};

// OPEN, WRITE: programs that programs write. A text never changes: one that is appended to is
// another one.
struct WrittenProgram {
    std::int64_t number = 0;
    std::string title;
    std::shared_ptr<const std::string> text;
};

struct Modal {
    std::uint16_t motion = 0;       // G00 G01 G02 G03 G33 G34
    std::uint16_t plane = 18;       // G16 to G19
    std::uint16_t corner = 7;       // G05 G07 G50 G51
    std::uint16_t comp = 40;        // G40 G41 G42
    std::uint16_t feed_code = 94;   // G94 G95 G32
    std::uint16_t zero = 0;         // 0 none, 54 to 57, 92, 159
    std::uint16_t zero_number = 0;  // of G159
    std::uint16_t zero_added = 0;   // 0, 58, 59
    int collision_blocks = 0;       // G41 N, G42 N
    bool absolute = true, inch = false, diameter = true;
    // mm/min, mm/rev, 1/min; 0: the axes' largest
    double feed_minute = 0.0, feed_revolution = 0.0, feed_inverse = 0.0;
    double feed_of_block = 0.0;   // mm/min that the last G32 block came to
    int gear = 0;                 // M41 to M44; 0 none chosen
    double position_angle = 0.0;  // M19, as programmed
    // where it stopped: whole turns beyond the first are forgotten
    double stands_at = 0.0;
    double speed_limit = 0.0;             // G92 S, 1/min; 0 none
    std::uint32_t mirrored = 0;           // by place
    double scale = 1.0;                   // G72 S
    AxisValues axis_scale{};              // G72 X..; 0 is 1
    double polar_p = 0.0, polar_q = 0.0;  // polar origin, machine coordinates without tool
    // of the path at the end of the last block in the plane
    double direction_p = 0.0, direction_q = 0.0;
    double lead = 0.0;         // of the last thread block
    double end_lead = 0.0;     // that the last G34 ended with
    bool lead_varies = false;  // the last thread block was a G34 with K
    AxisValues withdrawal{};   // G233, mm
    bool withdraws = false;
    double acceleration = 100.0;                                    // G51 A, %
    double look_ahead_error = -1.0;                                 // G51 E, mm; -1: no G51
    double square_angle = -1.0;                                     // G51 B, degrees; -1: none
    int inclined = 0;                                               // G46 S
    std::int64_t next_tool = -1, next_offset = -1;                  // waiting for M06
    double probe_input = 1.0, probe_mode = 0.0;                     // SELPRO, PRBMOD
    double override_program = 0.0, spindle_override_program = 0.0;  // PRGFRO, PRGSSO
    bool stop_disabled = false, hold_disabled = false, one_block = false;  // DSTOP, DFHOLD, ESBLK
    std::int64_t last_label = -1;
    std::uint64_t m_states = 0;  // M00..M44 seen last, for MSn
    // its subroutine has run: the block that called it is read again without it
    std::int32_t m_done = -1;
    double parts = 0.0;  // PARTC
    ModalCall modal_call;
    std::vector<WrittenProgram> written;
    std::int64_t writing = -1;   // program that OPEN has opened
    bool maker_program = false;  // the running program has the attribute O

    double unit() const { return inch ? 25.4 : 1.0; }  // mm that a programmed length of 1 is
};

}  // namespace polyturn::channels::fagor
