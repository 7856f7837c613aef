// The frames of engine::CallStack: a repeated part (RPT) is one too. A resume state keeps a copy of
// them.
#pragma once
#include <cstdint>

#include "channels/engine/call_stack.hpp"
#include "channels/program_files.hpp"
#include "channels/sink.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels::fagor {

// A text that is being run: the main program, a subroutine, another program, a repeated part.
struct CallFrame {
    enum class Kind : std::uint8_t { Main, Subroutine, Program, Repeat } kind = Kind::Main;
    FileId file = 0;
    TextPosition resume;        // where the caller goes on
    std::int64_t program = -1;  // its number
    bool own_level = false;     // it has a set of local parameters
    bool modal = false;         // run for MCALL or MEXEC: no further one inside
    bool interrupt = false;
    bool maker = false;           // attribute O of its file
    std::int32_t m_code = -1;     // subroutine of this M function
    bool m_itself = false;        // the function itself follows
    bool reads_again = false;     // the calling block goes on behind it
    std::uint32_t given = 0;      // CALLP
    std::int64_t runs_left = 0;   // of a modal call with N, of RPT
    TextPosition begin;           // Repeat, and subroutines that run again
    std::uint32_t last_line = 0;  // Repeat
    AxisValues point{};           // interrupt: where the program was left, as programmed
};

using CallFrames = engine::CallStack<CallFrame>;

}  // namespace polyturn::channels::fagor
