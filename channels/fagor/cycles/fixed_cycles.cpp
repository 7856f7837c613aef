#include "channels/fagor/cycles/fixed_cycles.hpp"

#include <algorithm>
#include <cmath>

#include "channels/compensation/options.hpp"
#include "channels/cycles/drilling.hpp"
#include "channels/cycles/grooving.hpp"
#include "channels/cycles/section.hpp"
#include "channels/cycles/thread_section.hpp"
#include "channels/fagor/cycles/cycle_words.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {

using cycles::Point;

bool g_section(Execution& x, const GCode& row) {
    const bool facing = row.number == 82 || row.number == 85;
    if (!begin_cycle_block(x) || !cycle_needs(x, "XZQRC") || !cycle_not_zero(x, "C") ||
        !cycle_not_negative(x, "CDLMFH"))
        return false;
    cycles::Section section;
    section.facing = facing;
    section.start = cycle_point(x, 'Z', 'X');
    section.end = cycle_point(x, 'R', 'Q');
    section.most = distance(x, 'C');
    section.safety = distance(x, 'D');
    section.retract = !x.words.has('D')    ? cycles::Retract::Along
                      : section.safety > 0 ? cycles::Retract::Oblique
                                           : cycles::Retract::Same;
    section.allowance = {distance(x, 'M'), distance(x, 'L')};
    section.roughing_feed = distance(x, 'F');
    section.finishing_feed = distance(x, 'H');
    section.arc_tolerance = x.settings.arc_tolerance;
    if (row.number >= 84) {
        if (!x.words.has('I') && !x.words.has('K'))
            return x.fail(Alarm::CycleWordMissing, 'G', "I K");
        section.arc = true;
        section.centre = {section.start.z + distance(x, 'K'), section.start.x + distance(x, 'I')};
        const double r0 =
            std::hypot(section.start.z - section.centre.z, section.start.x - section.centre.x);
        const double r1 =
            std::hypot(section.end.z - section.centre.z, section.end.x - section.centre.x);
        if (std::fabs(r0 - r1) > x.settings.arc_tolerance)
            return x.fail(Alarm::ArcRadiusDiffers, 'I', {}, std::fabs(r0 - r1),
                          x.settings.arc_tolerance);
    }
    const Point call = cycle_call_point(x);
    constexpr double kSlack = 1e-6;
    const double x_room = std::fabs(call.x - (facing ? section.start.x : section.end.x)),
                 z_room = std::fabs(call.z - (facing ? section.end.z : section.start.z));
    if (x_room < section.allowance.x - kSlack || z_room < section.allowance.z - kSlack)
        return x.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
    return cycles::cut_section(x.core, section);
}

bool g_drilling(Execution& x, const GCode&) {
    if (!begin_cycle_block(x) || !cycle_needs(x, "XZIB") || !cycle_not_zero(x, "I") ||
        !cycle_not_negative(x, "BDKHCLR"))
        return false;
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    drop_compensation(x);
    const Point at = cycle_point(x, 'Z', 'X');
    const double away = x.words.number('I') > 0 ? 1.0 : -1.0;
    cycles::AxialHole hole;
    hole.axis = p;
    hole.approach = x.core.path.programmed;
    hole.approach[p] = at.z + away * distance(x, 'D');
    hole.approach[q] = at.x;
    hole.surface = at.z;
    hole.bottom = at.z - distance(x, 'I');
    if (!cycle_dwell(x, hole.dwell)) return false;
    if (x.words.number('B') > 0) {
        hole.peck = distance(x, 'B');
        hole.factor = x.words.number('R') > 0 ? x.words.number('R') : 1.0;
        hole.least = distance(x, 'L');
        hole.retract = distance(x, 'H');
        hole.clearance = x.words.has('C') ? distance(x, 'C') : 1.0;
        return cycles::drill_axial(x.core, hole);
    }
    const auto kind = static_cast<int>(x.words.number('R'));
    if (kind > 2 || kind != x.words.number('R'))
        return x.fail(Alarm::FagorValueRange, 'R', "R", x.words.number('R'));
    if (kind > 0 && std::fabs(at.x) > 1e-6) return x.fail(Alarm::FagorCyclePosition, 'X', "G83");
    hole.tap = kind == 0   ? cycles::AxialHole::Tap::Floating
               : kind == 1 ? cycles::AxialHole::Tap::Oriented
                           : cycles::AxialHole::Tap::Turning;
    x.core.signal("TAPPING", 1.0);
    x.core.path.feed_path.scale = 1.0;  // no override acts on a tap
    follow_spindle(x, true);
    x.modal.m_states &= ~(1ull << 19);  // M19 has to search its mark again
    if (!cycles::tap_axial(x.core, hole)) return false;
    // a rigid one ends with M05 (9.6.3)
    if (kind > 0) x.modal.m_states = (x.modal.m_states & ~(1ull << 3 | 1ull << 4)) | 1ull << 5;
    x.core.signal("TAPPING", 0.0);
    return true;
}

bool g_threading(Execution& x, const GCode& row) {
    if (!begin_cycle_block(x) || !cycle_needs(x, "XZQRIBC") || !cycle_not_zero(x, "IBC"))
        return false;
    if (x.words.has('M') && x.words.number('M') != 0 && x.words.has('K'))
        return x.fail(Alarm::FagorCyclePair, 'M', "M and K");
    drop_compensation(x);
    cycles::ThreadSection thread;
    thread.face = row.number == 87;
    thread.start = cycle_point(x, 'Z', 'X');
    thread.end = cycle_point(x, 'R', 'Q');
    thread.depth = distance(x, 'I');
    thread.first = distance(x, 'B');
    thread.least = std::fabs(distance(x, 'E'));
    thread.safety = std::fabs(distance(x, 'D'));
    thread.square_corners = x.words.number('D') < 0;
    thread.finishing = distance(x, 'L');
    if (std::fabs(thread.finishing) > std::fabs(thread.depth))
        return x.fail(Alarm::FagorValueRange, 'L', "L", x.words.number('L'));
    const double along =
        thread.face ? thread.end.x - thread.start.x : thread.end.z - thread.start.z;
    const double across =
        thread.face ? thread.end.z - thread.start.z : thread.end.x - thread.start.x;
    const double whole_way = std::hypot(along, across);
    // A positive pitch counts along the taper, a negative one along the axis.
    thread.lead = x.words.number('C') > 0 && whole_way > 0
                      ? distance(x, 'C') * std::fabs(along) / whole_way
                      : std::fabs(distance(x, 'C'));
    thread.lead_change = distance(x, 'M');
    if (thread.lead * thread.lead + 2 * thread.lead_change * std::fabs(along) <= 0)
        return x.fail(Alarm::FagorCyclePitch, 'M');
    thread.exit = distance(x, 'J');
    if (std::fabs(thread.exit) > std::fabs(along))
        return x.fail(Alarm::FagorValueRange, 'J', "J", x.words.number('J'));
    thread.angle_deg = x.words.has('A') ? x.words.number('A') : 30.0;
    if (std::fabs(thread.angle_deg) >= 90)
        return x.fail(Alarm::FagorValueRange, 'A', "A", x.words.number('A'));
    if (x.words.has('H')) {
        std::int64_t entry = 0;
        if (!whole(x, *x.words.word('H'), entry)) return false;
        if (entry > 5) return x.fail(Alarm::FagorValueRange, 'H', "H", static_cast<double>(entry));
        thread.entry = static_cast<int>(entry);
    }
    if (x.words.number('U') != 0 && x.words.number('U') != 1)
        return x.fail(Alarm::FagorValueRange, 'U', "U", x.words.number('U'));
    thread.run_in = x.words.number('U') != 0;
    thread.spindle_deg = x.words.number('W');
    if (x.words.has('V')) {
        std::int64_t starts = 0;
        if (!whole(x, *x.words.word('V'), starts)) return false;
        if (starts > 100)
            return x.fail(Alarm::FagorValueRange, 'V', "V", static_cast<double>(starts));
        thread.starts = starts > 0 ? static_cast<int>(starts) : 1;
    }
    if (x.words.has('K')) {  // repair: at the measured point the spindle is at W
        int p = -1, q = -1;
        x.core.plane_axes(p, q);
        const double measured =
            thread.face ? length(x, x.words.number('K'), q) : length(x, x.words.number('K'), p);
        const double begin = thread.face ? thread.start.x : thread.start.z;
        const double turn = x.core.path.spindle.turn == SpindleTurn::Ccw ? -1.0 : 1.0;
        thread.spindle_deg = x.words.number('W') + turn * (along >= 0 ? 1.0 : -1.0) * 360.0 *
                                                       (begin - measured) / thread.lead;
    }
    follow_spindle(x, true);
    return cycles::cut_thread_section(x.core, thread);
}

bool g_grooving(Execution& x, const GCode& row) {
    if (!begin_cycle_block(x) || !cycle_needs(x, "XZQR") || !cycle_not_zero(x, "C") ||
        !cycle_not_negative(x, "CDK"))
        return false;
    drop_compensation(x);
    cycles::PlungedGroove groove;
    groove.along_x = row.number == 88;
    groove.start = cycle_point(x, 'Z', 'X');
    groove.end = cycle_point(x, 'R', 'Q');
    const ToolState& tool = x.core.path.tool;
    const std::int64_t geometry = x.settings.geometry_by_offset ? tool.ref.offset : tool.ref.number;
    groove.cutter = geometry > 0 ? x.values.tool(ToolField::NoseWidth,
                                                 static_cast<std::size_t>(geometry) % kTools)
                                 : 0.0;
    groove.step = x.words.has('C') ? distance(x, 'C') : groove.cutter;
    groove.safety = distance(x, 'D');
    if (!cycle_dwell(x, groove.dwell)) return false;
    const double depth =
        groove.along_x ? groove.start.x - groove.end.x : groove.start.z - groove.end.z;
    const double width =
        std::fabs(groove.along_x ? groove.start.z - groove.end.z : groove.start.x - groove.end.x);
    if (std::fabs(depth) < 1e-9) return x.fail(Alarm::FagorGrooveDepth, groove.along_x ? 'Q' : 'R');
    if (width < groove.cutter - 1e-6)
        return x.fail(Alarm::FagorGrooveWidth, groove.along_x ? 'R' : 'Q', {}, width,
                      groove.cutter);
    if (!(groove.step > 0)) return x.fail(Alarm::FagorCycleZero, 'G', "C (NOSEW)");
    // The location code says which corner of the cutter the tool's point is (9.11, part 1 8.2.1).
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    const auto code = static_cast<std::size_t>(std::clamp(tool.tip, 0, 9));
    const auto along = static_cast<std::size_t>(groove.along_x ? p : q);
    double corner = groove.along_x ? compensation::kTipsAround[code].first
                                   : compensation::kTipsAround[code].second;
    if (x.modal.mirrored >> along & 1u) corner = -corner;
    groove.far_corner =
        corner * (groove.along_x ? groove.end.z - groove.start.z : groove.end.x - groove.start.x) >
        0;
    const Point call = cycle_call_point(x);
    const double distance_now =
        ((groove.along_x ? call.x - groove.start.x : call.z - groove.start.z)) *
        (depth > 0 ? 1.0 : -1.0);
    if (distance_now < groove.safety - 1e-6)
        return x.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
    return cycles::plunge_groove(x.core, groove);
}

}  // namespace polyturn::channels::fagor
