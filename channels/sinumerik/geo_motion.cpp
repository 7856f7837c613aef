// Handlers of the moves.
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::geo_motion(const GCode& code) {
    AxisValues target{};
    AxisSet named = 0;
    if (!read_axis_words(target, named)) return false;
    const bool arc = code.number > 2;
    if (!arc) return named == 0 || (code.number == 1 ? core_.rapid(target) : core_.linear(target));
    if (!named && !has("I") && !has("J") && !has("K")) return true;
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    if (p < 0 || q < 0) return fail(Alarm::PlaneAxisMissing);
    static constexpr std::string_view kCentre[3][2] = {{"I", "J"}, {"K", "I"}, {"J", "K"}};
    const auto plane = static_cast<std::size_t>(core_.path.plane);
    ArcCall call;
    call.clockwise = code.number == 3;
    if (const Word* radius = word("CR")) {
        call.has_radius = true;
        call.radius = radius->number() * unit();
        return core_.arc(target, call);
    }
    const auto centre = [&](std::string_view name, int place) {
        const Word* w = word(name);
        const double here = core_.path.programmed[static_cast<std::size_t>(place)];
        if (!w) return here;
        if (w->mode == Mode::AC) return length_mm(*w, place, false);
        return here + w->number() * unit();
    };
    call.centre_p = centre(kCentre[plane][0], p);
    call.centre_q = centre(kCentre[plane][1], q);
    const double radius = std::hypot(core_.path.programmed[static_cast<std::size_t>(p)] - call.centre_p, core_.path.programmed[static_cast<std::size_t>(q)] - call.centre_q);
    call.tolerance = std::fmax(settings_.circle_error_mm, settings_.circle_error_factor * radius);
    return core_.arc(target, call);
}

bool Interpreter::geo_dwell(const GCode&) {
    if (const Word* seconds = word("F")) return core_.dwell(seconds->number(), false);
    if (const Word* turns = word("S")) return core_.dwell(turns->number(), true);
    return fail(Alarm::ReturnValueMissing, "F, S");
}

bool Interpreter::chain_frames(Value&, const Value&) { return fail(Alarm::NotBuilt, ":"); }

}  // namespace polyturn::channels::sinumerik
