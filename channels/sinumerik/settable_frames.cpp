// $P_UIFR[n,axis,TR]: the settable zero offsets as data. What a program writes acts with the next G54 .. G599 (sinumerik_part3 6.2).
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/machine/work_zeros.hpp"

namespace polyturn::channels::sinumerik {

// The store's cell of a component. `cell` stays null for components that are always neutral here.
bool Interpreter::zero_cell(const std::vector<Value>& indices, const char* from, std::size_t length, ZeroCell& at) {
    at = {};
    const double n = indices.empty() || !indices[0].is_number() ? -1 : indices[0].number;
    if (!(n >= 0 && n < settings_.frames)) return fail_at(Alarm::ArrayIndexIllegal, from, length, "$P_UIFR", n);
    if (indices.size() != 3) return fail_at(indices.size() < 3 ? Alarm::NotBuilt : Alarm::ArrayIndexMissing, from, length, "$P_UIFR");
    const int place = indices[1].type == Type::Axis ? indices[1].place() : -1;
    if (place < 0 || place >= static_cast<int>(core_.view().axis_count)) return fail_at(Alarm::AxisArgumentMissing, from, length, "$P_UIFR");
    at.number = static_cast<int>(n);
    const auto row = at.number == 0 ? work_zero_row("G500") : settable_zero_row(static_cast<std::size_t>(at.number));
    if (!row) return fail_at(Alarm::ArrayIndexIllegal, from, length, "$P_UIFR", n);
    at.row = static_cast<std::int32_t>(*row);
    at.place = static_cast<unsigned>(place);
    at.part = upper(indices[2].text);
    if (at.part == "TR") at.cell = &core_.view().store->zeros[*row * kChannelAxes + at.place];
    else if (at.part != "FI" && at.part != "RT" && at.part != "SC" && at.part != "MI") return fail_at(Alarm::ArrayIndexIllegal, from, length, at.part);
    return true;
}

bool Interpreter::settable_value(const std::vector<Value>& indices, const char* from, std::size_t length, Value& value) {
    ZeroCell at;
    if (!zero_cell(indices, from, length, at)) return false;
    const double per_unit = core_.view().axes[at.place].rotary ? 1.0 : unit();
    if (at.cell) value = Value::of_real(core_.view().from_shown(at.place, *at.cell) / per_unit);
    else value = at.part == "MI" ? Value::of_bool(false) : Value::of_real(at.part == "SC" ? 1.0 : 0.0);
    return true;
}

bool Interpreter::write_settable(const std::vector<Value>& indices, const char* from, std::size_t length, const Value& value) {
    ZeroCell at;
    if (!zero_cell(indices, from, length, at)) return false;
    if (!value.is_number()) return fail_at(Alarm::ConversionImpossible, from, length, "$P_UIFR");
    if (!at.cell) {
        if (value.number == (at.part == "SC" ? 1.0 : 0.0)) return true;
        return fail_at(Alarm::NotBuilt, from, length, "$P_UIFR[.., " + at.part + "]");   // the store keeps shifts only
    }
    const double mm = value.number * (core_.view().axes[at.place].rotary ? 1.0 : unit());
    undo([cell = at.cell, before = *at.cell] { *cell = before; });
    *at.cell = core_.view().to_shown(at.place, mm);
    written_zeros_.push_back({at.number, at.row, at.place, *at.cell});
    return true;
}

void Interpreter::tell_written_zeros() {
    for (const WrittenZero& one : written_zeros_) {
        const std::string name = one.number == 0 ? "G500" : one.number < 5 ? "G" + std::to_string(53 + one.number) : "G" + std::to_string(500 + one.number);
        OffsetWrite told;
        told.table = "work";
        told.axis = core_.view().axes[one.place].name;
        told.zero_name = name;
        told.number = one.number;
        told.store_table = OffsetTable::Work;
        told.work = true;
        told.row = one.row;
        told.place = static_cast<std::int32_t>(one.place);
        told.value = one.value;
        core_.mark_emitted();
        core_.sink().offset(told, core_.at);
    }
    written_zeros_.clear();
}

}  // namespace polyturn::channels::sinumerik
