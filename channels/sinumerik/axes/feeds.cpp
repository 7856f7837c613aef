// Which axes F counts (FGROUP), at which radius (FGREF), which of them holds it back (FL), OVR.
#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// FGREF: a degree counts as a millimetre
constexpr double kDefaultRadius = 360.0 / (2.0 * std::numbers::pi);

}  // namespace

// Core's view of FGROUP, FGREF, FL: only when the program has said anything else than the delivery
// state.
void Interpreter::set_feed_path() {
    FeedPath& by = core_.path.feed_path;
    const MachineView& view = core_.view();
    const double degree_unit = by.degree_unit;
    by = {};
    by.degree_unit = degree_unit;
    by.scale = modal_.path_override / 100.0;
    // never beyond the machine's own
    by.rapid_scale = std::fmin(1.0, modal_.rapid_override / 100.0);
    by.limit_mm_min = modal_.feed_limit;
    by.active = modal_.feed_group_set;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const bool geometry = view.axes[i].role == PlaneRole::BasicX ||
                              view.axes[i].role == PlaneRole::BasicY ||
                              view.axes[i].role == PlaneRole::BasicZ;
        const bool counted = modal_.feed_group_set ? (modal_.feed_group >> i & 1u) != 0 : geometry;
        if (counted) by.counted |= 1u << i;
        if (view.axes[i].rotary &&
            std::fabs((modal_.feed_radius[i] > 0 ? modal_.feed_radius[i] : kDefaultRadius) -
                      kDefaultRadius) < 5e-4)
            by.degrees |= 1u << i;
        by.weight[i] = view.axes[i].rotary
                           ? (modal_.feed_radius[i] > 0 ? modal_.feed_radius[i] : kDefaultRadius) *
                                 std::numbers::pi / 180.0
                           : 1.0;
        by.active = by.active || by.limit_mm_min[i] > 0 ||
                    (view.axes[i].rotary && modal_.feed_radius[i] > 0);
    }
}

bool Interpreter::p_fgroup(Call& c) {
    AxisSet group = 0;
    for (const Argument& argument : c.arguments) {
        if (!argument.given || argument.value.type != Type::Axis || argument.value.place() < 0 ||
            argument.value.place() >= kSpindleAxis)
            return fail(Alarm::AxisArgumentMissing, "FGROUP");
        group |= 1u << argument.value.place();
    }
    modal_.feed_group = group;
    modal_.feed_group_set = !c.arguments.empty();
    set_feed_path();
    return true;
}

bool Interpreter::a_feed_radius(const Word& word) {  // FGREF[axis]
    if (!core_.view().axes[static_cast<std::size_t>(word.axis)].rotary)
        return fail_word(Alarm::AxisKindWrong, word, axis_name(word.axis));
    if (word.number() <= 0) return fail_word(Alarm::ValueOutOfRange, word, "FGREF");
    modal_.feed_radius[static_cast<std::size_t>(word.axis)] = word.number() * unit();
    set_feed_path();
    return true;
}

bool Interpreter::a_feed_limit(const Word& word) {  // FL[axis]
    modal_.feed_limit[static_cast<std::size_t>(word.axis)] =
        word.number() *
        (core_.view().axes[static_cast<std::size_t>(word.axis)].rotary ? 1.0 : feed_unit());
    set_feed_path();
    return true;
}

bool Interpreter::a_override(const Word& word) {
    if (word.number() < 1 || word.number() > 200)
        return fail_word(Alarm::ValueOutOfRange, word, std::string(word.address->name));
    (word.address->name == "OVRRAP" ? modal_.rapid_override : modal_.path_override) = word.number();
    set_feed_path();
    return true;
}

// --- diameters of single axes: DIAMONA[X] and the like

bool Interpreter::a_axis_diameter(const Word& word) {
    const auto i = static_cast<std::size_t>(word.axis);
    const std::string_view name = word.address->name;
    const bool released = (params::get(core_.view().table(), params::md30460,
                                       core_.view().axes[i].machine_axis + 1u) &
                           4) != 0;
    if (core_.view().axes[i].rotary || !released)
        return fail_word(Alarm::AxisKindWrong, word, axis_name(word.axis));
    modal_.axis_diameter[i] = name == "DIAMONA"     ? 2
                              : name == "DIAM90A"   ? 3
                              : name == "DIAMOFA"   ? 1
                              : name == "DIACYCOFA" ? 4
                                                    : kAsChannel;
    core_.at.display_swapped = display_swapped();
    return true;
}

bool Interpreter::p_diamchan(Call&) {  // all released axes as DIAMCHANA (9.3.7)
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        const bool released = (params::get(core_.view().table(), params::md30460,
                                           core_.view().axes[i].machine_axis + 1u) &
                               4) != 0;
        modal_.axis_diameter[i] = released && !core_.view().axes[i].rotary ? kAsChannel : 0;
    }
    core_.at.display_swapped = display_swapped();
    return true;
}

}  // namespace polyturn::channels::sinumerik
