// G81 to G89: the words of a cycle become a section, a hole, a thread or a groove (fagor_8037t part
// 2, 9.4 to 9.12).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/compensation/options.hpp"
#include "channels/cycles/drilling.hpp"
#include "channels/cycles/grooving.hpp"
#include "channels/cycles/section.hpp"
#include "channels/cycles/thread_section.hpp"
#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {

using cycles::Point;

bool Interpreter::cycle_needs(std::string_view letters) {
    for (const char letter : letters)
        if (!has(letter)) return core_.fail(Alarm::CycleWordMissing, 'G', std::string(1, letter));
    return true;
}

bool Interpreter::cycle_not_zero(std::string_view letters) {
    for (const char letter : letters)
        if (has(letter) && number(letter) == 0.0)
            return core_.fail(Alarm::FagorCycleZero, letter, std::string(1, letter));
    return true;
}

bool Interpreter::cycle_not_negative(std::string_view letters) {
    for (const char letter : letters)
        if (number(letter) < 0.0)
            return core_.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    return true;
}

// K: whole hundredths of a second, as of G04.
bool Interpreter::cycle_dwell(double& seconds) {
    std::int64_t hundredths = 0;
    if (has('K') && !whole(*word('K'), hundredths)) return false;
    seconds = static_cast<double>(hundredths) / 100.0;
    return true;
}

// A point of a cycle is absolute, whatever G90 and G91 say; its ordinate counts as X does.
Point Interpreter::cycle_point(char abscissa, char ordinate) {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    return {length(number(abscissa), p), length(number(ordinate), q)};
}

// The tool's position in the plane.
Point Interpreter::cycle_call_point() {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    return {core_.path.programmed[static_cast<std::size_t>(p)],
            core_.path.programmed[static_cast<std::size_t>(q)]};
}

bool Interpreter::begin_cycle_block() {
    unsigned p = 0, q = 0;
    follow_spindle(false);
    return plane_places(p, q) && set_feed(core_.path.programmed);
}

// G83, G86 to G89 end compensation (9.0.6).
void Interpreter::drop_compensation() {
    modal_.comp = 40;
    core_.compensation_off(0.0, 0.0);
}

bool Interpreter::g_section(const GCode& row) {
    const bool facing = row.number == 82 || row.number == 85;
    if (!begin_cycle_block() || !cycle_needs("XZQRC") || !cycle_not_zero("C") ||
        !cycle_not_negative("CDLMFH"))
        return false;
    cycles::Section section;
    section.facing = facing;
    section.start = cycle_point('Z', 'X');
    section.end = cycle_point('R', 'Q');
    section.most = distance('C');
    section.safety = distance('D');
    section.retract = !has('D')            ? cycles::Retract::Along
                      : section.safety > 0 ? cycles::Retract::Oblique
                                           : cycles::Retract::Same;
    section.allowance = {distance('M'), distance('L')};
    section.roughing_feed = distance('F');
    section.finishing_feed = distance('H');
    section.arc_tolerance = settings_.arc_tolerance;
    if (row.number >= 84) {
        if (!has('I') && !has('K')) return core_.fail(Alarm::CycleWordMissing, 'G', "I K");
        section.arc = true;
        section.centre = {section.start.z + distance('K'), section.start.x + distance('I')};
        const double r0 =
            std::hypot(section.start.z - section.centre.z, section.start.x - section.centre.x);
        const double r1 =
            std::hypot(section.end.z - section.centre.z, section.end.x - section.centre.x);
        if (std::fabs(r0 - r1) > settings_.arc_tolerance)
            return core_.fail(Alarm::ArcRadiusDiffers, 'I', {}, std::fabs(r0 - r1),
                              settings_.arc_tolerance);
    }
    const Point call = cycle_call_point();
    constexpr double kSlack = 1e-6;
    const double x = std::fabs(call.x - (facing ? section.start.x : section.end.x)),
                 z = std::fabs(call.z - (facing ? section.end.z : section.start.z));
    if (x < section.allowance.x - kSlack || z < section.allowance.z - kSlack)
        return core_.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
    return cycles::cut_section(core_, section);
}

bool Interpreter::g_drilling(const GCode&) {
    if (!begin_cycle_block() || !cycle_needs("XZIB") || !cycle_not_zero("I") ||
        !cycle_not_negative("BDKHCLR"))
        return false;
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    drop_compensation();
    const Point at = cycle_point('Z', 'X');
    const double away = number('I') > 0 ? 1.0 : -1.0;
    cycles::AxialHole hole;
    hole.axis = p;
    hole.approach = core_.path.programmed;
    hole.approach[p] = at.z + away * distance('D');
    hole.approach[q] = at.x;
    hole.surface = at.z;
    hole.bottom = at.z - distance('I');
    if (!cycle_dwell(hole.dwell)) return false;
    if (number('B') > 0) {
        hole.peck = distance('B');
        hole.factor = number('R') > 0 ? number('R') : 1.0;
        hole.least = distance('L');
        hole.retract = distance('H');
        hole.clearance = has('C') ? distance('C') : 1.0;
        return cycles::drill_axial(core_, hole);
    }
    const auto kind = static_cast<int>(number('R'));
    if (kind > 2 || kind != number('R'))
        return core_.fail(Alarm::FagorValueRange, 'R', "R", number('R'));
    if (kind > 0 && std::fabs(at.x) > 1e-6)
        return core_.fail(Alarm::FagorCyclePosition, 'X', "G83");
    hole.tap = kind == 0   ? cycles::AxialHole::Tap::Floating
               : kind == 1 ? cycles::AxialHole::Tap::Oriented
                           : cycles::AxialHole::Tap::Turning;
    core_.signal("TAPPING", 1.0);
    core_.path.feed_path.scale = 1.0;  // no override acts on a tap
    follow_spindle(true);
    modal_.m_states &= ~(1ull << 19);  // M19 has to search its mark again
    if (!cycles::tap_axial(core_, hole)) return false;
    // a rigid one ends with M05 (9.6.3)
    if (kind > 0) modal_.m_states = (modal_.m_states & ~(1ull << 3 | 1ull << 4)) | 1ull << 5;
    core_.signal("TAPPING", 0.0);
    return true;
}

bool Interpreter::g_threading(const GCode& row) {
    if (!begin_cycle_block() || !cycle_needs("XZQRIBC") || !cycle_not_zero("IBC")) return false;
    if (has('M') && number('M') != 0 && has('K'))
        return core_.fail(Alarm::FagorCyclePair, 'M', "M and K");
    drop_compensation();
    cycles::ThreadSection thread;
    thread.face = row.number == 87;
    thread.start = cycle_point('Z', 'X');
    thread.end = cycle_point('R', 'Q');
    thread.depth = distance('I');
    thread.first = distance('B');
    thread.least = std::fabs(distance('E'));
    thread.safety = std::fabs(distance('D'));
    thread.square_corners = number('D') < 0;
    thread.finishing = distance('L');
    if (std::fabs(thread.finishing) > std::fabs(thread.depth))
        return core_.fail(Alarm::FagorValueRange, 'L', "L", number('L'));
    const double along =
        thread.face ? thread.end.x - thread.start.x : thread.end.z - thread.start.z;
    const double across =
        thread.face ? thread.end.z - thread.start.z : thread.end.x - thread.start.x;
    const double whole_way = std::hypot(along, across);
    // A positive pitch counts along the taper, a negative one along the axis.
    thread.lead = number('C') > 0 && whole_way > 0 ? distance('C') * std::fabs(along) / whole_way
                                                   : std::fabs(distance('C'));
    thread.lead_change = distance('M');
    if (thread.lead * thread.lead + 2 * thread.lead_change * std::fabs(along) <= 0)
        return core_.fail(Alarm::FagorCyclePitch, 'M');
    thread.exit = distance('J');
    if (std::fabs(thread.exit) > std::fabs(along))
        return core_.fail(Alarm::FagorValueRange, 'J', "J", number('J'));
    thread.angle_deg = has('A') ? number('A') : 30.0;
    if (std::fabs(thread.angle_deg) >= 90)
        return core_.fail(Alarm::FagorValueRange, 'A', "A", number('A'));
    if (has('H')) {
        std::int64_t entry = 0;
        if (!whole(*word('H'), entry)) return false;
        if (entry > 5)
            return core_.fail(Alarm::FagorValueRange, 'H', "H", static_cast<double>(entry));
        thread.entry = static_cast<int>(entry);
    }
    if (number('U') != 0 && number('U') != 1)
        return core_.fail(Alarm::FagorValueRange, 'U', "U", number('U'));
    thread.run_in = number('U') != 0;
    thread.spindle_deg = number('W');
    if (has('V')) {
        std::int64_t starts = 0;
        if (!whole(*word('V'), starts)) return false;
        if (starts > 100)
            return core_.fail(Alarm::FagorValueRange, 'V', "V", static_cast<double>(starts));
        thread.starts = starts > 0 ? static_cast<int>(starts) : 1;
    }
    if (has('K')) {  // repair: at the measured point the spindle is at W
        int p = -1, q = -1;
        core_.plane_axes(p, q);
        const double measured = thread.face ? length(number('K'), q) : length(number('K'), p);
        const double begin = thread.face ? thread.start.x : thread.start.z;
        const double turn = core_.path.spindle.turn == SpindleTurn::Ccw ? -1.0 : 1.0;
        thread.spindle_deg = number('W') + turn * (along >= 0 ? 1.0 : -1.0) * 360.0 *
                                               (begin - measured) / thread.lead;
    }
    follow_spindle(true);
    return cycles::cut_thread_section(core_, thread);
}

bool Interpreter::g_grooving(const GCode& row) {
    if (!begin_cycle_block() || !cycle_needs("XZQR") || !cycle_not_zero("C") ||
        !cycle_not_negative("CDK"))
        return false;
    drop_compensation();
    cycles::PlungedGroove groove;
    groove.along_x = row.number == 88;
    groove.start = cycle_point('Z', 'X');
    groove.end = cycle_point('R', 'Q');
    const ToolState& tool = core_.path.tool;
    const std::int64_t geometry = settings_.geometry_by_offset ? tool.ref.offset : tool.ref.number;
    groove.cutter = geometry > 0 ? values_.tool(ToolField::NoseWidth,
                                                static_cast<std::size_t>(geometry) % kTools)
                                 : 0.0;
    groove.step = has('C') ? distance('C') : groove.cutter;
    groove.safety = distance('D');
    if (!cycle_dwell(groove.dwell)) return false;
    const double depth =
        groove.along_x ? groove.start.x - groove.end.x : groove.start.z - groove.end.z;
    const double width =
        std::fabs(groove.along_x ? groove.start.z - groove.end.z : groove.start.x - groove.end.x);
    if (std::fabs(depth) < 1e-9)
        return core_.fail(Alarm::FagorGrooveDepth, groove.along_x ? 'Q' : 'R');
    if (width < groove.cutter - 1e-6)
        return core_.fail(Alarm::FagorGrooveWidth, groove.along_x ? 'R' : 'Q', {}, width,
                          groove.cutter);
    if (!(groove.step > 0)) return core_.fail(Alarm::FagorCycleZero, 'G', "C (NOSEW)");
    // The location code says which corner of the cutter the tool's point is (9.11, part 1 8.2.1).
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    const auto code = static_cast<std::size_t>(std::clamp(tool.tip, 0, 9));
    const auto along = static_cast<std::size_t>(groove.along_x ? p : q);
    double corner = groove.along_x ? compensation::kTipsAround[code].first
                                   : compensation::kTipsAround[code].second;
    if (modal_.mirrored >> along & 1u) corner = -corner;
    groove.far_corner =
        corner * (groove.along_x ? groove.end.z - groove.start.z : groove.end.x - groove.start.x) >
        0;
    const Point call = cycle_call_point();
    const double distance_now =
        ((groove.along_x ? call.x - groove.start.x : call.z - groove.start.z)) *
        (depth > 0 ? 1.0 : -1.0);
    if (distance_now < groove.safety - 1e-6)
        return core_.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
    return cycles::plunge_groove(core_, groove);
}

}  // namespace polyturn::channels::fagor
