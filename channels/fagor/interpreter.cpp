#include "channels/fagor/interpreter.hpp"

#include "channels/engine/block_edges.hpp"
#include "channels/fagor/flow/carry.hpp"
#include "channels/fagor/flow/interrupts.hpp"
#include "channels/fagor/flow/resume.hpp"
#include "channels/fagor/flow/start_end.hpp"
#include "channels/fagor/flow/step.hpp"
#include "channels/fagor/tools/managed_tools.hpp"
#include "channels/fagor/variables/presets.hpp"

namespace polyturn::channels::fagor {

Result<void> Interpreter::start(FileId main) {
    start_program(x_, main);
    return {};
}

Step Interpreter::step() { return fagor::step(x_); }

void Interpreter::barrier_done() { (void)engine::pass_barrier(x_.core, x_.run); }

bool Interpreter::preset_variable(std::string_view name, double value) {
    return fagor::preset_variable(x_, name, value);
}

void Interpreter::preset_stored(const ToolTable& tools, const ToolEdgeTable&, int unit) {
    preset_tools(x_, tools, unit);
}

void Interpreter::keep_resume_states(bool on) { fagor::keep_resume_states(x_, on); }

void Interpreter::executed(std::uint64_t serial) { fagor::executed(x_, serial); }

bool Interpreter::resume_at(std::uint64_t serial) { return fagor::resume_at(x_, serial); }

bool Interpreter::may_resume_at(std::uint64_t serial) const {
    return x_.points.may_go_back(x_.core, serial);
}

bool Interpreter::offsets_changed() { return fagor::offsets_changed(x_); }

bool Interpreter::interrupt(std::uint64_t serial, bool within, unsigned input) {
    return enter_interrupt(x_, serial, within, input);
}

std::any Interpreter::carry() const { return fagor::carry(x_); }

void Interpreter::take_carry(const std::any& before, bool) { fagor::take_carry(x_, before); }

// Screens show the way of moving first, then everything else that holds.
void Interpreter::active_codes(std::string& out) const {
    const Modal& modal = x_.modal;
    const auto add = [&](unsigned number) {
        if (!out.empty()) out += ' ';
        out += 'G';
        if (number < 10) out += '0';
        out += std::to_string(number);
    };
    add(modal.motion);
    for (const unsigned code :
         {modal.plane, modal.corner, modal.comp, modal.feed_code, modal.zero, modal.zero_added})
        if (code) add(code);
    if (modal.zero == 159) out += " N" + std::to_string(modal.zero_number);
    add(modal.absolute ? 90 : 91);
    add(modal.inch ? 70 : 71);
    if (modal.scale != 1.0) add(72);
}

// Arithmetic parameters: local ones of the running level, global, of the user, of the maker.
void Interpreter::list_variables(const ShowVariable& show) const {
    x_.values.each_parameter(
        [&](std::size_t number, double value) { show("P" + std::to_string(number), value); });
}

}  // namespace polyturn::channels::fagor
