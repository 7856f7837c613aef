// Length offsets by G codes (nct part 1 14.2 C08, 15.5 TCM, 15.6), and G5.1.
#include "channels/fanuc/tools/g_length.hpp"

#include <array>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/managed_tool.hpp"
#include "channels/fanuc/tools/tool_words.hpp"
#include "channels/state/tip_control.hpp"

namespace polyturn::channels::fanuc {

// G43 G44 H: the length of a milling offset; G43.7 H: all of a turning offset; G49: none. G43.4:
// the tip of the tool goes where the program says while head and table turn (nct part 2 33), with H
// its length first, that of a milling offset along N3201; G43.1: the same for the head alone, a
// table that turns takes the part with it. G49 ends both.
bool g_length(Execution& x, const GCode& row) {
    if (row.tenths == 434 || row.tenths == 431) {
        if (x.core.reads_ahead()) return x.core.fail(Alarm::TransformPlace, 'G', "G41 G42");
        if (x.modal.drilling || x.modal.polar.on)
            return x.core.fail(Alarm::TransformPlace, 'G', x.modal.drilling ? "G80" : "G15");
        if (x.core.transformed() && !controls_tip(x.core))
            return x.core.fail(Alarm::TransformPlace, 'G', std::string(row.name));
        x.core.transform_off();
        if (x.block.has('H')) {
            GCode length = row;
            length.tenths = x.core.view().config().kind == ChannelKind::Mill ? 430 : 437;
            if (!g_length(x, length)) return false;
            if (!x.modal.length
                     .turning) {  // with both rotary axes at 0 the tool points along N3201
                constexpr std::array kRoles{PlaneRole::BasicX, PlaneRole::BasicY,
                                            PlaneRole::BasicZ};
                const int place = x.core.view().axis_by_role(kRoles[static_cast<std::size_t>(
                    params::get(x.core.view().table(), params::n3201_tool_axis_direction,
                                x.core.view().channel) -
                    1)]);
                if (place < 0) return x.core.fail(Alarm::FiveAxisUndefined, 'G', "N3201");
                x.modal.length.axes = 1u << place;
                if (!apply_tool_offsets(x)) return false;
            }
        }
        return control_tip(x.core, row.tenths == 431);
    }
    if (row.tenths == 490) {
        if (controls_tip(x.core)) x.core.transform_off();
        if (row.systems == kA) return true;  // offsets are the T code's
        x.modal.length = {};
        return apply_tool_offsets(x);
    }
    std::int64_t number = 0;
    if (!x.block.has('H') || (x.vocabulary.axis_letters & letter_bit('H') &&
                              x.vocabulary.incremental_axis['H' - 'A'] < 0 &&
                              x.vocabulary.absolute_axis['H' - 'A'] >= 0))
        return x.core.fail(Alarm::CycleWordMissing, 'G', "H");
    if (!whole_number(x, 'H', number)) return false;
    if (x.settings.managed_offset_code != 0 && number == x.settings.managed_offset_code &&
        !managed_offset(x, false, number))
        return false;
    const int limit = x.core.view().config().offset_count;
    if (number > limit)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'H', {}, static_cast<double>(number), limit);
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const bool mill = x.core.view().config().kind == ChannelKind::Mill;
    const bool turning = row.tenths == 437;
    // Whose table a channel may use: N1414 TCM, TOM; N1416 TOL.
    const bool allowed = turning
                             ? (mill ? params::bit(t, params::n1416_comp_config_on_mills, l, 2)
                                     : x.settings.offsets_by_g)
                             : mill || (x.settings.offsets_by_g &&
                                        params::bit(t, params::n1414_comp_config_on_lathes, l, 6));
    if (!allowed) return x.core.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    x.modal.length.number = static_cast<std::int32_t>(number);
    x.modal.length.sign = row.tenths == 440 ? -1 : 1;
    x.modal.length.turning = turning;
    x.modal.length.axes = 0;
    if (!turning) {
        const bool z_only = params::bit(t, params::n1416_comp_config_on_mills, l, 0),
                   across = params::bit(t, params::n1416_comp_config_on_mills, l, 1);
        const MachineView& view = x.core.view();
        int place = -1;
        if (z_only != across) {
            PlaneRole role = PlaneRole::BasicZ;
            if (across && x.core.path.plane == Plane::ZX) role = PlaneRole::BasicY;
            if (across && x.core.path.plane == Plane::YZ) role = PlaneRole::BasicX;
            place = view.axis_by_role(role);
            if (place >= 0) x.modal.length.axes = 1u << place;
        } else {  // every axis that the block names
            for (unsigned k = 0; k < x.words.axis_count; ++k)
                if (const Word& word = x.block.words[x.words.axes[k]]; word.address != 'H')
                    x.modal.length.axes |= 1u << axis_of(x, word).place;
            if (x.modal.length.axes == 0 && view.axis_by_role(PlaneRole::BasicZ) >= 0)
                x.modal.length.axes = 1u << view.axis_by_role(PlaneRole::BasicZ);
        }
    }
    return apply_tool_offsets(x);
}

// D of G41, G42: whose radius counts (milling, or turning with offsets by G codes).
bool radius_offset(Execution& x) {
    std::int64_t number = 0;
    if (!whole_number(x, 'D', number)) return false;
    if (x.settings.managed_offset_code != 0 && number == x.settings.managed_offset_code &&
        !managed_offset(x, true, number))
        return false;
    const int limit = x.core.view().config().offset_count;
    if (number > limit)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'D', {}, static_cast<double>(number), limit);
    x.modal.length.radius = static_cast<std::int32_t>(number);
    load_nose(x);
    return true;
}

}  // namespace polyturn::channels::fanuc
