// What the fanuc family keeps beside positions and variables: calls, modal words of cycles, what a
// block has begun and not ended. Plain values; the Interpreter holds one of each.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/dialogue.hpp"
#include "channels/fanuc/g_codes.hpp"
#include "channels/fanuc/macro/variables.hpp"
#include "channels/fanuc/text_place.hpp"
#include "channels/program_files.hpp"
#include "channels/state/core.hpp"
#include "channels/text/byte_stream.hpp"

namespace polyturn::channels::fanuc {

// G66: called after each block that moves.
struct ModalCall {
    std::int64_t program = 0;
    std::int64_t repeats = 1;
    bool every_block = false;  // G66.1
    bool armed = false;        // its own block is past
    LocalSet arguments{};
};

// A program that is being run: the main program, a subprogram or a macro.
struct CallLevel {
    FileId file = 0;
    TextPlace resume;          // where the caller goes on
    TextPosition begin;        // first block of the program, for repetitions and jumps
    std::int64_t repeats = 0;  // calls still to come after this one
    bool macro = false;        // it has local variables of its own
    bool by_code = false;      // called by a G, M or T code: no such calls inside
    bool modal_call = false;   // called by G66
    // an interrupt macro: M99 goes back to where the program was interrupted
    bool interrupt = false;
    std::size_t loops = 0;     // entries of loops_ that belong to outer frames
    std::int64_t program = 0;  // its O number
    std::int64_t outer_program = 0;
    LocalSet arguments{};                 // of a macro, for its repetitions
    std::vector<ModalCall> outer_modals;  // a macro called by G66 runs without its own G66
};

struct Loop {
    std::uint8_t number = 0;
    TextPlace at;
};

// The page that G65 H90 to H94 build; it is asked where the program ends that has built it.
struct PatternDialogue {
    bool open = false;   // a page has been begun
    bool menu = false;   // of patterns; otherwise of values
    bool asked = false;  // the machine is stopped at it
    DialoguePage page;
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
struct CornerThen {  // behind a chamfer or corner of the lathe's own form
    bool pending = false, along_z = false;
    int sign = 1;
    char letter = 0;
};

// the line before this one ends in a chamfer or corner R, and compensation is on
struct CornerBefore {
    bool pending = false, rounding = false;
    char letter = 0;               // its word; 0: behind a comma
    double size = 0;               // leg or radius, mm
    std::array<double, 2> from{};  // where that line began, in the plane
    BlockContext at;
};

struct BStep {
    int motion = 0;                  // 0 none, 1 G0, 2 G1
    int feed_mode = 0;               // 0 none, 1 G98, 2 G99
    int one_shot = 0, drilling = 0;  // G number times ten
    bool absolute = false, has_b = false, has_r = false, has_p = false;
    double b = 0, r = 0, q = 0, p = 0, code = 0;
    double feed = 0, feed_turn = 0;  // F read as a feed per minute, and as one per revolution; mm
    char letter = 0;                 // M S T
};

struct ContourText {
    TextPlace first, behind;  // block P; what follows block Q
    std::int64_t last = 0;    // Q
    bool directly = false;    // nothing is between the cycle and block P
};

struct DrillWords {
    double initial = 0, r_level = 0, bottom = 0, q = 0, p = 0, e = 0;
    bool initial_known = false, r_set = false, bottom_set = false, p_set = false, e_set = false;
    std::array<double, 3> aside{};  // I, J, K of fine boring, mm
};

struct Finishing {  // G70 drives the blocks P to Q
    bool active = false;
    std::string_view name;
    std::int64_t last = 0;  // Q
    TextPlace resume;
    std::size_t depth = 0;  // of frames_
    AxisValues start{};
};

// what first blocks have said (fanuc: it stays; nct: for the next block)
struct CycleData {
    std::optional<double> depth, escape, relief_z, relief_x, divisions, peck_return, thread_passes,
        thread_chamfer, tool_angle, least_infeed, thread_allowance;
};

struct OneBlockShift {  // mefi G58, G59: what holds again behind the block
    std::int32_t before = 0;
    const GCode* code = nullptr;
};

struct Measuring {
    // a skip move is before its barrier; it measures the offset
    bool skipping = false, measuring = false;
    unsigned place = 0;
    double target = 0.0, range = 0.0;  // true mm
};

struct RemoteData {  // G5: blocks of binary data come
    bool active = false;
    unsigned axes = 0, filled = 0;
    double unit_minutes = 0.0;
    std::uint64_t blocks = 0;
    std::array<unsigned char, 2 * kChannelAxes + 1> block{};
    std::int64_t silent_since_ms = -1;
    bool override_was_locked = false;
    double feed_was = 0.0;
    FeedMode feed_mode_was = FeedMode::PerMinute;
    ByteStream from;
};

struct ExternalProgram {  // M198: a program text comes through a socket
    bool active = false;
    std::int64_t number = 0, repeats = 1, silent_since_ms = -1;
    std::string text, name;
};

struct BPrograms {
    std::array<std::vector<BStep>, 3> programs;
    std::vector<BStep> draft;
    unsigned registering = 0;  // 1 to 3
    bool single_before = false, single_now = false;
    std::uint64_t ways = 0;  // handed over in this block: G66 does not follow them
};

struct Interruption {  // an interrupt program runs
    bool running = false;
    bool shows_end = false;     // #5001 still gives the end of the interrupted block
    bool again = false;         // the rest of the interrupted block is still to be driven
    bool goes_on = false;       // it is the next to be read
    AxisValues end{}, begin{};  // of the interrupted block, workpiece system
    PathState path;
    CompSide side = CompSide::Off;  // compensation that goes on behind it
    std::array<double, 130> modal_variables{};
};

}  // namespace polyturn::channels::fanuc
