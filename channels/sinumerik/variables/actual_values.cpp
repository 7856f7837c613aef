// Axes and files of the machine seen from the program: PRESETON, GEOAX, axis exchange, words that
// this machine accepts and that leave its path as it is (sinumerik_part3 7).
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// An axis of the channel as argument `k`; false: none.
bool Interpreter::axis_argument(Call& c, std::size_t k, std::string_view name, std::size_t& place) {
    const int at = c.has(k) && c.value(k).type == Type::Axis ? c.value(k).place() : -1;
    if (at < 0) return fail(Alarm::AxisArgumentMissing, std::string(name));
    if (at >= kSpindleAxis) return fail(Alarm::AxisKindWrong, c.value(k).text);
    place = static_cast<std::size_t>(at);
    return true;
}

// PRESETON, PRESETONS(axis, value ...): the axis' position is called `value` now. The drive's
// own position stays, so the limits of the machine keep their meaning; SUPA puts the difference
// away.
bool Interpreter::p_preset(Call& c) {
    const std::string_view name = block_.procedures.front().first->name;
    if (c.arguments.size() % 2 != 0)
        return fail(Alarm::ArgumentCountIllegal, std::string(name),
                    static_cast<double>(c.arguments.size()));
    if (core_.compensating()) return fail(Alarm::CompReference);
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        std::size_t place = 0;
        if (!axis_argument(c, k, name, place)) return false;
        if (!c.has(k + 1))
            return fail(Alarm::ArgumentMissing, std::string(name), static_cast<double>(k + 2));
        const double value = c.number(k + 1) * (core_.view().axes[place].rotary ? 1.0
                                                : active(13) == 3               ? 25.4
                                                                                : 1.0);
        // an earlier one counts
        core_.preset_by(
            static_cast<unsigned>(place),
            value - (core_.machine_now(static_cast<unsigned>(place)) - core_.path.preset[place]));
    }
    state_changed_ = true;
    core_.mark_emitted();
    core_.sink().barrier(core_.at);
    stop_reading();
    return true;
}

// GEOAX(): the geometry axes of the machine; GEOAX(n, axis) where it names them as they are. Others
// are not built.
bool Interpreter::p_geometry_axes(Call& c) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    if (c.arguments.size() % 2 != 0)
        return fail(Alarm::ArgumentCountIllegal, "GEOAX", static_cast<double>(c.arguments.size()));
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        const double n = c.number(k);
        std::size_t place = 0;
        if (!(n == 1 || n == 2 || n == 3)) return fail(Alarm::ValueOutOfRange, "GEOAX", n);
        // no axis has this number
        if (const PlaneRole role = kRoles[static_cast<std::size_t>(n) - 1];
            c.has(k + 1) && c.value(k + 1).is_number() && c.number(k + 1) == 0) {
            if (core_.view().axis_by_role(role) < 0) continue;
            return fail(Alarm::NotBuilt, "GEOAX(" + std::to_string(static_cast<int>(n)) + ",0)");
        }
        if (!axis_argument(c, k + 1, "GEOAX", place)) return false;
        if (core_.view().axes[place].role != kRoles[static_cast<std::size_t>(n) - 1])
            return fail(Alarm::NotBuilt, "GEOAX(" + std::to_string(static_cast<int>(n)) + "," +
                                             axis_name(static_cast<int>(place)) + ")");
    }
    return true;
}

bool Interpreter::axes_only(const Call& c) {
    for (std::size_t k = 0; k < c.arguments.size(); ++k)
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(Alarm::AxisArgumentMissing,
                        std::string(block_.procedures.back().first->name));
    return true;
}

// SOFTA, JERKA: the kernel keeps the jerk of each axis whatever is said. BRISKA, DRIVEA: so they
// have no effect.
bool Interpreter::p_soft_axes(Call& c) { return axes_only(c); }
bool Interpreter::p_profile_without_effect(Call& c) { return axes_only(c) && p_without_effect(c); }

bool Interpreter::p_without_effect(Call& c) {
    const std::string name(block_.procedures.back().first->name);
    return without_effect(name, c.column, c.column ? name.size() : 0);
}

// $AA_OFF[axis]: a position that lies over the path, true mm or degrees (sinumerik_part2 13.11).
// The axis goes there in rapid where the block or action that says so is done; the programmed
// numbers do not know of it until CORROF hands it over to them.
bool Interpreter::write_overlay(const std::string& name, const std::vector<Value>& indices,
                                const char* from, std::size_t length, const Value& value) {
    if (indices.size() != 1 || indices[0].type != Type::Axis || indices[0].place() >= kSpindleAxis)
        return fail_at(Alarm::AxisArgumentMissing, from, length, name);
    undo([this, before = overlays_] { overlays_ = before; });
    overlays_.push_back({static_cast<std::size_t>(indices[0].place()), value.number});
    written_.push_back({name + "[" + axis_name(indices[0].place()) + "]", value});
    return true;
}

bool Interpreter::drive_overlays() {
    if (overlays_.empty()) return true;
    if (core_.compensating() || core_.transformed())
        return fail(Alarm::NotBuilt, "$AA_OFF, G41 G42 TRANSMIT");
    AxisValues wanted = core_.path.wanted;
    for (const Overlay& one : overlays_) wanted[one.place] = one.mm;
    overlays_.clear();
    core_.set_wanted(wanted);
    state_changed_ = true;
    return !core_.vector_pending() || core_.travel_offset(true);
}

// DRFOF, CORROF(axis, "DRF" | "AA_OFF" ...): no axis moves; what lay over the path belongs to the
// programmed position now. There is no DRF.
bool Interpreter::p_overlay_off(Call& c) {
    if (c.arguments.size() % 2 != 0)
        return fail(Alarm::ArgumentCountIllegal, "CORROF", static_cast<double>(c.arguments.size()));
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        std::size_t place = 0;
        if (!axis_argument(c, k, "CORROF", place)) return false;
        const std::string which = c.has(k + 1) ? upper(c.value(k + 1).text) : std::string();
        if (which != "DRF" && which != "AA_OFF")
            return fail(Alarm::FunctionArgument, "CORROF: " + which, static_cast<double>(k + 2));
        if (which == "DRF") continue;
        if (core_.compensating()) return fail(Alarm::CodesContradict, "CORROF, G41, G42");
        AxisValues wanted = core_.path.wanted;
        wanted[place] = 0.0;
        core_.set_wanted(wanted);
        core_.take_wanted();
        state_changed_ = true;
    }
    return p_stopre(c);
}

// RELEASE(axis): no channel may move it until GET or GETD takes it back. Axes of other channels
// cannot be taken here.
bool Interpreter::p_axis_exchange(Call& c) {
    const std::string_view name = block_.procedures.front().first->name;
    for (std::size_t k = 0; k < c.arguments.size(); ++k) {
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(Alarm::AxisArgumentMissing, std::string(name));
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) continue;  // a spindle belongs to whoever commands it
        if (core_.compensating()) return fail(Alarm::AxisExchangeIllegal, axis_name(place));
        const AxisSet bit = 1u << place;
        modal_.released = name == "RELEASE" ? modal_.released | bit : modal_.released & ~bit;
    }
    core_.mark_emitted();
    core_.sink().barrier(core_.at);
    stop_reading();
    return true;
}

// AXTOCHAN(axis, channel, ...): for this channel it is GET, for another one RELEASE: that one takes
// the axis with its own GET.
bool Interpreter::p_axis_to_channel(Call& c) {
    AxisSet comes = 0, goes = 0;
    for (std::size_t k = 0; k < c.arguments.size(); k += 2) {
        unsigned channel = 0;
        if (!c.has(k) || !c.has(k + 1) || c.value(k).type != Type::Axis)
            return fail(Alarm::AxisArgumentMissing, "AXTOCHAN");
        if (!channel_of(c.value(k + 1), channel)) return false;
        const int place = c.value(k).place();
        if (place >= kSpindleAxis) continue;  // a spindle belongs to whoever commands it
        if (core_.compensating()) return fail(Alarm::AxisExchangeIllegal, axis_name(place));
        (channel == core_.view().channel ? comes : goes) |= 1u << place;
    }
    modal_.released = (modal_.released | goes) & ~comes;
    core_.mark_emitted();
    core_.sink().barrier(core_.at);
    stop_reading();
    return true;
}

// CYCLE800() at the head of a program: no swivelled plane is left (sinumerik_part1 4.2). There is
// none that it could swivel to.
bool Interpreter::p_swivel(Call& c) {
    const bool any = std::any_of(c.arguments.begin(), c.arguments.end(),
                                 [](const Argument& one) { return one.given; });
    return !any || fail(Alarm::NotBuilt, "CYCLE800");
}

// GETSELT(VAR t, spindle), GETEXET(VAR t, spindle): the tool that waits for its change, and the one
// that cuts.
bool Interpreter::p_tool_of_spindle(Call& c) {
    const bool selected = block_.procedures.front().first->name == "GETSELT";
    const std::int64_t tool =
        selected && modal_.tool_selected >= 0 ? modal_.tool_selected : modal_.tool;
    store(c.arguments[0].reference, Value::of_int(static_cast<double>(tool)));
    return true;
}

// POLF[axis]: where it goes when a thread is held; workpiece coordinates, or the way with IC.
bool Interpreter::a_lift_position(const Word& word) {
    GeoModal& geo = modal_.geo;
    const auto i = static_cast<std::size_t>(word.axis);
    const bool incremental = is_incremental(word);
    geo.lift_to[i] = length_mm(word, word.axis, incremental);
    geo.lift_set |= 1u << i;
    geo.lift_incremental =
        incremental ? geo.lift_incremental | 1u << i : geo.lift_incremental & ~(1u << i);
    return true;
}

bool Interpreter::p_lift_axes(Call& c) {  // POLFMASK, POLFMLIN
    const std::string_view name = block_.procedures.front().first->name;
    modal_.geo.lift_axes = 0;
    for (std::size_t k = 0; k < c.arguments.size(); ++k) {
        std::size_t place = 0;
        if (!axis_argument(c, k, name, place)) return false;
        modal_.geo.lift_axes |= 1u << place;
    }
    return true;
}

// FD: speed of the path that the handwheel changes; without its pulses the path is driven with it.
// FDA: of one axis.
bool Interpreter::a_handwheel_feed(const Word& word) {
    if (word.axis >= 0) {
        if (word.number() == 0) return fail_word(Alarm::NotBuilt, word, "FDA=0");
        modal_.axis_feed[static_cast<std::size_t>(word.axis)] = word.number() * feed_unit();
        return a_without_effect(word);
    }
    if (word.number() <= 0) return fail_word(Alarm::ValueOutOfRange, word, "FD");
    if (has("F") || has("FB")) return fail_word(Alarm::CodesContradict, word, "FD, F");
    const GCode* motion = motion_code();
    const bool path = motion && motion->group == 1 && motion->number >= 2 && motion->number <= 4;
    if (!path || active(10) != 1 || active(15) != 2)
        return fail_word(Alarm::CodesContradict, word, "FD: G1 G2 G3, G60, G94");
    block_feed_ = word.number() * feed_unit();
    return a_without_effect(word);
}

// Shares in percent: ACC, VELOLIM, JERKLIM of an axis' own limits, OVRA of a positioning axis' feed
// or a spindle's speed.
bool Interpreter::a_axis_share(const Word& word) {
    const std::string_view name = word.address->name;
    if (word.number() < 1 || word.number() > 200)
        return fail_word(Alarm::ValueOutOfRange, word, std::string(name), word.number());
    const double share = word.number() / 100.0;
    if (word.axis < 0 || word.axis >= kSpindleAxis)
        return name == "OVRA" ? spindle_share(word, share) : share == 1.0 || a_without_effect(word);
    if (name == "ACC") modal_.acceleration[static_cast<std::size_t>(word.axis)] = word.number();
    const std::string_view kind = name == "ACC"       ? "ACC"
                                  : name == "VELOLIM" ? "VELO"
                                  : name == "JERKLIM" ? "JERK"
                                                      : "OVRA";
    core_.signal(std::string(kind) + std::to_string(word.axis), share);
    return true;
}

// The kernel has the product; events and $P_S say what the program has said.
bool Interpreter::spindle_share(const Word& word, double share) {
    return with_spindle(word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        const SpindleState& now = core_.path.spindle;
        if (now.spindle == 0) return fail_word(Alarm::SpindleMissing, word, "OVRA");
        core_.signal("OVRS" + std::to_string(now.spindle), share);
        Spindle again;
        again.spindle = now.spindle;
        again.mode = now.mode;
        again.value = now.mode == SpindleModeCode::SurfaceSpeed ? now.surface_m_min : now.rpm;
        again.speed_changed = again.silent = true;
        if (now.mode == SpindleModeCode::Rpm && again.value > 0)
            core_.sink().spindle(again, core_.at);
        return true;
    });
}

// DITS, DITE: -1, 0 or a way; kept as setting data.
bool Interpreter::a_thread_ramp(const Word& word) {
    const double way = word.number();
    if (way < 0 && way != -1)
        return fail_word(Alarm::ValueOutOfRange, word, std::string(word.address->name), way);
    params::Table& table = *core_.view().parameters;
    const params::Row& row = *params::find("SD42010");
    const std::size_t slot = row.first_slot + (core_.view().channel - 1) * row.array +
                             (word.address->name == "DITE" ? 1 : 0);
    undo([this, slot, before = table.numbers[slot]] {
        core_.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = way < 0 ? -1.0 : way * unit();
    return a_without_effect(word);
}

}  // namespace polyturn::channels::sinumerik
