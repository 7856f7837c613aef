// SETINT, ENABLE, DISABLE, CLRINT: a signal at an input interrupts the program (sinumerik_part3
// 7.12, 11.1).
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there and the routine is called as if it were before that
// block; behind the routine the block is read again, so that what is left of it is driven from
// where the routine has left the axes.
#include "channels/sinumerik/flow/interrupts.hpp"

#include <utility>

#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/geometry/lifting.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/interpreter.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kInputs = kInterruptInputs;

bool interrupt_input(Execution& x, const Value& value, const char* at, int& input) {
    if (!value.is_number() || !(value.number >= 1 && value.number <= kInputs) ||
        value.number != static_cast<int>(value.number))
        return fail_at(x, Alarm::InterruptIllegal, at, 1, {}, value.number);
    input = static_cast<int>(value.number);
    return true;
}

}  // namespace

// What the kernel watches from here on: inputs that have a routine and are not switched off.
void arm_interrupts(Execution& x) {
    Interrupts told;
    bool at_once = false;
    for (const auto& [input, routine] : x.interrupts.routines) {
        if (!routine.enabled) continue;
        told.on = true;
        told.inputs |= 1u << (input - 1);
        told.wires = true;
        at_once = at_once || !routine.at_block_end;
    }
    told.at_block_end = !at_once;
    x.core.mark_emitted();
    x.core.sink().interrupts(told, x.core.at);
    x.run.state_changed = true;
}

// SETINT(input) PRIO=n program BLSYNC LIFTFAST
bool st_setint(Execution& x) {
    const char* const from = x.line.cursor.at();
    Value number;
    int input = 0;
    if (!x.line.cursor.eat('(')) return syntax(x, x.line.cursor.at(), "(");
    if (!expression(x, number) || !interrupt_input(x, number, from, input)) return false;
    if (!x.line.cursor.eat(')')) return syntax(x, x.line.cursor.at(), ")");
    Routine routine;
    while (!x.line.cursor.at_end()) {
        const char* const at = x.line.cursor.at();
        const std::string word = upper(x.line.cursor.name_ahead());
        if (word.empty()) return syntax(x, at, std::string(1, x.line.cursor.peek()));
        x.line.cursor.advance(word.size());
        if (word == "PRIO") {
            Value priority;
            if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
            x.line.cursor.advance(1);
            if (!expression(x, priority)) return false;
            if (!priority.is_number() || !(priority.number >= 1 && priority.number <= 128))
                return fail_at(x, Alarm::ValueOutOfRange, at, 4, "PRIO", priority.number);
        } else if (word == "BLSYNC") {
            routine.at_block_end = true;
        } else if (word == "LIFTFAST") {
            routine.lifts = true;
        } else if (routine.program.empty()) {
            if (!x.files.find_name(word) && !x.files.find_name(word + ".SPF") &&
                !x.files.find_name(word + ".MPF"))
                return fail_at(x, Alarm::SubprogramMissing, at, word.size(), word);
            routine.program = word;
        } else {
            return syntax(x, at, word);
        }
    }
    // its continuation is not specified
    if (routine.program.empty() && routine.lifts)
        return fail_at(x, Alarm::NotBuilt, from, 1, "SETINT LIFTFAST");
    if (routine.program.empty()) return syntax(x, x.line.cursor.at(), "SETINT");
    undo(x, [&x, before = x.interrupts.routines] { x.interrupts.routines = before; });
    x.interrupts.routines[input] = routine;
    if (!x.run.keeps_states) keep_resume_states(x, true);
    arm_interrupts(x);
    return true;
}

bool p_interrupts(Execution& x, Call& c) {  // ENABLE, DISABLE, CLRINT
    const std::string_view name = x.block.procedures.front().first->name;
    int input = 0;
    if (!interrupt_input(x, c.value(0), x.line.cursor.begin(), input)) return false;
    undo(x, [&x, before = x.interrupts.routines] { x.interrupts.routines = before; });
    if (name == "CLRINT")
        x.interrupts.routines.erase(input);
    else if (const auto found = x.interrupts.routines.find(input);
             found != x.interrupts.routines.end())
        found->second.enabled = name == "ENABLE";
    arm_interrupts(x);
    return true;
}

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned input) {
    const auto routine = x_.interrupts.routines.find(static_cast<int>(input));
    if (routine == x_.interrupts.routines.end() || !routine->second.enabled ||
        x_.core.compensating())
        return false;
    const std::string program = routine->second.program;
    const bool lifts = routine->second.lifts;
    if (serial && !resume_at(serial)) return false;
    x_.run.ended = false;
    // increments of the interrupted block count from here
    const AxisValues begin = x_.core.path.programmed;
    for (unsigned i = 0; i < x_.core.view().axis_count; ++i)
        if (const auto now = x_.core.port().axis_taken_over(x_.core.view().axes[i].machine_axis))
            x_.core.take_machine(i, *now);
    if (within) x_.core.taps(false);  // of a tap that is broken off nothing else would end it
    // it stays where it was stopped, and the alarm says why
    if (lifts && !lift_from_contour(x_, begin)) {
        fault(x_.core.fault());
        return false;
    }
    x_.line.here = x_.calls.source->next_position();
    if (!call_program(x_, program, {}, 1, false)) return false;
    x_.calls.levels.back().interrupt = true;
    x_.calls.levels.back().begin_of_block = begin;
    // the pattern goes on behind the routine
    x_.calls.levels.back().holes = std::exchange(x_.modal.holes, nullptr);
    x_.run.called = x_.run.jumped = x_.run.reread = false;
    x_.run.tool_serial = 0;
    x_.run.fresh = x_.run.state_changed = true;
    return true;
}

}  // namespace polyturn::channels::sinumerik
