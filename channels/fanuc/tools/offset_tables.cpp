#include "channels/fanuc/tools/offset_tables.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/tools/tool_words.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr const char* kFieldNames[] = {"X", "Y", "Z", "R", "T"};

}  // namespace

double& cell_of(OffsetCell& cell, OffsetTable table, OffsetField field) {
    const auto k = static_cast<std::size_t>(field);
    if (field == OffsetField::T) return cell.tip;
    if (field == OffsetField::R)
        return table == OffsetTable::Geometry ? cell.geometry_r : cell.wear_r;
    return table == OffsetTable::Geometry ? cell.geometry[k] : cell.wear[k];
}

void write_offset(Execution& x, OffsetTable table, std::int32_t number, OffsetField field,
                  double value) {
    double& cell =
        cell_of(x.core.view().store->offsets[static_cast<std::size_t>(number)], table, field);
    x.macro.variables.note_cell(cell);
    cell = value;
    if (number == x.core.path.tool.geometry || number == x.core.path.tool.wear) load_nose(x);
    OffsetWrite write;
    write.table = table == OffsetTable::Geometry ? "geometry" : "wear";
    write.axis = kFieldNames[static_cast<std::size_t>(field)];
    write.number = number;
    if (const CommonOffsets common = common_offsets(x.core.view());
        static_cast<unsigned>(number) <= common.count)
        write.channel = common.channel;
    write.store_table = table;
    write.field = field;
    write.value = value;
    x.core.mark_emitted();
    x.core.sink().offset(write, x.core.at);
}

void write_zero(Execution& x, std::int32_t row, unsigned place, double value) {
    double& cell = x.core.view().store->zeros[static_cast<std::size_t>(row) * kChannelAxes + place];
    x.macro.variables.note_cell(cell);
    cell = value;
    const std::string name = work_zero_name(static_cast<std::size_t>(row));
    OffsetWrite write;
    write.table = "work";
    write.zero_name = name;
    write.axis = x.core.view().axes[place].name;
    write.number = row;
    write.work = true;
    write.row = row;
    write.place = static_cast<std::int32_t>(place);
    write.value = value;
    write.until_power_off = x.settings.policy.tools.zeros_until_power_off;
    x.core.mark_emitted();
    x.core.sink().offset(write, x.core.at);
    x.core.load_zeros();
}

// Range of an offset value: fanuc_lathe 1.1 (three digits before the point), wear of an nct N1415.
bool offset_value_good(Execution& x, OffsetTable table, double shown) {
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    double limit = 9999.9999;
    if (x.settings.policy.tools.offsets_by_digits) {
        limit = x.modal.input.inch ? 99.9999 * 25.4 : 999.999;
        if (x.core.view().axes[0].increment < 0.0005)
            limit = x.modal.input.inch ? 99.99999 * 25.4 : 999.9999;
    } else if (table == OffsetTable::Wear) {
        const double most = params::get(t, params::n1415_max_amount_of_wear_comp, l);
        // 1.3: the unit of the machine, whatever the program counts in
        const bool inch_machine = params::bit(t, params::n0104_unit_of_measure, l, 0);
        limit = most > 0 ? most * (inch_machine ? 25.4 : 1.0) : inch_machine ? 0.394 * 25.4 : 1.0;
    }
    return std::fabs(shown) <= limit + 1e-9;
}

}  // namespace polyturn::channels::fanuc
