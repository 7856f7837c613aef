#include "channels/fagor/cycles/profile_cycles.hpp"

#include <cmath>
#include <utility>

#include "channels/cycles/contour_offset.hpp"
#include "channels/cycles/profile_roughing.hpp"
#include "channels/cycles/tool_closing.hpp"
#include "channels/fagor/cycles/cycle_words.hpp"
#include "channels/fagor/cycles/profile_reader.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/compensation.hpp"
#include "channels/fagor/motion/contour_loops.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {

using cycles::Contour;
using cycles::Point;

namespace {

// The feed that the cycle has used last stays (9.0.6).
void keep_feed(Execution& x, double feed) {
    (x.modal.feed_code == 94   ? x.modal.feed_minute
     : x.modal.feed_code == 95 ? x.modal.feed_revolution
                               : x.modal.feed_inverse) = feed;
}

bool repeat_passes(Execution& x, const Contour& part, Point call, double l, double m, bool square,
                   double finishing) {
    // Along X, unless A or the longer dimension of the tool says otherwise.
    bool along_x = true;
    if (x.words.has('A')) {
        if (x.words.number('A') != 0 && x.words.number('A') != 1)
            return x.fail(Alarm::FagorValueRange, 'A', "A", x.words.number('A'));
        along_x = x.words.number('A') == 0;
    } else {
        int p = -1, q = -1;
        x.core.plane_axes(p, q);
        const AxisValues& tool = x.core.path.wanted;
        along_x = !(std::fabs(tool[static_cast<std::size_t>(p)]) >
                    std::fabs(tool[static_cast<std::size_t>(q)]));
    }
    const double stock = distance(x, 'I'), step = distance(x, 'C'), allowance = along_x ? l : m;
    const double sx = call.x >= part.first.x ? 1.0 : -1.0, sz = call.z >= part.first.z ? 1.0 : -1.0;
    double outermost = -1e12;
    const auto look = [&](Point p) {
        outermost = std::fmax(outermost, along_x ? sx * p.x : sz * p.z);
    };
    look(part.first);
    for (const cycles::Element& e : part.elements) look(e.to);
    if ((along_x ? sx * call.x : sz * call.z) < outermost + stock - 1e-6)
        return x.fail(Alarm::FagorCyclePosition, 'G', "G66");
    cycles::ProfileRepeat cycle;
    cycle.along_x = along_x;
    cycle.finishing_feed = finishing;
    cycle.finishing_square = square;
    cycle.arc_tolerance = x.settings.arc_tolerance;
    const int side = cycles::side_towards(part, call, along_x);
    // An arc or a slope at the end is not cut beyond the largest coordinate that is programmed
    // (9.1.1).
    const cycles::Element& last = part.elements.back();
    const bool oblique_end =
        last.form != cycles::Element::Form::Line ||
        (std::fabs(last.to.z - last.from.z) > 1e-6 && std::fabs(last.to.x - last.from.x) > 1e-6);
    if (!(finishing > 0 && stock <= allowance)) {
        const int passes = static_cast<int>(std::ceil((stock - allowance) / step - 1e-9));
        if (passes > 10'000) return x.fail(Alarm::CycleValueIllegal, 'C', "C", step);
        for (int k = 1; k <= passes; ++k) {
            const double d = std::fmax(stock - k * step, allowance);
            if (!x.words.has('M')) {
                Contour pass = d > 0 ? cycles::equidistant(part, d, side) : part;
                if (oblique_end)
                    pass = cycles::without_end_beyond(pass, along_x, along_x ? sx : sz, outermost);
                if (!pass.elements.empty()) cycle.passes.push_back(std::move(pass));
                continue;
            }
            const double more = d - allowance;
            cycle.passes.push_back(cycles::translated(
                part, {sz * (m + (along_x ? 0.0 : more)), sx * (l + (along_x ? more : 0.0))}));
        }
    }
    return cycles::repeat_profile(x.core, part, cycle);
}

// The finishing pass is compensated: what the nose does not fit into is closed before anything is
// cut (9.1.5).
void close_for_nose(Execution& x, Contour& part, bool infeed_in_x, bool& closed) {
    // elements that are looked at together, as in 8.2.5 of part 1
    constexpr std::size_t kWindow = 50;
    const Nose nose{std::fabs(x.core.path.tool.nose_radius) / x.modal.scale,
                    cycles::side_towards(part, cycle_call_point(x), infeed_in_x), outer_corner(x)};
    const auto loops = find_loops(part.elements, nose, kWindow);
    if (loops.empty()) return;
    part.elements = without_loops(std::move(part.elements), loops);
    closed = true;
}

// Cutter angle NOSEA and cutting angle CUTA, in ten-thousandths of a degree; a tool without them
// reaches everything.
Contour close_for_tool(Execution& x, const Contour& part, bool facing, bool& closed) {
    const ToolState& tool = x.core.path.tool;
    const std::int64_t number = x.settings.geometry_by_offset ? tool.ref.offset : tool.ref.number;
    closed = false;
    if (number <= 0) return part;
    const auto n = static_cast<std::size_t>(number) % kTools;
    const double cutter = x.values.tool(ToolField::NoseAngle, n) / 10'000.0,
                 cutting = x.values.tool(ToolField::CutAngle, n) / 10'000.0;
    if (cutter <= 0 || cutting <= 0) return part;
    const Point call = cycle_call_point(x);
    const auto along = [facing](Point p) { return facing ? p.x : p.z; };
    const auto up = [facing](Point p) { return facing ? p.z : p.x; };
    const double s_sign = along(part.end()) > along(call) ? 1.0 : -1.0,
                 h_sign = up(call) >= up(part.first) ? 1.0 : -1.0;
    return cycles::closed_for(part, facing, s_sign, h_sign, {180.0 - cutting - cutter, cutting},
                              closed);
}

}  // namespace

bool g_profile(Execution& x, const GCode& row) {
    if (!begin_cycle_block(x) || !cycle_needs(x, row.number == 66 ? "XZICSE" : "XZCSE") ||
        !cycle_not_zero(x, "C") || !cycle_not_negative(x, "CDKFHI"))
        return false;
    if (distance(x, 'C') <= 0) return x.fail(Alarm::FagorCycleZero, 'C', "C");
    drop_compensation(x);
    Contour part, blank;
    bool has_blank = false;
    if (!read_profile(x, part, blank, has_blank)) return false;
    bool closed = false;
    part = close_for_tool(x, part, row.number == 69, closed);
    if (distance(x, 'H') > 0) close_for_nose(x, part, row.number != 69, closed);
    if (closed)
        x.core.sink().alarm({Alarm::FagorProfileHollow,
                             {x.programs.files.path(x.calls.here().file), x.core.at.line, 0, 0},
                             {},
                             {}},
                            x.core.at);
    const Point call = cycle_call_point(x);
    part.start = call;
    const double l = std::fabs(distance(x, 'L')),
                 m = x.words.has('M') ? std::fabs(distance(x, 'M')) : l;
    const bool square = !(x.words.number('L') < 0 || x.words.number('M') < 0);
    const double finishing = distance(x, 'H');
    bool good = true;
    if (row.number == 66) {
        good = repeat_passes(x, part, call, l, m, square, finishing);
    } else {
        const bool facing = row.number == 69;
        // Outside the part, farther away than the allowances.
        Point least = part.first, most = part.first;
        const double sx = call.x >= part.first.x ? 1.0 : -1.0,
                     sz = call.z >= part.first.z ? 1.0 : -1.0;
        for (const cycles::Element& e : part.elements) {
            least = {std::fmin(least.z, e.to.z), std::fmin(least.x, e.to.x)};
            most = {std::fmax(most.z, e.to.z), std::fmax(most.x, e.to.x)};
        }
        // Along the infeed on the side of the call point, along the passes on either side of the
        // profile.
        const double x_above = call.x - most.x, x_below = least.x - call.x,
                     z_above = call.z - most.z, z_below = least.z - call.z;
        const double x_room = facing ? std::fmax(x_above, x_below) : sx > 0 ? x_above : x_below;
        const double z_room = !facing ? std::fmax(z_above, z_below) : sz > 0 ? z_above : z_below;
        if (x_room < l - 1e-6 || z_room < m - 1e-6)
            return x.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
        const int side = cycles::side_towards(part, call, !facing);
        Contour allowed = part;
        if (x.words.has('M'))
            allowed = cycles::translated(part, {sz * m, sx * l});
        else if (l > 0)
            allowed = cycles::equidistant(part, l, side);
        if (allowed.elements.empty()) return x.fail(Alarm::ContourEmpty, 'L');
        cycles::ProfileRoughing cycle;
        cycle.facing = facing;
        cycle.depth = distance(x, 'C');
        cycle.safety = distance(x, 'D');
        cycle.retract = !x.words.has('D')  ? cycles::Retract::Along
                        : cycle.safety > 0 ? cycles::Retract::Oblique
                                           : cycles::Retract::Same;
        cycle.plunge_feed = distance(x, 'K');
        cycle.semi_feed = distance(x, 'F');
        cycle.finishing_feed = finishing;
        cycle.finishing_square = square;
        cycle.arc_tolerance = x.settings.arc_tolerance;
        good = cycles::rough_profile(x.core, part, allowed, has_blank ? &blank : nullptr, cycle);
        if (good && cycle.semi_feed > 0 && finishing <= 0) keep_feed(x, cycle.semi_feed);
    }
    if (good && finishing > 0) keep_feed(x, finishing);
    x.modal.motion = 0;
    x.modal.absolute = true;
    return good;
}

}  // namespace polyturn::channels::fagor
