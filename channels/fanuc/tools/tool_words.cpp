#include "channels/fanuc/tools/tool_words.hpp"

#include <fmt/format.h>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/managed_tool.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::int64_t power_of_ten(unsigned digits) {
    std::int64_t value = 1;
    while (digits--) value *= 10;
    return value;
}

// nct N1414#4: a second table is added for the axes that the PLC selects.
double second_geometry(Execution& x, std::size_t axis, const OffsetCell& cell) {
    return x.settings.second_geometry && x.core.port().second_geometry(static_cast<unsigned>(axis))
               ? cell.second[axis]
               : 0.0;
}

}  // namespace

bool tool_word(Execution& x) {
    std::int64_t value = 0;
    if (!whole_number(x, 'T', value)) return false;
    const ToolCode& code = x.settings.tool;
    const ToolRequest wish = tool_request(x);
    if (wish == ToolRequest::Place) {  // its offset stays
        x.core.path.tool.ref.number = x.modal.last.t = value;
        x.core.at.tool = x.core.path.tool.ref;
        x.core.aux('T', static_cast<double>(value), fmt::format("T{:08}", value),
                   x.settings.t_drains, false, ToolCallBy::Place);
        if (x.settings.t_drains) x.run.wants_barrier = true;
        return true;
    }
    if (x.settings.offsets_by_g) {  // T is the tool alone; offsets come by G codes
        x.core.path.tool.ref.number = x.modal.last.t = value;
        x.core.at.tool = x.core.path.tool.ref;
        x.core.aux('T', static_cast<double>(value), fmt::format("T{}", value), x.settings.t_drains);
        if (x.settings.t_drains) x.run.wants_barrier = true;
        return true;
    }
    const std::int64_t modulus = power_of_ten(code.offset_digits);
    std::int64_t tool = value / modulus;
    auto offset = static_cast<std::int32_t>(value % modulus);
    // the T has been executed
    const bool called = x.run.tool_serial == x.core.at.serial && waits_for_tool(x);
    if (called) {
        std::int64_t own = 0;
        if (!managed_offset(x, false, own)) return false;
        offset = static_cast<std::int32_t>(own);
    }
    ToolState& state = x.core.path.tool;
    // T gg 88 ends the offset of the group's tool; no tool is called, gg is none.
    const bool cancels = !called && x.settings.group_calls && code.offset_digits >= 2 &&
                         offset == 8 * (modulus - 1) / 9;
    if (cancels) {
        offset = 0;
        tool = state.ref.number;
    }
    const int limit = x.core.view().config().offset_count;
    std::int64_t geometry = code.geometry_by_tool ? tool : offset;
    if (code.offset_digits == 0) geometry = code.geometry_by_tool ? tool : state.geometry;
    if (offset == 0 && code.offset_digits != 0) {
        if (x.settings.policy.tools.zero_keeps_tool)
            geometry = code.geometry_by_tool && !code.zero_cancels_geometry ? tool : 0;
        else if (!code.geometry_by_tool && !code.geometry_travels && !code.zero_cancels_geometry)
            geometry = state.geometry;
    }
    if (offset > limit || geometry > limit)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'T', {},
                           static_cast<double>(offset > limit ? offset : geometry), limit);
    state.ref.number = tool;
    state.ref.offset = offset;
    state.geometry = static_cast<std::int32_t>(geometry);
    if (code.offset_digits != 0) state.wear = offset;
    x.modal.last.t = value;
    x.core.at.tool = state.ref;
    // T0303, T33, T3003: as they are written
    const std::string text =
        fmt::format("T{:0{}}", value, code.offset_digits == 2 ? 4 : code.offset_digits + 1);
    // the PLC's turret wants the tool; the event shows the word
    if (!called && !cancels) x.core.aux('T', static_cast<double>(tool), text, x.settings.t_drains);
    if (x.settings.t_drains && !called && !cancels) x.run.wants_barrier = true;
    if (!apply_tool_offsets(x)) return false;
    // A T word alone travels the change of the vector at once, unless it waits for the next move
    // (5002#6).
    const bool alone = x.words.axis_count == 0 && !x.words.has(GGroup::OneShot);
    if (alone && !code.with_next_move && x.core.vector_pending()) {
        return x.core.travel_offset(x.modal.motion->tenths == 0);
    }
    return true;
}

bool apply_tool_offsets(Execution& x) {
    const ToolCode& code = x.settings.tool;
    ToolState& state = x.core.path.tool;
    MachineView& view = x.core.view();
    const OffsetCell& geometry = view.store->offsets[static_cast<std::size_t>(state.geometry)];
    const OffsetCell& wear = view.store->offsets[static_cast<std::size_t>(state.wear)];
    AxisValues shift{}, vector{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double g =
            state.geometry && !x.settings.offsets_by_g
                ? view.from_offset(i, geometry.geometry[k] + second_geometry(x, k, geometry))
                : 0.0;
        const double w =
            state.wear && !x.settings.offsets_by_g ? view.from_offset(i, wear.wear[k]) : 0.0;
        (code.geometry_travels ? vector : shift)[i] += g;
        (code.wear_travels ? vector : shift)[i] += w;
        if (x.modal.length.number) {
            const OffsetCell& cell =
                view.store->offsets[static_cast<std::size_t>(x.modal.length.number)];
            if (x.modal.length.turning)
                shift[i] += view.from_offset(
                    i, cell.geometry[k] + cell.wear[k] + second_geometry(x, k, cell));
            else if (x.modal.length.axes >> i & 1u)
                // a milling tool's length
                shift[i] += x.modal.length.sign * (cell.geometry[2] + cell.wear[2]);
        }
    }
    // nct part 1 15.5, RTL; a head turns them itself
    if (x.settings.offsets_turn && !x.core.transformed() &&
        !x.modal.frames.rotation.is_identity()) {
        Point3 lengths{};
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = view.axis_by_role(kRoles[k]); place >= 0)
                lengths[k] = shift[static_cast<std::size_t>(place)];
        lengths = x.modal.frames.rotation.direction(lengths);
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = view.axis_by_role(kRoles[k]); place >= 0)
                shift[static_cast<std::size_t>(place)] = lengths[k];
    }
    load_nose(x);
    x.core.set_shift(shift);
    x.core.set_wanted(vector);
    return true;
}

// Radius and tip of the offsets in use; a changed value counts from the next corner on.
void load_nose(Execution& x) {
    const ToolCode& code = x.settings.tool;
    ToolState& state = x.core.path.tool;
    const MachineView& view = x.core.view();
    const OffsetCell& geometry = view.store->offsets[static_cast<std::size_t>(state.geometry)];
    const OffsetCell& wear = view.store->offsets[static_cast<std::size_t>(state.wear)];
    state.nose_off = x.settings.policy.tools.nose_needs_offset && state.ref.offset == 0;
    state.nose_radius = state.nose_off ? 0.0
                                       : (state.geometry ? geometry.geometry_r : 0.0) +
                                             (state.wear ? wear.wear_r : 0.0);
    const std::int32_t tip_number = code.tip_from_wear ? state.wear : state.geometry;
    if (x.modal.length.turning && x.modal.length.number)
        state.tip = static_cast<std::int32_t>(
            view.store->offsets[static_cast<std::size_t>(x.modal.length.number)].tip);
    // D, or the lathe offset of G43.7
    if (x.modal.length.radius || (x.modal.length.turning && x.modal.length.number)) {
        const std::int32_t number =
            x.modal.length.radius ? x.modal.length.radius : x.modal.length.number;
        const OffsetCell& cell = view.store->offsets[static_cast<std::size_t>(number)];
        const bool diameter = view.config().kind == ChannelKind::Mill &&
                              params::bit(view.table(), params::n1402_tool_meas, view.channel, 0);
        state.nose_radius = (cell.geometry_r + cell.wear_r) * (diameter ? 0.5 : 1.0);
        state.nose_off = false;
        state.geometry = number;
        if (!x.modal.length.turning) state.tip = 0;
        return;
    }
    state.tip = tip_number ? static_cast<std::int32_t>(
                                 view.store->offsets[static_cast<std::size_t>(tip_number)].tip)
                           : 0;
}

}  // namespace polyturn::channels::fanuc
