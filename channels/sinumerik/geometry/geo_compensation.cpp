// Tool radius compensation: G40 G41 G42 and what shapes it - NORM KONT KONTT KONTC, G450 G451, G460
// to G462, OFFN (sinumerik_part2 11).
#include "channels/sinumerik/geometry/geo_compensation.hpp"

#include "channels/sinumerik/act.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/tools/tools.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Does the frame turn the working plane out of a plane of the machine? Then CUT2D and CUT2DF differ
// (11.6).
bool tilted(Execution& x) {
    if (!x.core.path.framed) return false;
    static constexpr std::size_t kApplicate[] = {2, 1, 0};
    const std::size_t w = kApplicate[static_cast<std::size_t>(x.core.path.plane)];
    for (std::size_t k = 0; k < 3; ++k)
        if (k != w && (std::fabs(x.core.path.frame.linear[k][w]) > 1e-12 ||
                       std::fabs(x.core.path.frame.linear[w][k]) > 1e-12))
            return true;
    return false;
}

}  // namespace

bool update_compensation(Execution& x) {
    using namespace compensation;
    Options options;
    // NORM KONT KONTT KONTC
    static constexpr Entry kEntries[] = {Entry::Direct, Entry::Tangent, Entry::Smooth,
                                         Entry::Curved};
    options.entry = kEntries[active(x, 17) - 1];
    options.corner = active(x, 18) == 2 ? Corner::Intersection : Corner::Arc;
    options.overshoot = std::fmin(x.modal.geo.disc, x.settings.highest_disc) / 100.0;
    options.closed_meets_at_start = x.settings.comp_closed_start;
    options.intersection_from_deg = 180.0 - x.settings.corner_limit_deg;
    // G460 G461 G462
    static constexpr ShortLast kShortLast[] = {ShortLast::TravelOut, ShortLast::Circle,
                                               ShortLast::Line};
    options.short_last = kShortLast[active(x, 48) - 1];
    options.looks_back = true;
    // 11.5: of three known blocks one
    options.leaves_out = x.settings.comp_known_blocks > 2
                             ? static_cast<unsigned>(x.settings.comp_known_blocks) - 2
                             : 0;
    options.farthest_meeting = active(x, 23) == 2;
    options.arc_feed = active(x, 16) == 1   ? ArcFeed::Contour
                       : active(x, 16) == 3 ? ArcFeed::Inner
                                            : ArcFeed::Centre;
    options.small_vector = kTangentialMm;
    options.constant = active(x, 40) == 2;
    options.idle_blocks = static_cast<unsigned>(x.settings.comp_idle_blocks);
    options.idle_is_fault = true;
    x.core.update_compensation(options);
    return true;
}

// Groups 16 17 18 23 40 48: they act with the moves of their block.
bool geo_comp_option(Execution& x, const GCode& code) {
    activate(x, code.group, code.number);
    return update_compensation(x);
}

// group 22: CUT2DD CUT2DFD count the radius wear only
bool geo_comp_kind(Execution& x, const GCode& code) {
    activate(x, code.group, code.number);
    apply_tool(x);
    return true;
}

bool geo_compensation(Execution& x, const GCode& code) {
    x.modal.geo.side_before = static_cast<std::uint8_t>(active(x, 7));
    const unsigned entry = active(x, 17), kind = active(x, 22);
    const bool plane_only = kind <= 2 || kind == 9 || kind == 10;  // CUT2D CUT2DF CUT2DD CUT2DFD
    if ((code.number != 1 || x.core.compensating()) && !plane_only)
        return fail(x, Alarm::NotBuilt, std::string(find_g(22, kind)->name));
    // approach or retract becomes a polynomial: G1 only (11.2)
    if ((code.number == 1) == x.core.compensating() && entry > 2) {
        const std::string name(find_g(17, entry)->name);
        const GCode* way = motion_code(x);
        if (way && (way->group != 1 || way->number != 2) && axis_words(x))
            return fail(x, Alarm::CodesContradict, name + ", " + std::string(way->name));
        if (x.core.path.transformation.active()) return fail(x, Alarm::NotBuilt, name);
    }
    // the retract ends it itself
    if (const GCode* soft = x.block.coded[2];
        code.number == 1 && soft && soft->number >= 14 && soft->number <= 16)
        return true;
    const GCode* motion = motion_code(x);
    const bool arc = motion && motion->group == 1 && motion->number > 2;
    if (code.number == 1) {
        if (arc && x.core.compensating() && axis_words(x)) return fail(x, Alarm::CompArcEnd);
        return x.core.compensation_off(0.0, 0.0);
    }
    if (arc && !x.core.compensating()) return fail(x, Alarm::CompArcStartEnd);
    // CUT2DF CUT2DFD; CUT2D stays in the plane of the machine
    const bool in_frame = kind == 2 || kind == 10;
    if (in_frame && tilted(x) && !x.core.frame_inclines())
        return fail(x, Alarm::SubframeRotates, std::string(code.name));
    x.core.lie_in_frame(in_frame, true);
    if (!update_compensation(x)) return false;
    return x.core.compensation(code.number == 2 ? CompSide::Left : CompSide::Right);
}

}  // namespace polyturn::channels::sinumerik
