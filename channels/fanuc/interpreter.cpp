#include "channels/fanuc/interpreter.hpp"

#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/macro/variable_writes.hpp"
#include "channels/fanuc/program/barriers.hpp"
#include "channels/fanuc/program/inherited.hpp"
#include "channels/fanuc/program/interrupts.hpp"
#include "channels/fanuc/program/reading.hpp"
#include "channels/fanuc/program/resume.hpp"
#include "channels/fanuc/program/start.hpp"
#include "channels/fanuc/tools/tool_words.hpp"

namespace polyturn::channels::fanuc {

Result<void> Interpreter::start(FileId main) {
    start_program(x_, main);
    return {};
}

Step Interpreter::step() { return fanuc::step(x_); }

void Interpreter::barrier_done() { barrier_passed(x_); }

bool Interpreter::preset_variable(std::string_view name, double value) {
    return fanuc::preset_variable(x_, name, value);
}

void Interpreter::active_codes(std::string& out) const { fanuc::active_codes(x_, out); }

void Interpreter::list_variables(const ShowVariable& show) const {
    fanuc::list_variables(x_, show);
}

void Interpreter::keep_resume_states(bool on) { fanuc::keep_resume_states(x_, on); }

void Interpreter::executed(std::uint64_t serial) {
    x_.way_back.points.executed(serial);
    x_.macro.variables.undo().executed(serial);
}

bool Interpreter::resume_at(std::uint64_t serial) { return go_back_to(x_, serial, false); }

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return x_.way_back.points.may_go_back(x_.core, serial);
}

bool Interpreter::offsets_changed() {
    if (x_.core.reads_ahead() || x_.core.transformed()) return false;
    x_.core.change_offsets([this] { (void)apply_tool_offsets(x_); });
    x_.run.state_changed = true;
    return true;
}

bool Interpreter::starts_away() const { return x_.settings.policy.program.starts_away; }

// nct N1337 #5: only incremental words move along with what was done by hand; every other path is
// the programmed one.
void Interpreter::start_away(const AxisValues& by) {
    if (x_.settings.shifts_when_away) x_.machine.away = by;
}

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned) {
    return interrupt_program(x_, serial, within);
}

bool Interpreter::interrupt_ahead(std::uint64_t serial) {
    return fanuc::interrupt_ahead(x_, serial);
}

void Interpreter::interrupt_arrived() { fanuc::interrupt_arrived(x_); }

std::any Interpreter::carry() const { return inheritance(x_); }

void Interpreter::take_carry(const std::any& before, bool after_reset) {
    inherit(x_, before, after_reset);
}

bool Interpreter::loses_offset(bool by_reset) const {
    return x_.settings.policy.program.offset_ends && !x_.settings.keeps_offset &&
           (by_reset || x_.text.ended_by_code);
}

}  // namespace polyturn::channels::fanuc
