// CYCLE81, CYCLE82, CYCLE85 and the rows and circles of holes HOLES1, HOLES2; MCALL repeats a cycle
// behind each block that moves. The manual names them and says that they must be understood
// (sinumerik_part1 4.3); what their parameters mean is the control's own:
//   RTP retract plane, RFP surface, SDIS distance in front of it (no sign), DP bottom or DPR depth
//   below RFP (no sign), DTB dwell in seconds (negative: revolutions), FFR and RFF feeds in and
//   out. Lengths lie along the axis perpendicular to the working plane.
#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/cycles/drilling.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// What all of them have in common; the hole's position is where the axes stand. A parameter whose 0
// would mean nothing is not given by 0, as the control's own screens write it: DPR, DTB, FFR, RFF.
bool Interpreter::hole_of(const Call& c, cycles::Drilling& hole) {
    const bool below = c.number(4) != 0;  // DPR, otherwise DP
    if (!c.has(0) || !c.has(1) || (!c.has(3) && !below))
        return fail(Alarm::ArgumentCountIllegal, std::string(core_.at.cycle),
                    static_cast<double>(c.arguments.size()));
    if (core_.compensating())
        return fail(Alarm::CodesContradict, std::string(core_.at.cycle) + ", G41, G42");
    if (!update_feed()) return false;  // the block itself may have been a rapid one
    // G17, G18, G19
    static constexpr PlaneRole kApplicates[] = {PlaneRole::BasicZ, PlaneRole::BasicY,
                                                PlaneRole::BasicX};
    int place = -1;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (core_.view().axes[i].role == kApplicates[active(6) - 1]) place = static_cast<int>(i);
    if (place < 0) return fail(Alarm::PlaneAxisMissing);
    const double retract = c.number(0) * unit(), surface = c.number(1) * unit(),
                 safety = std::fabs(c.number(2)) * unit();
    const double away = retract < surface ? -1.0 : 1.0;
    hole.axis = static_cast<unsigned>(place);
    hole.initial = retract;
    hole.r_level = surface + away * safety;
    hole.bottom = below ? surface - away * std::fabs(c.number(4)) * unit() : c.number(3) * unit();
    const bool between =
        away * (hole.initial - hole.r_level) >= 0 && away * (surface - hole.bottom) > 0;
    if (!between)
        return fail(Alarm::CycleValueIllegal, std::string(core_.at.cycle) + " RTP, RFP, DP",
                    below ? c.number(4) : c.number(3));
    AxisValues deepest = core_.path.programmed;
    for (const double level : {hole.r_level, hole.bottom, hole.initial}) {
        deepest[hole.axis] = level;
        if (!within_areas(deepest)) return false;
    }
    return true;
}

void Interpreter::dwell_of(const Call& c, cycles::Drilling& hole) {
    hole.dwells = c.number(5) != 0;
    hole.dwell = std::fabs(c.number(5));
    hole.dwell_revolutions = c.number(5) < 0;
}

bool Interpreter::p_cycle81(Call& c) {
    core_.at.cycle = "CYCLE81";
    cycles::Drilling hole;
    return hole_of(c, hole) && cycles::drill(core_, hole);
}

bool Interpreter::p_cycle82(Call& c) {
    core_.at.cycle = "CYCLE82";
    cycles::Drilling hole;
    if (!hole_of(c, hole)) return false;
    dwell_of(c, hole);
    return cycles::drill(core_, hole);
}

// In with FFR, out with RFF as far as the safety distance, from there in rapid.
bool Interpreter::p_cycle85(Call& c) {
    core_.at.cycle = "CYCLE85";
    cycles::Drilling hole;
    if (!hole_of(c, hole)) return false;
    dwell_of(c, hole);
    const double modal = core_.path.feed;
    const double in = c.number(6) != 0 ? c.number(6) * feed_unit() : modal,
                 out = c.number(7) != 0 ? c.number(7) * feed_unit() : in;
    if (!(in > 0) || !(out > 0))
        return fail(Alarm::CycleValueIllegal, "CYCLE85 FFR, RFF", in > 0 ? out : in);
    hole.travel_out = cycles::Drilling::Way::Feed;
    hole.travel_out_factor = out / in;
    core_.path.feed = in;
    const bool good = cycles::drill(core_, hole);
    core_.path.feed = modal;
    return good;
}

// The cycle of MCALL, where the axes stand now.
bool Interpreter::modal_cycle() {
    Call call;
    call.arguments = modal_.call->arguments;
    return (this->*modal_.call->cycle->act)(call);
}

bool Interpreter::drill_at(double p_mm, double q_mm) {
    const auto [p, q] = plane_places();
    AxisValues target = core_.path.programmed;
    target[p] = p_mm;
    target[q] = q_mm;
    core_.at.cycle = {};
    if (!within_areas(target) || !core_.rapid(target)) return false;
    return !modal_.call || !modal_.call->cycle || modal_cycle();
}

// HOLES1(SPCA, SPCO, STA1, FDIS, DBH, NUM): from a point along a line; HOLES2(CPA, CPO, RAD, STA1,
// INDA, NUM): round a centre, INDA 0: evenly.
bool Interpreter::p_holes(Call& c) {
    const bool line = block_.procedures.front().first->name == "HOLES1";
    const bool program = modal_.call && !modal_.call->cycle;
    if (at_hole_) c.arguments = at_hole_->arguments;
    const double count = c.number(5);
    if (!needs_plane()) return false;
    if (!(count >= 1 && count <= 10'000) || count != std::floor(count))
        return fail(Alarm::CycleValueIllegal, "NUM", count);
    const double p = c.number(0) * unit(), q = c.number(1) * unit();
    const double step = c.number(4) != 0 ? c.number(4) : 360.0 / count;
    const auto holes = static_cast<int>(count);
    const int first = at_hole_ ? at_hole_->hole + 1 : 0;
    const bool one = program && std::ranges::none_of(levels_, &Level::modal_call);
    for (int k = first; k < (one ? first + 1 : holes); ++k) {
        const double angle = (line ? c.number(2) : c.number(3) + k * step) * kDegree;
        const double way = (line ? c.number(3) + k * c.number(4) : c.number(2)) * unit();
        if (!drill_at(p + way * std::cos(angle), q + way * std::sin(angle))) return false;
    }
    // after_block() calls
    if (one)
        at_hole_ = std::make_shared<const HolePattern>(HolePattern{c.arguments, first, holes});
    else
        ways_before_ = core_.ways();  // MCALL has had its turn
    return true;
}

}  // namespace polyturn::channels::sinumerik
