// Tools of tool management (fagor_8037t_part2 11.2.2): the tool's number is its data number, its
// family the type number. An expended tool gives way to another of its family; the store says
// which, so T (with TOFFM06: M06) is executed before the rest of its block is read.
#include <cmath>
#include <cstring>

#include "channels/fagor/interpreter.hpp"
#include "ipc/machine/store/tool_fields.hpp"

namespace polyturn::channels::fagor {

void Interpreter::preset_stored(const ToolTable& tools, const ToolEdgeTable&, int unit) {
    for (std::size_t n = 1; n < kTools && n <= tools.rows.size(); ++n) {
        const ToolRow& row = tools.rows[n - 1];
        if (!row.used || (row.unit != 0 && row.unit != unit)) continue;
        values_.tool(ToolField::Offset, n) = row.h_cell;
        values_.tool(ToolField::Family, n) = row.type_number;
        values_.tool(ToolField::Life, n) = row.life;
        values_.tool(ToolField::Used, n) = static_cast<LifeKind>(row.life_kind) == LifeKind::Minutes
                                               ? std::nearbyint(row.counter * 100.0)
                                               : row.counter;
        if (row.pot >= 1 && static_cast<std::size_t>(row.pot) < kTools)
            values_.tool(ToolField::Pocket, static_cast<std::size_t>(row.pot)) =
                static_cast<double>(n);
    }
}

// With TOFFM06 T only chooses: the tool, and so its offset, is known behind M06. One that has no
// subroutine and acts before the moves of its block is executed first, like T; behind the others
// the change is taken over when they have been executed (take_over_change).
bool Interpreter::asks_for_tool() {
    if (managed_serial_ == core_.at.serial || scanning_ || !managed()) return false;
    if (change_pending_ && !take_over_change()) return false;
    const MEntry* const entry = m_entry(6);
    bool changes = false;
    for (unsigned k = 0; k < m_count_ && settings_.change_by_m06; ++k)
        changes =
            changes || (m_words_[k]->value == 6 && !(entry && entry->subroutine) &&
                        !(entry && entry->after_motion) && (has('T') || modal_.next_tool >= 0));
    if (has('T')) {
        const Word& tool = *word('T');
        // reported by tool_words()
        if (tool.value != std::nearbyint(tool.value) || tool.value < 0 || tool.value > 255)
            return false;
        char text[16];
        std::snprintf(text, sizeof text, "T%d", static_cast<int>(tool.value));
        core_.aux('T', tool.value, text, !settings_.change_by_m06, false, ToolCallBy::Substitute);
        managed_serial_ = core_.at.serial;
    }
    if (changes) core_.aux('M', 6, "M6", true);
    if (changes) managed_serial_ = core_.at.serial;
    return changes || (has('T') && !settings_.change_by_m06);
}

// What M06 has changed to: the tool that works now, with the offset that the program has named, or
// its own.
bool Interpreter::take_over_change() {
    change_pending_ = false;
    const Port::ToolAtWork now = core_.port().tool_at_work().value_or(Port::ToolAtWork{});
    const std::int64_t offset = modal_.next_offset >= 0 ? modal_.next_offset : now.offset;
    modal_.next_tool = modal_.next_offset = -1;
    return change_tool(now.number, offset);
}

// TLFN and the like: what the program writes is the store's too, in path order.
void Interpreter::tell_tool(ToolField field, std::size_t n, double value) {
    if (n < 1 || !managed()) return;
    ToolWrite write;
    write.tool = static_cast<std::int32_t>(n);
    const bool minutes = static_cast<LifeKind>(core_.port().tool_table()->rows[n - 1].life_kind) ==
                         LifeKind::Minutes;
    switch (field) {
        case ToolField::Offset:
            write.field = "h";
            break;
        case ToolField::Family:
            write.field = "type";
            break;
        case ToolField::Life:
            write.field = "life";
            break;
        case ToolField::Used:
            write.field = "counter";
            break;
        default:
            return;
    }
    write.value = field == ToolField::Used && minutes ? value / 100.0 : value;
    core_.mark_emitted();
    core_.sink().tool_write(write, core_.at);
}

}  // namespace polyturn::channels::fagor
