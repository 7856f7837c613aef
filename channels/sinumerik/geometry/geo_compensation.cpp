// Tool radius compensation: G40 G41 G42 and what shapes it - NORM KONT KONTT KONTC, G450 G451, G460
// to G462, OFFN (sinumerik_part2 11).
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::update_compensation() {
    using namespace compensation;
    Options options;
    // NORM KONT KONTT KONTC
    static constexpr Entry kEntries[] = {Entry::Direct, Entry::Tangent, Entry::Smooth,
                                         Entry::Curved};
    options.entry = kEntries[active(17) - 1];
    options.corner = active(18) == 2 ? Corner::Intersection : Corner::Arc;
    options.overshoot = std::fmin(modal_.geo.disc, settings_.highest_disc) / 100.0;
    options.closed_meets_at_start = settings_.comp_closed_start;
    options.intersection_from_deg = 180.0 - settings_.corner_limit_deg;
    // G460 G461 G462
    static constexpr ShortLast kShortLast[] = {ShortLast::TravelOut, ShortLast::Circle,
                                               ShortLast::Line};
    options.short_last = kShortLast[active(48) - 1];
    options.looks_back = true;
    // 11.5: of three known blocks one
    options.leaves_out = settings_.comp_known_blocks > 2
                             ? static_cast<unsigned>(settings_.comp_known_blocks) - 2
                             : 0;
    options.farthest_meeting = active(23) == 2;
    options.arc_feed = active(16) == 1   ? ArcFeed::Contour
                       : active(16) == 3 ? ArcFeed::Inner
                                         : ArcFeed::Centre;
    options.small_vector = kTangentialMm;
    options.constant = active(40) == 2;
    options.idle_blocks = static_cast<unsigned>(settings_.comp_idle_blocks);
    options.idle_is_fault = true;
    core_.update_compensation(options);
    return true;
}

// Groups 16 17 18 23 40 48: they act with the moves of their block.
bool Interpreter::geo_comp_option(const GCode& code) {
    activate(code.group, code.number);
    return update_compensation();
}

// group 22: CUT2DD CUT2DFD count the radius wear only
bool Interpreter::geo_comp_kind(const GCode& code) {
    activate(code.group, code.number);
    apply_tool();
    return true;
}

// Does the frame turn the working plane out of a plane of the machine? Then CUT2D and CUT2DF differ
// (11.6).
bool Interpreter::tilted() {
    if (!core_.path.framed) return false;
    static constexpr std::size_t kApplicate[] = {2, 1, 0};
    const std::size_t w = kApplicate[static_cast<std::size_t>(core_.path.plane)];
    for (std::size_t k = 0; k < 3; ++k)
        if (k != w && (std::fabs(core_.path.frame.linear[k][w]) > 1e-12 ||
                       std::fabs(core_.path.frame.linear[w][k]) > 1e-12))
            return true;
    return false;
}

bool Interpreter::geo_compensation(const GCode& code) {
    modal_.geo.side_before = static_cast<std::uint8_t>(active(7));
    const unsigned entry = active(17), kind = active(22);
    const bool plane_only = kind <= 2 || kind == 9 || kind == 10;  // CUT2D CUT2DF CUT2DD CUT2DFD
    if ((code.number != 1 || core_.compensating()) && !plane_only)
        return fail(Alarm::NotBuilt, std::string(find_g(22, kind)->name));
    // approach or retract becomes a polynomial: G1 only (11.2)
    if ((code.number == 1) == core_.compensating() && entry > 2) {
        const std::string name(find_g(17, entry)->name);
        const GCode* way = motion_code();
        if (way && (way->group != 1 || way->number != 2) && axis_words())
            return fail(Alarm::CodesContradict, name + ", " + std::string(way->name));
        if (core_.path.transformation.active()) return fail(Alarm::NotBuilt, name);
    }
    // the retract ends it itself
    if (const GCode* soft = block_.coded[2];
        code.number == 1 && soft && soft->number >= 14 && soft->number <= 16)
        return true;
    const GCode* motion = motion_code();
    const bool arc = motion && motion->group == 1 && motion->number > 2;
    if (code.number == 1) {
        if (arc && core_.compensating() && axis_words()) return fail(Alarm::CompArcEnd);
        return core_.compensation_off(0.0, 0.0);
    }
    if (arc && !core_.compensating()) return fail(Alarm::CompArcStartEnd);
    // CUT2DF CUT2DFD; CUT2D stays in the plane of the machine
    const bool in_frame = kind == 2 || kind == 10;
    if (in_frame && tilted() && !core_.frame_inclines())
        return fail(Alarm::SubframeRotates, std::string(code.name));
    core_.lie_in_frame(in_frame, true);
    if (!update_compensation()) return false;
    return core_.compensation(code.number == 2 ? CompSide::Left : CompSide::Right);
}

}  // namespace polyturn::channels::sinumerik
