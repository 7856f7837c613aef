#include "channels/fagor/variables/tables.hpp"

#include <algorithm>
#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/tools/managed_tools.hpp"
#include "channels/fagor/variables/named.hpp"

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

// The tables of tools and offsets: by number, 0 to 255.
Access table_value(Execution& x, const Target& target, double& value) {
    const double index = target.index;
    const double most = std::min<double>(x.settings.offsets, static_cast<double>(kOffsets) - 1);
    for (const OffsetColumn& column : kColumns) {
        if (column.var != target.row->var) continue;
        if (index < 0 || index > most)
            return variable_fault(x, Alarm::OffsetNumberIllegal, {}, index, most);
        const double raw =
            cell_of(x.core.view().store->offsets[static_cast<std::size_t>(index)], column);
        value = column.field == OffsetField::T ? raw : from_length_plain(x, raw);
        return Access::Ok;
    }
    if (index < 0 || index > 255)
        return variable_fault(x, Alarm::FagorValueRange, target_name(target), index);
    const auto n = static_cast<std::size_t>(index);
    if (target.row->var == Var::TablePocket) {
        value = x.core.path.tool.ref.number == static_cast<std::int64_t>(n) ? 0.0 : -1.0;
        for (std::size_t pocket = 1; pocket < kTools && value < 0; ++pocket)
            if (x.values.tool(ToolField::Pocket, pocket) == index)
                value = static_cast<double>(pocket);
        return Access::Ok;
    }
    const auto field = static_cast<ToolField>(target.row->sub);
    // it is counted elsewhere while the tool cuts
    if (field == ToolField::Used && n >= 1 && managed(x)) {
        if (!x.run.fresh) return Access::NeedsBarrier;
        const ToolRow& row = x.core.port().tool_table()->rows[n - 1];
        value = static_cast<LifeKind>(row.life_kind) == LifeKind::Minutes
                    ? std::nearbyint(row.counter * 100.0)
                    : row.counter;
        return Access::Ok;
    }
    value = x.values.tool(field, n);
    if (target.row->var == Var::NoseWidth) value = from_length_plain(x, value);
    return Access::Ok;
}

Access write_table(Execution& x, const Target& target, double value) {
    const double index = target.index;
    const double most = std::min<double>(x.settings.offsets, static_cast<double>(kOffsets) - 1);
    for (const OffsetColumn& column : kColumns) {
        if (column.var != target.row->var) continue;
        if (index < 1 || index > most)
            return variable_fault(x, Alarm::OffsetNumberIllegal, {}, index, most);
        const bool tip = column.field == OffsetField::T;
        if (tip && (value < 0 || value > 9 || value != std::nearbyint(value)))
            return variable_fault(x, Alarm::FagorValueRange, target_name(target), value);
        const double raw = tip ? value : value * x.modal.unit();
        x.values.write(
            cell_of(x.core.view().store->offsets[static_cast<std::size_t>(index)], column), raw);
        x.core.mark_emitted();
        OffsetWrite told;
        told.table = column.table;
        told.axis = column.axis;
        told.number = static_cast<std::int32_t>(index);
        told.store_table = column.store_table;
        told.field = column.field;
        told.value = raw;
        x.core.sink().offset(told, x.core.at);
        return Access::Ok;
    }
    if (index < 0 || index > 255)
        return variable_fault(x, Alarm::FagorValueRange, target_name(target), index);
    const auto field = static_cast<ToolField>(target.row->sub);
    if (field == ToolField::Offset && (value < 0 || value > most))
        return variable_fault(x, Alarm::OffsetNumberIllegal, {}, value, most);
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
            return variable_fault(x, Alarm::FagorValueRange, target_name(target), value);
    if (field == ToolField::NoseWidth) value *= x.modal.unit();
    x.values.write(x.values.tool(field, static_cast<std::size_t>(index)), value);
    tell_tool(x, field, static_cast<std::size_t>(index), value);
    return Access::Ok;
}

}  // namespace polyturn::channels::fagor
