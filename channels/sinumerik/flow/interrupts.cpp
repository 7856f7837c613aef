// SETINT, ENABLE, DISABLE, CLRINT: a signal at an input interrupts the program (sinumerik_part3
// 7.12, 11.1).
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there and the routine is called as if it were before that
// block; behind the routine the block is read again, so that what is left of it is driven from
// where the routine has left the axes.
#include <cmath>
#include <utility>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kInputs = kInterruptInputs;

}  // namespace

// What the kernel watches from here on: inputs that have a routine and are not switched off.
void Interpreter::arm_interrupts() {
    Interrupts told;
    bool at_once = false;
    for (const auto& [input, routine] : routines_) {
        if (!routine.enabled) continue;
        told.on = true;
        told.inputs |= 1u << (input - 1);
        told.wires = true;
        at_once = at_once || !routine.at_block_end;
    }
    told.at_block_end = !at_once;
    core_.mark_emitted();
    core_.sink().interrupts(told, core_.at);
    state_changed_ = true;
}

bool Interpreter::interrupt_input(const Value& value, const char* at, int& input) {
    if (!value.is_number() || !(value.number >= 1 && value.number <= kInputs) ||
        value.number != static_cast<int>(value.number))
        return fail_at(Alarm::InterruptIllegal, at, 1, {}, value.number);
    input = static_cast<int>(value.number);
    return true;
}

// SETINT(input) PRIO=n program BLSYNC LIFTFAST
bool Interpreter::st_setint() {
    const char* const from = cursor_.at();
    Value number;
    int input = 0;
    if (!cursor_.eat('(')) return syntax(cursor_.at(), "(");
    if (!expression(number) || !interrupt_input(number, from, input)) return false;
    if (!cursor_.eat(')')) return syntax(cursor_.at(), ")");
    Routine routine;
    while (!cursor_.at_end()) {
        const char* const at = cursor_.at();
        const std::string word = upper(cursor_.name_ahead());
        if (word.empty()) return syntax(at, std::string(1, cursor_.peek()));
        cursor_.advance(word.size());
        if (word == "PRIO") {
            Value priority;
            if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
            cursor_.advance(1);
            if (!expression(priority)) return false;
            if (!priority.is_number() || !(priority.number >= 1 && priority.number <= 128))
                return fail_at(Alarm::ValueOutOfRange, at, 4, "PRIO", priority.number);
        } else if (word == "BLSYNC") {
            routine.at_block_end = true;
        } else if (word == "LIFTFAST") {
            routine.lifts = true;
        } else if (routine.program.empty()) {
            if (!files_->find_name(word) && !files_->find_name(word + ".SPF") &&
                !files_->find_name(word + ".MPF"))
                return fail_at(Alarm::SubprogramMissing, at, word.size(), word);
            routine.program = word;
        } else {
            return syntax(at, word);
        }
    }
    // its continuation is not specified
    if (routine.program.empty() && routine.lifts)
        return fail_at(Alarm::NotBuilt, from, 1, "SETINT LIFTFAST");
    if (routine.program.empty()) return syntax(cursor_.at(), "SETINT");
    undo([this, before = routines_] { routines_ = before; });
    routines_[input] = routine;
    if (!keep_states_) keep_resume_states(true);
    arm_interrupts();
    return true;
}

bool Interpreter::p_interrupts(Call& c) {  // ENABLE, DISABLE, CLRINT
    const std::string_view name = block_.procedures.front().first->name;
    int input = 0;
    if (!interrupt_input(c.value(0), cursor_.begin(), input)) return false;
    undo([this, before = routines_] { routines_ = before; });
    if (name == "CLRINT")
        routines_.erase(input);
    else if (const auto found = routines_.find(input); found != routines_.end())
        found->second.enabled = name == "ENABLE";
    arm_interrupts();
    return true;
}

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned input) {
    const auto routine = routines_.find(static_cast<int>(input));
    if (routine == routines_.end() || !routine->second.enabled || core_.compensating())
        return false;
    const std::string program = routine->second.program;
    const bool lifts = routine->second.lifts;
    if (serial && !resume_at(serial)) return false;
    ended_ = false;
    // increments of the interrupted block count from here
    const AxisValues begin = core_.path.programmed;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (const auto now = core_.port().axis_taken_over(core_.view().axes[i].machine_axis))
            core_.take_machine(i, *now);
    if (within) core_.taps(false);  // of a tap that is broken off nothing else would end it
    // it stays where it was stopped, and the alarm says why
    if (lifts && !lift_from_contour(begin)) {
        fault(core_.fault());
        return false;
    }
    here_ = source_->next_position();
    if (!call_program(program, {}, 1, false)) return false;
    levels_.back().interrupt = true;
    levels_.back().begin_of_block = begin;
    // the pattern goes on behind the routine
    levels_.back().holes = std::exchange(modal_.holes, nullptr);
    called_ = jumped_ = reread_ = false;
    managed_serial_ = 0;
    fresh_ = state_changed_ = true;
    return true;
}

// LIFTFAST: before the routine the tool leaves the contour in rapid, with the words of the thread's
// retraction (sinumerik_part2 10.10.4): DILF, ALF, LFTXT, LFWP, or to POLF by LFPOS. `begin`: where
// the interrupted block began, which gives the tangent.
bool Interpreter::lift_from_contour(const AxisValues& begin) {
    AxisValues target = core_.path.programmed;
    const auto leave = [&](std::size_t place, double by) { target[place] += by; };
    if (active(46) == 3) {
        lift_to_positions(leave);
    } else {
        const auto [p, q] = plane_places();
        const double by_p = target[p] - begin[p], by_q = target[q] - begin[q];
        const bool along_p = std::fabs(by_p) >= std::fabs(by_q);
        if (!lift_in_plane(along_p ? p : q, (along_p ? by_p : by_q) < 0 ? -1.0 : 1.0,
                           LiftSide::FromEdge, leave))
            return false;
    }
    if (target == core_.path.programmed) return true;
    written_system_["$AC_LIFTFAST"] = Value::of_int(1);
    return within_areas(target) && core_.rapid(target);
}

}  // namespace polyturn::channels::sinumerik
