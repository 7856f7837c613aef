// Nose-radius compensation as the channel's state sees it: when it stands between Core and the sink, and which nose cuts.
#include "channels/compensation/compensator.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

using compensation::Vec;

// From the nose centre to the imaginary tip, as a share of the radius: Z and X of the directions 0 to 9.
constexpr Vec kTip[10] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}};

bool tip_outside_its_plane(const PathState& path) { return path.plane != Plane::ZX && path.tool.tip >= 1 && path.tool.tip <= 8; }

}  // namespace

Core::~Core() = default;

void Core::compensation_options(const compensation::Options& options) { comp_options_ = options; }

bool Core::compensation(CompSide side) {
    if (side == CompSide::Off) return compensation_off(0.0, 0.0);
    int p = -1, q = -1;
    plane_axes(p, q);
    if (p < 0 || q < 0) return fail(Alarm::PlaneAxisMissing, 'G');
    if (tip_outside_its_plane(path)) return fail(Alarm::CompTipPlane, 'G', {}, path.tool.tip);
    if (!compensating_) {
        if (!comp_) comp_ = std::make_unique<compensation::Compensator>();
        comp_->open(*out_, static_cast<unsigned>(p), static_cast<unsigned>(q), comp_options_);
        sink_ = comp_.get();
        compensating_ = true;
    }
    comp_side_ = side;
    select_side();
    return true;
}

void Core::select_side() {
    const bool left = (comp_side_ == CompSide::Left) != frame_mirrors_plane();
    at.comp = left ? CompSide::Left : CompSide::Right;
    comp_->select(left ? 1 : -1);
}

bool Core::compensation_off(double wish_p, double wish_q) {
    at.comp = comp_side_ = CompSide::Off;
    if (compensating_) comp_->cancel_towards({wish_p, wish_q});
    return true;
}

void Core::compensation_reset() {
    at.comp = comp_side_ = CompSide::Off;
    sink_ = out_;
    compensating_ = false;
    comp_.reset();
}

// The nose that cuts the move about to be delivered.
void Core::tell_nose() {
    const ToolState& tool = path.tool;
    const bool tip = path.plane == Plane::ZX && tool.tip >= 0 && tool.tip <= 9;
    comp_->nose(tool.nose_radius, tip ? kTip[tool.tip] : Vec{}, (tool.geometry != 0 || tool.wear != 0) && !tool.nose_off);
}

void Core::tell_zero_distance() { comp_->zero_distance(); }

bool Core::end_compensated_block(bool counts, bool wants_barrier, bool program_ends) {
    if (program_ends) comp_->settle();
    comp_->block_done(counts);
    if (wants_barrier) comp_->ensure_halt(at);
    if (comp_->failed()) return compensation_failed();
    if (comp_->closed()) {
        sink_ = out_;
        compensating_ = false;
    }
    return true;
}

bool Core::compensation_failed() {
    if (!comp_->failed()) return true;
    const auto& fault = comp_->fault();
    if (fault.alarm == Alarm{}) return true;   // somebody else's alarm: it was told
    fail(fault.alarm, fault.this_block ? 'G' : 0);
    if (!fault.this_block) fault_.block = fault.at;
    return false;
}

bool Core::holds_block() const { return compensating_ && comp_->holds_block(); }

bool Core::halted() const { return comp_->halted(); }

bool Core::barrier_passed() {
    if (!compensating_) return true;
    comp_->resume();
    return !comp_->holds() && !comp_->halted();
}

double Core::machine_now(unsigned i) const {
    int p = -1, q = -1;
    if (!compensating_) return path.machine[i];
    plane_axes(p, q);
    const Vec d = comp_->displacement();
    return path.machine[i] + (static_cast<int>(i) == p ? d.p : static_cast<int>(i) == q ? d.q : 0.0);
}

// G53, G28, G30: the vector of all axes goes as soon as one of the plane is named.
void Core::suspend_compensation(AxisSet which) {
    int p = -1, q = -1;
    const AxisSet plane = plane_axes(p, q);
    if (!(which & plane)) {
        comp_->settle();
        return;
    }
    comp_->suspend();
    if (comp_->displaced()) forced_ = plane;
}

void Core::begin_cycle(CycleMoves how) {
    using Bypass = compensation::Compensator::Bypass;
    if (compensating_) comp_->bypass(how == CycleMoves::Plain ? Bypass::Plain : Bypass::Shifted);
}

void Core::end_cycle() {
    if (compensating_) comp_->bypass(compensation::Compensator::Bypass::None);
}

//   tip = programmed + shift along one axis a;   centre = tip - r*e must lie at distance r:  (shift*a - r*e) . n = r
//   shift = r * (1 + e.n) / (a.n)                n normal of the cut towards the outside
double Core::cut_shift(const AxisValues& a, const AxisValues& b, unsigned along, const AxisValues& outside) const {
    int p = -1, q = -1;
    plane_axes(p, q);
    const ToolState& tool = path.tool;
    if (!compensating_ || p < 0 || q < 0 || (tool.geometry == 0 && tool.wear == 0) || tool.nose_off) return 0.0;
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const AxisValues from = path.framed ? framed(a) : a, to = path.framed ? framed(b) : b, out = path.framed ? framed(outside) : outside;
    const Vec cut{to[i] - from[i], to[k] - from[k]};
    if (compensation::length(cut) == 0) return 0.0;
    Vec n = compensation::left_of(compensation::unit(cut));
    if (compensation::dot(n, {out[i] - from[i], out[k] - from[k]}) < 0) n = -1.0 * n;
    double share = along == i ? n.p : n.q;
    if (path.framed) {   // the ends move along the programmed axis; the nose lies outside the frame
        AxisValues ahead = a;
        ahead[along] += 1.0;
        const AxisValues there = framed(ahead);
        share = compensation::dot(n, {there[i] - from[i], there[k] - from[k]});
    }
    if (std::fabs(share) < 1e-6) return 0.0;
    const bool tip = path.plane == Plane::ZX && tool.tip >= 0 && tool.tip <= 9;
    return std::fabs(tool.nose_radius) * (1.0 + compensation::dot(tip ? kTip[tool.tip] : Vec{}, n)) / share;
}

void Core::drop_compensation_vector() { comp_->drop_vector(); }

}  // namespace polyturn::channels
