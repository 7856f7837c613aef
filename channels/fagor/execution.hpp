// What the functions of the language work on: one program in execution, as groups of state. A
// handler takes it as its first argument and uses the groups that its topic needs; it owns no rule
// of its own but how a fault is noted.
//
// A second execution of the same text is a second Execution: a cycle reads its profile by one, and
// compensation with G41 N looks ahead by one (LookAhead).
//
// Programmed numbers are X as the program writes it (diameter or radius); points are in true
// millimetres, X as a radius, before mirror and scale, which are a frame of Core.
#pragma once
#include <string>

#include "channels/engine/block_run.hpp"
#include "channels/fagor/flow/call_frames.hpp"
#include "channels/fagor/flow/interrupt_return.hpp"
#include "channels/fagor/flow/known_programs.hpp"
#include "channels/fagor/flow/look_ahead.hpp"
#include "channels/fagor/flow/resume_state.hpp"
#include "channels/fagor/frames/inclined_axes.hpp"
#include "channels/fagor/grammar/axis_places.hpp"
#include "channels/fagor/grammar/block_words.hpp"
#include "channels/fagor/grammar/expression.hpp"
#include "channels/fagor/grammar/reader.hpp"
#include "channels/fagor/grammar/text_line.hpp"
#include "channels/fagor/modal.hpp"
#include "channels/fagor/motion/loop_plans.hpp"
#include "channels/fagor/motion/probe_state.hpp"
#include "channels/fagor/motion/way_counter.hpp"
#include "channels/fagor/settings.hpp"
#include "channels/fagor/tools/spindle_override.hpp"
#include "channels/fagor/variables/value_host.hpp"
#include "channels/fagor/variables/values.hpp"
#include "channels/state/core.hpp"
#include "channels/state/resume_points.hpp"

namespace polyturn::channels::fagor {

// The stages between Core and the machine that belong to this language.
struct Outlet {
    explicit Outlet(Sink& machine) : spindles(machine), ways(spindles) {}
    SpindleOverride spindles;
    TravelCounter ways;  // the way of each axis
};

// What takes a line apart, and where it gets the values of names from.
struct Parsers {
    explicit Parsers(Execution& x) : values(x), reader(values), expression(values) {}
    ValueHost values;
    Reader reader;
    Expression expression;
};

// Facts of the run that no block takes back.
struct RunFacts {
    bool first_run = true;        // FIRST
    double began_ms = 0.0;        // CYTIME counts from here
    bool change_pending = false;  // an M06 is output; its tool is known when it has been executed
    std::string message;          // the text of the last event: sinks and faults point to it
};

struct Execution {
    Execution(MachineView& view, Sink& sink, Port& port, ProgramFiles& program_files);
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

    // Both note a fault and give false; the second one lies in this word.
    bool fail(Alarm alarm, char letter = 0, std::string detail = {}, double v0 = 0.0,
              double v1 = 0.0);
    bool fail_word(const Word& word, Alarm alarm, std::string detail = {}, double v0 = 0.0,
                   double v1 = 0.0);

    // the machine
    Outlet out;
    Core core;
    Settings settings;
    AxisPlaces places;
    // the program
    KnownPrograms programs;
    CallFrames calls;
    Modal modal;
    Values values;
    Parsers parsers;
    // the block
    engine::BlockRun run;
    TextLine line;
    BlockWords words;
    // topics that remember something of their own
    ProbeState probe;
    InclinedAxes inclined;
    LoopPlans loops;
    LookAhead ahead;
    InterruptReturn interrupt;
    ResumePoints<ResumeState> points;
    RunFacts facts;
};

}  // namespace polyturn::channels::fagor
