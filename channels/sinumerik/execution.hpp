// What a handler may use: the state of the program under way, in groups, and the machine behind
// Core. A handler is a free function of its topic's header; the tables (grammar/tables.hpp) point
// to it:
//
//   bool g_units(Execution& x, const GCode& row);      G command
//   bool a_feed(Execution& x, const Word& word);       address with a value
//   bool f_sin(Execution& x, Call& call);              function (f_) or procedure (p_)
//   bool st_if(Execution& x);                          statement, from x.line.cursor on
//
// False: it has failed (faults.hpp), or the block is read again behind a barrier.
#pragma once
#include "channels/engine/block_run.hpp"
#include "channels/program_files.hpp"
#include "channels/sinumerik/actions/action_state.hpp"
#include "channels/sinumerik/axes/fixed_stop_state.hpp"
#include "channels/sinumerik/coordination/shown_state.hpp"
#include "channels/sinumerik/coordination/text_file_state.hpp"
#include "channels/sinumerik/curve_tables/curve_table.hpp"
#include "channels/sinumerik/flow/block_pass.hpp"
#include "channels/sinumerik/flow/call_state.hpp"
#include "channels/sinumerik/flow/interrupt_state.hpp"
#include "channels/sinumerik/frames/frame_state.hpp"
#include "channels/sinumerik/grammar/block.hpp"
#include "channels/sinumerik/grammar/line_state.hpp"
#include "channels/sinumerik/modal.hpp"
#include "channels/sinumerik/spindles/speed_limit_state.hpp"
#include "channels/sinumerik/tools/tool_table.hpp"
#include "channels/sinumerik/variables/change_state.hpp"
#include "channels/sinumerik/variables/name_state.hpp"
#include "channels/sinumerik/variables/settings.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::sinumerik {

struct Execution {
    Execution(MachineView& view, Sink& sink, Port& port, ProgramFiles& program_files)
        : core(view, sink, port), files(program_files) {}

    Core core;
    ProgramFiles& files;
    Settings settings;

    // the block under way
    engine::BlockRun run;
    BlockPass pass;
    LineState line;
    Block block;
    Blame blame;
    ChangeState changes;

    // from block to block
    Modal modal;
    CallState calls;
    NameState names;
    FrameState frames;
    ToolStore tools;
    CurveTables curve_tables;
    ActionState actions;
    InterruptState interrupts;
    FixedStopState stops;
    SpeedLimitState speed_limits;
    TextFileState texts;
    ShownState shown;
};

}  // namespace polyturn::channels::sinumerik
