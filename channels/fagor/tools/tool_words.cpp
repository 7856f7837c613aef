#include "channels/fagor/tools/tool_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"

namespace polyturn::channels::fagor {
namespace {

// An expended tool gives way to another one of its family that is not (11.2.2).
bool take_another_of_family(Execution& x, std::int64_t& tool) {
    const auto expended = [&x](std::int64_t n) {
        const double life = x.values.tool(ToolField::Life, static_cast<std::size_t>(n));
        return life > 0 && x.values.tool(ToolField::Used, static_cast<std::size_t>(n)) >= life;
    };
    if (tool <= 0 || !expended(tool)) return true;
    const double family = x.values.tool(ToolField::Family, static_cast<std::size_t>(tool));
    for (std::size_t pocket = 1; pocket < kTools; ++pocket) {
        const auto n = static_cast<std::int64_t>(x.values.tool(ToolField::Pocket, pocket));
        if (n <= 0 || n == tool || expended(n) ||
            x.values.tool(ToolField::Family, static_cast<std::size_t>(n)) != family)
            continue;
        tool = n;
        return true;
    }
    return x.fail_word(*x.words.word('T'), Alarm::FagorToolExpended, {}, static_cast<double>(tool));
}

}  // namespace

bool tool_words(Execution& x) {
    if (!x.words.has('T') && !x.words.has('D')) return true;
    std::int64_t tool = x.core.path.tool.ref.number, offset = -1;
    if (x.words.has('T')) {
        if (!whole(x, *x.words.word('T'), tool)) return false;
        if (tool > 255)
            return x.fail_word(*x.words.word('T'), Alarm::FagorValueRange, "T",
                               static_cast<double>(tool));
        // tool management has chosen (managed_tools.cpp)
        const bool told = x.run.tool_serial == x.core.at.serial;
        if (told && x.settings.change_by_m06) {  // M06 says which of its family it is
            if (x.words.has('D') && !whole(x, *x.words.word('D'), offset)) return false;
            if (offset >
                std::min<std::int64_t>(x.settings.offsets, static_cast<std::int64_t>(kOffsets) - 1))
                return x.fail_word(*x.words.word('D'), Alarm::OffsetNumberIllegal, {},
                                   static_cast<double>(offset),
                                   static_cast<double>(x.settings.offsets));
            x.modal.next_tool = tool;
            x.modal.next_offset = offset;
            return true;
        }
        if (told) tool = x.core.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
        if (!told && !take_another_of_family(x, tool)) return false;
        offset = told ? x.core.port().tool_at_work().value_or(Port::ToolAtWork{}).offset
                      : static_cast<std::int64_t>(
                            x.values.tool(ToolField::Offset, static_cast<std::size_t>(tool)));
    }
    if (x.words.has('D')) {
        if (!whole(x, *x.words.word('D'), offset)) return false;
    }
    const std::int64_t most =
        std::min<std::int64_t>(x.settings.offsets, static_cast<std::int64_t>(kOffsets) - 1);
    if (offset > most)
        return x.fail_word(x.words.has('D') ? *x.words.word('D') : *x.words.word('T'),
                           Alarm::OffsetNumberIllegal, {}, static_cast<double>(offset),
                           static_cast<double>(most));
    if (x.words.has('T') && x.run.tool_serial != x.core.at.serial)
        x.core.aux('T', static_cast<double>(tool), fmt::format("T{}", tool), false);
    if (x.words.has('T') && x.settings.change_by_m06) {
        x.modal.next_tool = tool;
        x.modal.next_offset = offset;
        return true;
    }
    return change_tool(x, tool, offset);
}

bool change_tool(Execution& x, std::int64_t tool, std::int64_t offset) {
    ToolState& state = x.core.path.tool;
    state.ref.number = tool;
    state.ref.offset = static_cast<std::int32_t>(offset);
    state.geometry = state.wear = static_cast<std::int32_t>(offset);
    x.core.at.tool = state.ref;
    load_tool(x);
    return true;
}

// Lengths and wear of the offset in use, both as radii: the next move brings the new tip to where
// the old one was (8.1).
void load_tool(Execution& x) {
    ToolState& state = x.core.path.tool;
    MachineView& view = x.core.view();
    const auto number = static_cast<std::size_t>(state.geometry);
    const bool none = number == 0;
    const OffsetCell& cell = view.store->offsets[number];
    AxisValues vector{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place >= 0 && !none)
            vector[static_cast<std::size_t>(place)] = cell.geometry[k] + cell.wear[k];
    }
    state.nose_off = none;
    state.nose_radius = none ? 0.0 : cell.geometry_r + cell.wear_r;
    state.tip = none ? 0 : static_cast<std::int32_t>(cell.tip);
    x.core.set_wanted(vector);
}

}  // namespace polyturn::channels::fagor
