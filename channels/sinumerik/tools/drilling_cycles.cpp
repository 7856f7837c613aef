// CYCLE81, CYCLE82, CYCLE85 and the rows and circles of holes HOLES1, HOLES2; MCALL repeats a cycle
// behind each block that moves. The manual names them and says that they must be understood
// (sinumerik_part1 4.3); what their parameters mean is the control's own:
//   RTP retract plane, RFP surface, SDIS distance in front of it (no sign), DP bottom or DPR depth
//   below RFP (no sign), DTB dwell in seconds (negative: revolutions), FFR and RFF feeds in and
//   out. Lengths lie along the axis perpendicular to the working plane.
#include "channels/sinumerik/tools/drilling_cycles.hpp"

#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/cycles/drilling.hpp"
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/geo_motion.hpp"
#include "channels/sinumerik/geometry/travel_limits.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// What all of them have in common; the hole's position is where the axes stand. A parameter whose 0
// would mean nothing is not given by 0, as the control's own screens write it: DPR, DTB, FFR, RFF.
bool hole_of(Execution& x, const Call& c, cycles::Drilling& hole) {
    const bool below = c.number(4) != 0;  // DPR, otherwise DP
    if (!c.has(0) || !c.has(1) || (!c.has(3) && !below))
        return fail(x, Alarm::ArgumentCountIllegal, std::string(x.core.at.cycle),
                    static_cast<double>(c.arguments.size()));
    if (x.core.compensating())
        return fail(x, Alarm::CodesContradict, std::string(x.core.at.cycle) + ", G41, G42");
    if (!update_feed(x)) return false;  // the block itself may have been a rapid one
    // G17, G18, G19
    static constexpr PlaneRole kApplicates[] = {PlaneRole::BasicZ, PlaneRole::BasicY,
                                                PlaneRole::BasicX};
    int place = -1;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (x.core.view().axes[i].role == kApplicates[active(x, 6) - 1])
            place = static_cast<int>(i);
    if (place < 0) return fail(x, Alarm::PlaneAxisMissing);
    const double retract = c.number(0) * unit(x), surface = c.number(1) * unit(x),
                 safety = std::fabs(c.number(2)) * unit(x);
    const double away = retract < surface ? -1.0 : 1.0;
    hole.axis = static_cast<unsigned>(place);
    hole.initial = retract;
    hole.r_level = surface + away * safety;
    hole.bottom = below ? surface - away * std::fabs(c.number(4)) * unit(x) : c.number(3) * unit(x);
    const bool between =
        away * (hole.initial - hole.r_level) >= 0 && away * (surface - hole.bottom) > 0;
    if (!between)
        return fail(x, Alarm::CycleValueIllegal, std::string(x.core.at.cycle) + " RTP, RFP, DP",
                    below ? c.number(4) : c.number(3));
    AxisValues deepest = x.core.path.programmed;
    for (const double level : {hole.r_level, hole.bottom, hole.initial}) {
        deepest[hole.axis] = level;
        if (!within_areas(x, deepest)) return false;
    }
    return true;
}

void dwell_of(const Call& c, cycles::Drilling& hole) {
    hole.dwells = c.number(5) != 0;
    hole.dwell = std::fabs(c.number(5));
    hole.dwell_revolutions = c.number(5) < 0;
}

bool drill_at(Execution& x, double p_mm, double q_mm) {
    const auto [p, q] = plane_places(x);
    AxisValues target = x.core.path.programmed;
    target[p] = p_mm;
    target[q] = q_mm;
    x.core.at.cycle = {};
    if (!within_areas(x, target) || !x.core.rapid(target)) return false;
    return !x.modal.call || !x.modal.call->cycle || modal_cycle(x);
}

}  // namespace

bool p_cycle81(Execution& x, Call& c) {
    x.core.at.cycle = "CYCLE81";
    cycles::Drilling hole;
    return hole_of(x, c, hole) && cycles::drill(x.core, hole);
}

bool p_cycle82(Execution& x, Call& c) {
    x.core.at.cycle = "CYCLE82";
    cycles::Drilling hole;
    if (!hole_of(x, c, hole)) return false;
    dwell_of(c, hole);
    return cycles::drill(x.core, hole);
}

// In with FFR, out with RFF as far as the safety distance, from there in rapid.
bool p_cycle85(Execution& x, Call& c) {
    x.core.at.cycle = "CYCLE85";
    cycles::Drilling hole;
    if (!hole_of(x, c, hole)) return false;
    dwell_of(c, hole);
    const double modal = x.core.path.feed;
    const double in = c.number(6) != 0 ? c.number(6) * feed_unit(x) : modal,
                 out = c.number(7) != 0 ? c.number(7) * feed_unit(x) : in;
    if (!(in > 0) || !(out > 0))
        return fail(x, Alarm::CycleValueIllegal, "CYCLE85 FFR, RFF", in > 0 ? out : in);
    hole.travel_out = cycles::Drilling::Way::Feed;
    hole.travel_out_factor = out / in;
    x.core.path.feed = in;
    const bool good = cycles::drill(x.core, hole);
    x.core.path.feed = modal;
    return good;
}

// The cycle of MCALL, where the axes stand now.
bool modal_cycle(Execution& x) {
    Call call;
    call.arguments = x.modal.call->arguments;
    return x.modal.call->cycle->act(x, call);
}

// HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): from a point along a line; HOLES2(CPA, CPO, RAD, STA1,
// INDA, NUM): round a centre, INDA 0: evenly.
bool p_holes(Execution& x, Call& c) {
    const bool line = x.block.procedures.front().first->name == "HOLES1";
    const bool program = x.modal.call && !x.modal.call->cycle;
    if (x.pass.at_hole) c.arguments = x.pass.at_hole->arguments;
    const double count = c.number(5);
    if (!needs_plane(x)) return false;
    if (!(count >= 1 && count <= 10'000) || count != std::floor(count))
        return fail(x, Alarm::CycleValueIllegal, "NUM", count);
    const double p = c.number(0) * unit(x), q = c.number(1) * unit(x);
    const double step = c.number(4) != 0 ? c.number(4) : 360.0 / count;
    const auto holes = static_cast<int>(count);
    const int first = x.pass.at_hole ? x.pass.at_hole->hole + 1 : 0;
    const bool one = program && std::ranges::none_of(x.calls.levels, &Level::modal_call);
    for (int k = first; k < (one ? first + 1 : holes); ++k) {
        const double angle = (line ? c.number(2) : c.number(3) + k * step) * kDegree;
        const double way = (line ? c.number(3) + k * c.number(4) : c.number(2)) * unit(x);
        if (!drill_at(x, p + way * std::cos(angle), q + way * std::sin(angle))) return false;
    }
    // after_block() calls
    if (one)
        x.pass.at_hole =
            std::make_shared<const HolePattern>(HolePattern{c.arguments, first, holes});
    else
        x.pass.ways_before = x.core.ways();  // MCALL has had its turn
    return true;
}

}  // namespace polyturn::channels::sinumerik
