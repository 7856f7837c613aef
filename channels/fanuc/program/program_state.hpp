// Where a program stands in its texts: the line in hand, the calls and loops that are open, how the
// block under way is read, and what held before earlier blocks.
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "channels/fanuc/program/jump_memory.hpp"
#include "channels/fanuc/macro/variables.hpp"
#include "channels/fanuc/modal_state.hpp"
#include "channels/fanuc/program/block_index.hpp"
#include "channels/fanuc/program/text_place.hpp"
#include "channels/fanuc/spindles/turned_spindles.hpp"
#include "channels/program_files.hpp"
#include "channels/state/core.hpp"
#include "channels/state/resume_points.hpp"

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
    std::size_t loops = 0;     // entries of Calls::loops that belong to outer frames
    std::int64_t program = 0;  // its O number
    std::int64_t outer_program = 0;
    LocalSet arguments{};                 // of a macro, for its repetitions
    std::vector<ModalCall> outer_modals;  // a macro called by G66 runs without its own G66
};

struct Loop {
    std::uint8_t number = 0;
    TextPlace at;
};

// The programs that are open, the loops in them, and what G66 calls.
struct Calls {
    std::vector<CallLevel> frames;
    std::vector<Loop> loops;
    // places of DO whose structure is good
    std::vector<std::pair<FileId, std::uint64_t>> checked_loops;
    JumpMemory jumps;  // ends of loops
    std::vector<ModalCall> modal;
    bool hidden = false;  // in a program in which single block does not stop (N1756)
};

// The line in hand, and what is known of the texts.
struct ProgramText {
    LineSource* source = nullptr;
    std::string_view line;
    std::size_t column = 0;      // next byte of `line` to read
    bool line_left = false;      // `line` holds a further block
    std::size_t behind = 0;      // and that one begins here, while the block before it acts
    std::string kept_line;       // `line` while its window moves
    bool ended_by_code = false;  // by M02 or M30
    // a length without a point has been met: the program has others with one, or was warned of
    bool points_judged = false;
    std::vector<std::unique_ptr<BlockIndex>> indexes;  // by file
    std::deque<std::string> external;                  // of programs that came through a socket
};

// How the block under way is read.
struct Reading {
    // live values that may be read while a block is held for its corner
    bool inputs_fresh = false;
    bool only_macros = false;  // of an interrupt program, while the path is on its way to it
    bool contour = false;      // nothing is driven: a cycle looks at its contour
    // of a value that the scanner has asked for
    bool has_pending_fault = false;
    Fault pending_fault;
    // what the world looks like behind a barrier is a mistake
    std::optional<Fault> barrier_fault;
};

// What held before a block.
struct ResumeState {
    PathState path;
    ModalState modal;
    std::vector<CallLevel> frames;
    std::vector<Loop> loops;
    std::vector<ModalCall> modal_calls;
    std::vector<LocalSet> levels;
    // not modal: what an interrupt program has turned stays, an M19 or M3 that is void again has
    // turned nothing
    TurnedSpindles turned;
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

// Back to a block that is not executed yet, and from an interrupt program.
struct WayBack {
    ResumePoints<ResumeState> points;
    Interruption interruption;
    std::shared_ptr<ResumeState> interrupted;  // what held when the program was interrupted
};

}  // namespace polyturn::channels::fanuc
