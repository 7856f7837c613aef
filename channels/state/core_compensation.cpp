// Nose-radius compensation as part of the channel's state: when it is between Core and the sink,
// and which nose cuts.
#include <cmath>
#include <limits>

#include "channels/compensation/compensator.hpp"
#include "channels/pipeline/factor_sink.hpp"
#include "channels/pipeline/inclined_sink.hpp"
#include "channels/pipeline/route_sink.hpp"
#include "channels/pipeline/transform_sink.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

using compensation::Vec;

Vec tip_of(const compensation::Options& options, std::int32_t tip) {
    const auto& [p, q] = (*options.tips)[static_cast<std::size_t>(tip)];
    return {p, q};
}

bool tip_outside_its_plane(const PathState& path) {
    return path.plane != Plane::ZX && path.tool.tip >= 1 && path.tool.tip <= 8;
}

}  // namespace

Core::~Core() = default;

void Core::compensation_options(const compensation::Options& options) { comp_options_ = options; }

// Calls to compensation wait behind a move that is held for its corner.
template <class Told>
void Core::tell_comp(Told&& told) {
    if (staged_ && stage_->holding())
        stage_->later([this, told] { tell_comp(told); });
    else
        told(*comp_);
}

void Core::update_compensation(const compensation::Options& options) {
    comp_options_ = options;
    if (reads_ahead())
        tell_comp([options](compensation::Compensator& comp) { comp.set_options(options); });
}

bool Core::compensation(CompSide side) {
    if (side == CompSide::Off) return compensation_off(0.0, 0.0);
    int p = -1, q = -1;
    plane_axes(p, q);
    if (p < 0 || q < 0) return fail(Alarm::PlaneAxisMissing, 'G');
    if (tip_outside_its_plane(path)) return fail(Alarm::CompTipPlane, 'G', {}, path.tool.tip);
    if (!compensating_) {
        // a corner lies in the other plane
        if (reads_ahead() && inclined_ != (comp_in_frame_ && frame_inclines()))
            return fail(Alarm::SubframeRotates, 'G', "G41, G42");
        chain(comp_in_frame_);
        tell_comp([p, q, options = comp_options_](compensation::Compensator& comp) {
            if (comp.off())
                comp.configure(static_cast<unsigned>(p), static_cast<unsigned>(q), options);
        });
        compensating_ = true;
    }
    comp_side_ = side;
    select_side();
    return true;
}

void Core::select_side() {
    const bool left = (comp_side_ == CompSide::Left) != frame_mirrors_plane();
    at.comp = left ? CompSide::Left : CompSide::Right;
    tell_comp([left](compensation::Compensator& comp) { comp.select(left ? 1 : -1); });
}

// Both stages are put into the chain, or are there already.
void Core::chain(bool in_frame) {
    if (reads_ahead()) return;
    if (!comp_) comp_ = std::make_unique<compensation::Compensator>();
    if (factors_) factors_->start(path.machine);
    comp_->open(incline(in_frame), 0, 1, comp_options_);
    sink_ = comp_.get();
}

bool Core::stage_corners() {
    int p = -1, q = -1;
    plane_axes(p, q);
    if (p < 0 || q < 0) return fail(Alarm::PlaneAxisMissing);
    if (!staged_) {
        chain(corners_in_frame_);
        if (!stage_) stage_ = std::make_unique<corners::CornerStage>();
        stage_->open(*comp_);
        sink_ = stage_.get();
        staged_ = true;
    }
    if (stage_->holding()) return true;  // its own plane is that of the held move
    AxisSet geometry = 0;
    for (const int place : geo_)
        if (place >= 0) geometry |= 1u << place;
    stage_->plane(static_cast<unsigned>(p), static_cast<unsigned>(q), geometry);
    return true;
}

bool Core::corner(const corners::Call& call) {
    if (!stage_corners()) return false;
    stage_->want(call);
    return true;
}

bool Core::reserve_move(Alarm lost) {
    if (!stage_corners()) return false;
    stage_->reserve(lost, at);
    return true;
}

void Core::compensation_resumes() {
    if (compensating_) tell_comp([](compensation::Compensator& comp) { comp.resume_at_vector(); });
}

bool Core::compensation_off(double wish_p, double wish_q) {
    at.comp = comp_side_ = CompSide::Off;
    if (compensating_)
        tell_comp([wish_p, wish_q](compensation::Compensator& comp) {
            comp.cancel_towards({wish_p, wish_q});
        });
    return true;
}

void Core::compensation_reset() {
    at.comp = comp_side_ = CompSide::Off;
    sink_ = out_;
    compensating_ = staged_ = inclined_ = false;
    comp_.reset();
    stage_.reset();
}

// The nose that cuts the move about to be delivered.
void Core::tell_nose() {
    const ToolState& tool = path.tool;
    const bool tip = path.plane == Plane::ZX && tool.tip >= 0 && tool.tip <= 9;
    const double radius = tool.nose_radius + tool.allowance;
    const Vec from_centre =
        std::fabs(tool.nose_radius) * (tip ? tip_of(comp_options_, tool.tip) : Vec{});
    const bool has_offset = (tool.geometry != 0 || tool.wear != 0) && !tool.nose_off;
    // The contour does not bend where a straight block takes the tool over to another offset
    // (fanuc_lathe 1.4, 2.1).
    Vec step;
    int p = -1, q = -1;
    plane_axes(p, q);
    const bool straight = move_.kind == MoveKind::Rapid || move_.kind == MoveKind::Linear;
    if (straight && !offset_alone_ && !inclined_ && !path.factored && p >= 0 && q >= 0) {
        const auto change = [this](int place) {
            return path.wanted[static_cast<std::size_t>(place)] -
                   path.vector[static_cast<std::size_t>(place)];
        };
        step = {change(p), change(q)};
    }
    if (!staged_)
        comp_->nose(radius, from_centre, has_offset, step);
    else
        tell_comp([radius, from_centre, has_offset](compensation::Compensator& comp) {
            comp.nose(radius, from_centre, has_offset);
        });
}

// Of the plane; an axis outside it that does not move moves nothing in it, as when it moves
// (fanuc_lathe 3.12).
void Core::tell_zero_distance() {
    int p = -1, q = -1;
    if (fixture_named_ != 0 && (fixture_named_ & plane_axes(p, q)) == 0) return;
    tell_comp([](compensation::Compensator& comp) { comp.zero_distance(); });
}

bool Core::end_compensated_block(bool counts, bool wants_barrier, bool program_ends) {
    if (program_ends) {
        if (staged_) stage_->flush();
        comp_->settle();
    }
    if (staged_) {
        stage_->forget_want();  // the block made no move
        stage_->block_done();
    }
    tell_comp([counts](compensation::Compensator& comp) { comp.block_done(counts); });
    if (wants_barrier)
        tell_comp([here = at](compensation::Compensator& comp) { comp.ensure_halt(here); });
    if (!compensation_failed()) return false;
    // Where something in between must be executed first (M0, a wait), what follows it is
    // still there: reading stops.
    if (staged_ && !stage_->holding() && (compensating_ || comp_->closed())) {
        staged_ = false;
        sink_ = comp_.get();
    }
    if (!staged_ && comp_->closed()) {
        sink_ = out_;
        compensating_ = inclined_ = false;
    }
    return true;
}

bool Core::compensation_failed() {
    if (staged_ && stage_->failed() && stage_->fault() != Alarm{}) {
        fail(stage_->fault(), stage_->fault_letter(),
             stage_->fault() == Alarm::FagorTangential ? "G37, G38, G39" : "");
        fault_.block = stage_->fault_block();
        return false;
    }
    if (!comp_->failed()) return true;
    const auto& fault = comp_->fault();
    if (fault.alarm == Alarm{}) return true;  // another stage's alarm: it was reported
    const bool here = fault.this_block && fault.at.serial == at.serial;
    fail(fault.alarm, here ? 'G' : 0);
    if (!here) fault_.block = fault.at;
    return false;
}

bool Core::holds_block() const {
    return reads_ahead() && (comp_->holds_block() || (staged_ && stage_->holding()));
}

void Core::barrier_before_held() { comp_->halt_before_held(at); }

bool Core::halted() const { return comp_->halted(); }

bool Core::barrier_passed() {
    if (reads_ahead()) {
        // read on already: they begin at the machine's present position
        const bool moves_follow = comp_->holds_moves_back();
        comp_->resume();
        if (moves_follow || (staged_ && stage_->holding()) || comp_->holds() || comp_->halted())
            return false;
    }
    // The PLC may have given the channel another spindle: what was said to the old one does not
    // hold for it.
    if (const auto chosen = static_cast<std::uint16_t>(port_->selected_spindle());
        chosen != 0 && chosen != path.spindle.spindle) {
        path.spindle = {};
        path.spindle.spindle = chosen;
    }
    return true;
}

double Core::machine_now(unsigned i) const {
    int p = -1, q = -1;
    if (!compensating_) return path.machine[i];
    plane_axes(p, q);
    const Vec d = comp_->displacement();
    if (inclined_) return path.machine[i] + displaced_along(i, d.p, d.q);
    const double f = path.factored ? path.factor[i] : 1.0;
    return path.machine[i] + f * (static_cast<int>(i) == p   ? d.p
                                  : static_cast<int>(i) == q ? d.q
                                                             : 0.0);
}

// G53, G28, G30: the vector of all axes goes as soon as one of the plane is named.
void Core::suspend_compensation(AxisSet which) {
    int p = -1, q = -1;
    const AxisSet plane = plane_axes(p, q);
    if (staged_) stage_->cut_off();
    if (!(which & plane)) {
        comp_->settle();
        return;
    }
    comp_->suspend();
    if (comp_->displaced()) forced_ = plane;
}

void Core::begin_cycle(CycleMoves how) {
    using Bypass = compensation::Compensator::Bypass;
    if (staged_) stage_->cut_off();
    if (compensating_) comp_->bypass(how == CycleMoves::Plain ? Bypass::Plain : Bypass::Shifted);
}

void Core::end_cycle() {
    if (compensating_) comp_->bypass(compensation::Compensator::Bypass::None);
}

//   tip = programmed + shift along one axis a;   centre = tip - r*e must lie at distance r:
//                                                (shift*a - r*e) . n = r
//   shift = r * (1 + e.n) / (a.n)                n normal of the cut towards the outside
double Core::cut_shift(const AxisValues& a, const AxisValues& b, unsigned along,
                       const AxisValues& outside) const {
    int p = -1, q = -1;
    plane_axes(p, q);
    const ToolState& tool = path.tool;
    if (!compensating_ || p < 0 || q < 0 || (tool.geometry == 0 && tool.wear == 0) || tool.nose_off)
        return 0.0;
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const auto around = [this](const AxisValues& point) {
        return path.framed ? before_factors(framed(point)) : point;
    };
    const AxisValues from = around(a), to = around(b), out = around(outside);
    const Vec cut{to[i] - from[i], to[k] - from[k]};
    if (compensation::length(cut) == 0) return 0.0;
    Vec n = compensation::left_of(compensation::unit(cut));
    if (compensation::dot(n, {out[i] - from[i], out[k] - from[k]}) < 0) n = -1.0 * n;
    double share = along == i ? n.p : n.q;
    if (path.framed) {  // the ends move along the programmed axis; the nose lies outside the frame
        AxisValues ahead = a;
        ahead[along] += 1.0;
        const AxisValues there = around(ahead);
        share = compensation::dot(n, {there[i] - from[i], there[k] - from[k]});
    }
    if (std::fabs(share) < 1e-6) return std::numeric_limits<double>::quiet_NaN();
    const bool tip = path.plane == Plane::ZX && tool.tip >= 0 && tool.tip <= 9;
    return (std::fabs(tool.nose_radius + tool.allowance) +
            std::fabs(tool.nose_radius) *
                compensation::dot(tip ? tip_of(comp_options_, tool.tip) : Vec{}, n)) /
           share;
}

void Core::drop_compensation_vector() {
    if (staged_) stage_->cut_off();
    comp_->drop_vector();
}

}  // namespace polyturn::channels
