#include "channels/fagor/tools/managed_tools.hpp"

#include <cmath>
#include <cstdio>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/tools/m_functions.hpp"
#include "channels/fagor/tools/tool_words.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"

namespace polyturn::channels::fagor {

bool managed(Execution& x) { return x.core.port().tool_table() != nullptr; }

void preset_tools(Execution& x, const ToolTable& tools, int unit) {
    for (std::size_t n = 1; n < kTools && n <= tools.rows.size(); ++n) {
        const ToolRow& row = tools.rows[n - 1];
        if (!row.used || (row.unit != 0 && row.unit != unit)) continue;
        x.values.tool(ToolField::Offset, n) = row.h_cell;
        x.values.tool(ToolField::Family, n) = row.type_number;
        x.values.tool(ToolField::Life, n) = row.life;
        x.values.tool(ToolField::Used, n) =
            static_cast<LifeKind>(row.life_kind) == LifeKind::Minutes
                ? std::nearbyint(row.counter * 100.0)
                : row.counter;
        if (row.pot >= 1 && static_cast<std::size_t>(row.pot) < kTools)
            x.values.tool(ToolField::Pocket, static_cast<std::size_t>(row.pot)) =
                static_cast<double>(n);
    }
}

// With TOFFM06 T only chooses: the tool, and so its offset, is known behind M06. One that has no
// subroutine and acts before the moves of its block is executed first, like T; behind the others
// the change is taken over when they have been executed (take_over_change).
bool asks_for_tool(Execution& x) {
    if (x.run.tool_serial == x.core.at.serial || x.ahead.scans_loops || !managed(x)) return false;
    if (x.facts.change_pending && !take_over_change(x)) return false;
    const MEntry* const entry = m_entry(x, 6);
    bool changes = false;
    for (unsigned k = 0; k < x.words.m_count && x.settings.change_by_m06; ++k)
        changes = changes ||
                  (x.words.m[k]->value == 6 && !(entry && entry->subroutine) &&
                   !(entry && entry->after_motion) && (x.words.has('T') || x.modal.next_tool >= 0));
    if (x.words.has('T')) {
        const Word& tool = *x.words.word('T');
        // reported by tool_words()
        if (tool.value != std::nearbyint(tool.value) || tool.value < 0 || tool.value > 255)
            return false;
        char text[16];
        std::snprintf(text, sizeof text, "T%d", static_cast<int>(tool.value));
        x.core.aux('T', tool.value, text, !x.settings.change_by_m06, false, ToolCallBy::Substitute);
        x.run.tool_serial = x.core.at.serial;
    }
    if (changes) x.core.aux('M', 6, "M6", true);
    if (changes) x.run.tool_serial = x.core.at.serial;
    return changes || (x.words.has('T') && !x.settings.change_by_m06);
}

// What M06 has changed to: the tool that works now, with the offset that the program has named, or
// its own.
bool take_over_change(Execution& x) {
    x.facts.change_pending = false;
    const Port::ToolAtWork now = x.core.port().tool_at_work().value_or(Port::ToolAtWork{});
    const std::int64_t offset = x.modal.next_offset >= 0 ? x.modal.next_offset : now.offset;
    x.modal.next_tool = x.modal.next_offset = -1;
    return change_tool(x, now.number, offset);
}

// TLFN and the like: what the program writes is the store's too, in path order.
void tell_tool(Execution& x, ToolField field, std::size_t n, double value) {
    if (n < 1 || !managed(x)) return;
    ToolWrite write;
    write.tool = static_cast<std::int32_t>(n);
    const bool minutes = static_cast<LifeKind>(x.core.port().tool_table()->rows[n - 1].life_kind) ==
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
    x.core.mark_emitted();
    x.core.sink().tool_write(write, x.core.at);
}

}  // namespace polyturn::channels::fagor
