// The state of a run of a program: everything that the handlers of words, codes and statements may
// use, in groups. It lives as long as its Interpreter; a cycle that looks at its contour makes one
// more (cycles/contour_reading.cpp).
//
// Handlers are free functions over it, by topic, and the rows of g_codes.cpp point to them. Each
// group has a header that says who writes it; a handler that fails tells Core and returns false.
#pragma once
#include "channels/engine/block_run.hpp"
#include "channels/fanuc/b_axis/b_state.hpp"
#include "channels/fanuc/block_words.hpp"
#include "channels/fanuc/grammar/program_hooks.hpp"
#include "channels/fanuc/grammar/vocabulary.hpp"
#include "channels/fanuc/machine_state.hpp"
#include "channels/fanuc/macro/macro_state.hpp"
#include "channels/fanuc/modal_state.hpp"
#include "channels/fanuc/motion/corner_state.hpp"
#include "channels/fanuc/program/awaited.hpp"
#include "channels/fanuc/program/program_state.hpp"
#include "channels/fanuc/settings.hpp"
#include "channels/program_files.hpp"
#include "channels/state/core.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution {
    Execution(MachineView& view, Sink& sink, Port& port, ProgramFiles& program_files,
              MakeSettings make);
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    Core core;
    ProgramFiles& files;
    MakeSettings make_settings;
    Settings settings;
    Vocabulary vocabulary;
    // the block in hand
    ProgramHooks hooks;
    WordScanner scanner;
    Block block;
    BlockWords words;
    engine::BlockRun run;
    Reading reading;
    // where the program stands
    ProgramText text;
    Calls calls;
    WayBack way_back;
    Awaited awaited;
    // what it has set
    ModalState modal;
    Macro macro;
    BPrograms b_axis;
    Corners corners;
    MachineState machine;
};

}  // namespace polyturn::channels::fanuc
