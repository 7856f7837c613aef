// Length offsets by G codes (nct part 1 14.2 C08, 15.5 TCM, 15.6), and G5.1.
#include <array>

#include "channels/fanuc/interpreter.hpp"
#include "channels/state/tip_control.hpp"

namespace polyturn::channels::fanuc {

// G43 G44 H: the length of a milling offset; G43.7 H: all of a turning offset; G49: none. G43.4:
// the tip of the tool goes where the program says while head and table turn (nct part 2 33), with H
// its length first, that of a milling offset along N3201; G43.1: the same for the head alone, a
// table that turns takes the part with it. G49 ends both.
bool Interpreter::g_length(const GCode& row) {
    if (row.tenths == 434 || row.tenths == 431) {
        if (core_.reads_ahead()) return core_.fail(Alarm::TransformPlace, 'G', "G41 G42");
        if (drilling_ || polar_)
            return core_.fail(Alarm::TransformPlace, 'G', drilling_ ? "G80" : "G15");
        if (core_.transformed() && !controls_tip(core_))
            return core_.fail(Alarm::TransformPlace, 'G', std::string(row.name));
        core_.transform_off();
        if (block_.has('H')) {
            GCode length = row;
            length.tenths = core_.view().config().kind == ChannelKind::Mill ? 430 : 437;
            if (!g_length(length)) return false;
            if (!length_.turning) {  // with both rotary axes at 0 the tool points along N3201
                constexpr std::array kRoles{PlaneRole::BasicX, PlaneRole::BasicY,
                                            PlaneRole::BasicZ};
                const int place = core_.view().axis_by_role(kRoles[static_cast<std::size_t>(
                    params::get(core_.view().table(), params::n3201_tool_axis_direction,
                                core_.view().channel) -
                    1)]);
                if (place < 0) return core_.fail(Alarm::FiveAxisUndefined, 'G', "N3201");
                length_.axes = 1u << place;
                if (!apply_tool_offsets()) return false;
            }
        }
        return control_tip(core_, row.tenths == 431);
    }
    if (row.tenths == 490) {
        if (controls_tip(core_)) core_.transform_off();
        if (row.systems == kA) return true;  // offsets are the T code's
        length_ = {};
        return apply_tool_offsets();
    }
    std::int64_t number = 0;
    if (!block_.has('H') || (axis_letters_ & letter_bit('H') && incremental_axis_['H' - 'A'] < 0 &&
                             absolute_axis_['H' - 'A'] >= 0))
        return core_.fail(Alarm::CycleWordMissing, 'G', "H");
    if (!whole('H', number)) return false;
    if (settings_.managed_offset_code != 0 && number == settings_.managed_offset_code &&
        !managed_offset(false, number))
        return false;
    const int limit = core_.view().config().offset_count;
    if (number > limit)
        return core_.fail(Alarm::OffsetNumberIllegal, 'H', {}, static_cast<double>(number), limit);
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    const bool mill = core_.view().config().kind == ChannelKind::Mill;
    const bool turning = row.tenths == 437;
    // Whose table a channel may use: N1414 TCM, TOM; N1416 TOL.
    const bool allowed = turning
                             ? (mill ? params::bit(t, params::n1416_comp_config_on_mills, l, 2)
                                     : settings_.offsets_by_g)
                             : mill || (settings_.offsets_by_g &&
                                        params::bit(t, params::n1414_comp_config_on_lathes, l, 6));
    if (!allowed) return core_.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    length_.number = static_cast<std::int32_t>(number);
    length_.sign = row.tenths == 440 ? -1 : 1;
    length_.turning = turning;
    length_.axes = 0;
    if (!turning) {
        const bool z_only = params::bit(t, params::n1416_comp_config_on_mills, l, 0),
                   across = params::bit(t, params::n1416_comp_config_on_mills, l, 1);
        const MachineView& view = core_.view();
        int place = -1;
        if (z_only != across) {
            PlaneRole role = PlaneRole::BasicZ;
            if (across && core_.path.plane == Plane::ZX) role = PlaneRole::BasicY;
            if (across && core_.path.plane == Plane::YZ) role = PlaneRole::BasicX;
            place = view.axis_by_role(role);
            if (place >= 0) length_.axes = 1u << place;
        } else {  // every axis that the block names
            for (unsigned k = 0; k < axis_word_count_; ++k)
                if (const Word& word = block_.words[axis_words_[k]]; word.address != 'H')
                    length_.axes |= 1u << axis_of(word).place;
            if (length_.axes == 0 && view.axis_by_role(PlaneRole::BasicZ) >= 0)
                length_.axes = 1u << view.axis_by_role(PlaneRole::BasicZ);
        }
    }
    return apply_tool_offsets();
}

// D of G41, G42: whose radius counts (milling, or turning with offsets by G codes).
bool Interpreter::radius_offset() {
    std::int64_t number = 0;
    if (!whole('D', number)) return false;
    if (settings_.managed_offset_code != 0 && number == settings_.managed_offset_code &&
        !managed_offset(true, number))
        return false;
    const int limit = core_.view().config().offset_count;
    if (number > limit)
        return core_.fail(Alarm::OffsetNumberIllegal, 'D', {}, static_cast<double>(number), limit);
    length_.radius = static_cast<std::int32_t>(number);
    load_nose();
    return true;
}

// G5.1 Q: 0 off, 1 look-ahead, which is always on, 2 and 3 smoothing: runs of short lines become a
// curve within N3104 or N3106 instead of PT_PATH_TOL (channels/path/spline_run.hpp).
bool Interpreter::g_smoothing(const GCode&) {
    std::int64_t kind = 0;
    if (!block_.has('Q')) return core_.fail(Alarm::CycleWordMissing, 'G', "Q");
    if (!whole('Q', kind)) return false;
    if (kind > 3) return core_.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(kind));
    core_.signal("SMOOTHING", static_cast<double>(kind));
    return true;
}

}  // namespace polyturn::channels::fanuc
