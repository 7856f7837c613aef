// Named variables that programs write, and the tables behind them (fagor_8037t part 2, 11.2).
#include <cmath>

#include "channels/fagor/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"

namespace polyturn::channels::fagor {
namespace {

struct OffsetColumn {
    Var var;
    std::string_view table, axis;
    OffsetTable store_table;
    OffsetField field;
};
constexpr OffsetColumn kColumns[] = {
    {Var::TableX, "geometry", "X", OffsetTable::Geometry, OffsetField::X},
    {Var::TableZ, "geometry", "Z", OffsetTable::Geometry, OffsetField::Z},
    {Var::TableTip, "geometry", "T", OffsetTable::Geometry, OffsetField::T},
    {Var::TableRadius, "geometry", "R", OffsetTable::Geometry, OffsetField::R},
    {Var::TableWearX, "wear", "X", OffsetTable::Wear, OffsetField::X},
    {Var::TableWearZ, "wear", "Z", OffsetTable::Wear, OffsetField::Z},
};

double& cell_of(OffsetCell& cell, const OffsetColumn& column) {
    if (column.field == OffsetField::T) return cell.tip;
    if (column.field == OffsetField::R) return cell.geometry_r;
    auto& values = column.store_table == OffsetTable::Geometry ? cell.geometry : cell.wear;
    return values[static_cast<std::size_t>(column.field)];
}

}  // namespace

double Interpreter::from_length_plain(double mm) const { return mm / unit(); }

// The tables of tools and offsets: by number, 0 to 255.
Access Interpreter::table_value(const Target& target, double& value) {
    const double index = target.index;
    const double most = std::min<double>(settings_.offsets, static_cast<double>(kOffsets) - 1);
    for (const OffsetColumn& column : kColumns) {
        if (column.var != target.row->var) continue;
        if (index < 0 || index > most)
            return variable_fault(Alarm::OffsetNumberIllegal, {}, index, most);
        const double raw =
            cell_of(core_.view().store->offsets[static_cast<std::size_t>(index)], column);
        value = column.field == OffsetField::T ? raw : from_length_plain(raw);
        return Access::Ok;
    }
    if (index < 0 || index > 255)
        return variable_fault(Alarm::FagorValueRange, target_name(target), index);
    const auto n = static_cast<std::size_t>(index);
    if (target.row->var == Var::TablePocket) {
        value = core_.path.tool.ref.number == static_cast<std::int64_t>(n) ? 0.0 : -1.0;
        for (std::size_t pocket = 1; pocket < kTools && value < 0; ++pocket)
            if (values_.tool(ToolField::Pocket, pocket) == index)
                value = static_cast<double>(pocket);
        return Access::Ok;
    }
    const auto field = static_cast<ToolField>(target.row->sub);
    // it is counted elsewhere while the tool cuts
    if (field == ToolField::Used && n >= 1 && managed()) {
        if (!fresh_) return Access::NeedsBarrier;
        const ToolRow& row = core_.port().tool_table()->rows[n - 1];
        value = static_cast<LifeKind>(row.life_kind) == LifeKind::Minutes
                    ? std::nearbyint(row.counter * 100.0)
                    : row.counter;
        return Access::Ok;
    }
    value = values_.tool(field, n);
    if (target.row->var == Var::NoseWidth) value = from_length_plain(value);
    return Access::Ok;
}

Access Interpreter::write_table(const Target& target, double value) {
    const double index = target.index;
    const double most = std::min<double>(settings_.offsets, static_cast<double>(kOffsets) - 1);
    for (const OffsetColumn& column : kColumns) {
        if (column.var != target.row->var) continue;
        if (index < 1 || index > most)
            return variable_fault(Alarm::OffsetNumberIllegal, {}, index, most);
        const bool tip = column.field == OffsetField::T;
        if (tip && (value < 0 || value > 9 || value != std::nearbyint(value)))
            return variable_fault(Alarm::FagorValueRange, target_name(target), value);
        const double raw = tip ? value : value * unit();
        values_.write(cell_of(core_.view().store->offsets[static_cast<std::size_t>(index)], column),
                      raw);
        core_.mark_emitted();
        OffsetWrite told;
        told.table = column.table;
        told.axis = column.axis;
        told.number = static_cast<std::int32_t>(index);
        told.store_table = column.store_table;
        told.field = column.field;
        told.value = raw;
        core_.sink().offset(told, core_.at);
        return Access::Ok;
    }
    if (index < 0 || index > 255)
        return variable_fault(Alarm::FagorValueRange, target_name(target), index);
    const auto field = static_cast<ToolField>(target.row->sub);
    if (field == ToolField::Offset && (value < 0 || value > most))
        return variable_fault(Alarm::OffsetNumberIllegal, {}, value, most);
    // Table formats of 11.2.2; angles are ten-thousandths of a degree.
    static constexpr struct {
        ToolField field;
        double least, most;
    } kRanges[] = {
        {ToolField::Family, 0, 255},
        {ToolField::Life, 0, 65'535},
        {ToolField::Used, 0, 9'999'999},
        {ToolField::Pocket, -1, 255},
        {ToolField::NoseAngle, 0, 3'599'999},
        {ToolField::CutAngle, 0, 3'599'999},
        {ToolField::NoseWidth, 0, 99'999.9999},
    };
    for (const auto& range : kRanges)
        if (field == range.field && (value < range.least || value > range.most))
            return variable_fault(Alarm::FagorValueRange, target_name(target), value);
    if (field == ToolField::NoseWidth) value *= unit();
    values_.write(values_.tool(field, static_cast<std::size_t>(index)), value);
    tell_tool(field, static_cast<std::size_t>(index), value);
    return Access::Ok;
}

Access Interpreter::write_named(const Target& target, double value) {
    const VariableRow& row = *target.row;
    if (target.axis && place_of(target.axis) < 0) return Access::Unknown;
    if (!row.writable || (row.shape == Shape::AxisOrIndex && !target.has_index))
        return Access::ReadOnly;
    if (row.live && !fresh_) return Access::NeedsBarrier;
    core_.did();
    // tables are shared: looking ahead writes none, and what depends on it is not known
    if (scanning_) {
        scan_over_ = true;
        return Access::Ok;
    }
    const int place = place_of(target.axis);
    const auto i = static_cast<std::size_t>(place < 0 ? 0 : place);
    MachineView& view = core_.view();
    const auto write_zero = [&](std::int32_t zero_row) {
        const double raw = view.axes[i].rotary ? value : value * unit();
        values_.write(view.store->zeros[static_cast<std::size_t>(zero_row) * kChannelAxes + i],
                      raw);
        core_.mark_emitted();
        const std::string name = work_zero_name(static_cast<std::size_t>(zero_row));
        OffsetWrite told;
        told.table = "work";
        told.axis = view.axes[i].name;
        told.zero_name = name;
        told.number = zero_row;
        told.work = true;
        told.row = zero_row;
        told.place = static_cast<std::int32_t>(i);
        told.value = raw;
        core_.sink().offset(told, core_.at);
    };
    switch (row.var) {
        case Var::PlcZero:
            write_zero(kZeroExternalRow);
            refresh_zero();
            return Access::Ok;
        case Var::ActiveZero: {
            const auto n = static_cast<std::int64_t>(target.index);
            if (n < 54 || n > 59)
                return variable_fault(Alarm::FagorValueRange, target_name(target), target.index);
            // it counts when the offset is chosen the next time
            write_zero(static_cast<std::int32_t>(n - 53));
            return Access::Ok;
        }
        case Var::PlcInputs:
        case Var::PlcOutputs:
        case Var::PlcMarks:
        case Var::PlcRegister:
        case Var::PlcTimer:
        case Var::PlcCounter:
        case Var::PlcMark:
            return plc_value(target, true, value);
        case Var::UsedRadius:
            core_.path.tool.nose_radius = value * unit();
            return Access::Ok;
        case Var::OverrideProgram:
            if (value < 0 || value > 255)
                return variable_fault(Alarm::FagorValueRange, "PRGFRO", value);
            modal_.override_program = std::fmin(value, settings_.override_max);
            return Access::Ok;
        case Var::SpindleOverrideProgram:
            if (value < 0 || value > 255)
                return variable_fault(Alarm::FagorValueRange, "PRGSSO", value);
            modal_.spindle_override_program =
                value == 0 ? 0
                           : std::clamp(value, settings_.spindle_override_min,
                                        settings_.spindle_override_max);
            spindles_.set(
                modal_.spindle_override_program > 0 ? modal_.spindle_override_program / 100.0 : 1.0,
                core_.at);
            tell_control(false);
            core_.mark_emitted();
            return Access::Ok;
        case Var::ProbeInput:
            if (value != 1 && value != 2)
                return variable_fault(Alarm::FagorValueRange, "SELPRO", value);
            modal_.probe_input = value;
            return Access::Ok;
        case Var::ProbeMode:
            if (value != 0 && value != 1)
                return variable_fault(Alarm::FagorValueRange, "PRBMOD", value);
            modal_.probe_mode = value;
            return Access::Ok;
        case Var::Diameter:
            if (value != 0 && value != 1)
                return variable_fault(Alarm::FagorValueRange, "DIAM", value);
            modal_.diameter = value != 0;
            show_diameter();
            return Access::Ok;
        case Var::Parts:
            modal_.parts = value;
            return Access::Ok;
        case Var::Way:  // what is kept is the difference to the way since the start
            values_.write(values_.kept(static_cast<std::size_t>(&row - &variable_row(0)), i),
                          (view.axes[i].rotary ? value : value * unit()) -
                              ways_.way(static_cast<unsigned>(i)));
            return Access::Ok;
        case Var::Kept:
        case Var::KeptAxis:
            if (row.name == "KEYSRC") {  // only while it is 0 (11.2.14)
                if (value < 0 || value > 2 || value != std::nearbyint(value))
                    return variable_fault(Alarm::FagorValueRange, "KEYSRC", value);
                if (values_.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                                 Values::kNoPlace) != 0)
                    return Access::ReadOnly;
            }
            if (row.name == "ANAO" && (target.index < 1 || target.index > 8))
                return variable_fault(Alarm::FagorValueRange, target_name(target), target.index);
            if (row.name == "ANAO" && std::fabs(value) > 10.0)
                return variable_fault(Alarm::FagorValueRange, target_name(target), value);
            // from machine zero, X as a radius; they act when the PLC sets ACTLIM2
            if (row.name == "LIMPL" || row.name == "LIMMI") {
                WorkZone& limits = core_.path.second_limits;
                const bool upper = row.name == "LIMPL";
                (upper ? limits.high : limits.low)[i] =
                    view.axes[i].rotary ? value : value * unit();
                (upper ? limits.has_high : limits.has_low) |= 1u << i;
            }
            values_.write(
                values_.kept(static_cast<std::size_t>(&row - &variable_row(0)),
                             row.shape == Shape::Plain ? Values::kNoPlace
                             : row.shape == Shape::Axis
                                 ? i
                                 : static_cast<std::size_t>(target.index) % Values::kNoPlace),
                value);
            return Access::Ok;
        default:
            return write_table(target, value);
    }
}

double* Interpreter::plc_cell(const Target& target) {
    const double n = target.index;
    const auto within = [n](std::size_t count) { return n >= 1 && n < static_cast<double>(count); };
    const auto i = static_cast<std::size_t>(n < 0 ? 0 : n);
    switch (target.row->var) {
        case Var::PlcRegister:
            return within(Values::kRegisters) ? &values_.plc_register(i) : nullptr;
        case Var::PlcTimer:
            return within(Values::kTimers) ? &values_.timer(i) : nullptr;
        case Var::PlcCounter:
            return within(Values::kCounters) ? &values_.counter(i) : nullptr;
        case Var::PlcMark:
        case Var::PlcMarks:
            return within(Values::kMarks) ? &values_.mark(i) : nullptr;
        case Var::PlcInputs:
            return within(Values::kPins) ? &values_.input(i) : nullptr;
        default:
            return within(Values::kPins) ? &values_.output(i) : nullptr;
    }
}

// One number, one mark, or 32 of them beginning with the named one.
Access Interpreter::plc_value(const Target& target, bool write, double& value) {
    const Var var = target.row->var;
    double* const cell = plc_cell(target);
    if (!cell) return variable_fault(Alarm::FagorValueRange, target_name(target), target.index);
    const bool many = var == Var::PlcMarks || var == Var::PlcInputs || var == Var::PlcOutputs;
    if (!many) {
        if (write)
            values_.write(*cell, var == Var::PlcMark ? (value != 0 ? 1.0 : 0.0) : value);
        else
            value = *cell;
        return Access::Ok;
    }
    const std::size_t count = var == Var::PlcMarks ? Values::kMarks : Values::kPins;
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(write ? value : 0.0));
    double out = 0.0;
    Target one = target;
    for (unsigned k = 0; k < 32; ++k) {
        one.index = target.index + k;
        if (one.index >= static_cast<double>(count)) break;
        double* const bit = plc_cell(one);
        if (write)
            values_.write(*bit, bits >> k & 1u);
        else if (*bit != 0)
            out += std::ldexp(1.0, static_cast<int>(k));
    }
    if (!write) value = out;
    return Access::Ok;
}

// GPOSX N99 P100: what block 99 of program 100 programs for X; 100000 where it does not name it.
Access Interpreter::block_position(const Target& target, double& value) {
    const auto label = static_cast<std::int64_t>(target.index),
               program = static_cast<std::int64_t>(target.second);
    const auto file = find_program(program);
    const auto at = file ? find_label(*file, label) : std::nullopt;
    if (!at)
        return variable_fault(Alarm::FagorBlockUnknown,
                              "N" + std::to_string(label) + " P" + std::to_string(program));
    LineSource& source = files_->source(*file);
    const TextPosition back = source.next_position();
    source.seek(*at);
    std::string_view line;
    Block block;
    Reader reader(*this);
    value = 100'000.0;
    if (source.next(line) == LineSource::Status::Line && reader.read(line, block) == BlockKind::Iso)
        for (unsigned k = 0; k < block.count; ++k)
            if (block.words[k].letter == target.axis) value = block.words[k].value;
    source.seek(back);
    return Access::Ok;
}

}  // namespace polyturn::channels::fagor
