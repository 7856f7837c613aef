// What the machine does in a block once the vectors at both its ends are known.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/angles.hpp"
#include "channels/compensation/compensator.hpp"
#include "channels/compensation/conic.hpp"
#include "channels/compensation/interference.hpp"

namespace polyturn::channels::compensation {
namespace {

constexpr double kNoseStands = 1e-7;  // mm

}  // namespace

Vec Compensator::begins_at(const Move& m) const {
    return {m.machine_start[p_], m.machine_start[q_]};
}

void Compensator::deliver(const Move& m, const BlockContext& at) {
    if (ready_.empty() && !halted_) {
        out_->move(m, at);
        return;
    }
    ready_.move(m, at);
    pump();
}

void Compensator::shift(Move& m, Vec by) const {
    m.machine_start[p_] += by.p;
    m.machine_start[q_] += by.q;
    m.machine[p_] += by.p;
    m.machine[q_] += by.q;
    m.pos[p_] += by.p;
    m.pos[q_] += by.q;
    // calls of an element that was left out are shifted twice
    m.nose[p_] += by.p;
    m.nose[q_] += by.q;
    m.centre_p += by.p;
    m.centre_q += by.q;
    m.pos_centre_p += by.p;
    m.pos_centre_q += by.q;
}

// The held block from its first remaining start vector to its first end vector; further end vectors
// stay for the next one.
bool Compensator::finish(Vectors end) {
    if (!release_before()) return false;
    Held& b = block_;
    Verdict verdict = Verdict::Clean;
    if (b.role == Role::Contour) verdict = check_element(b.element, start_, end, options_.check);
    if (verdict == Verdict::Interferes) return fail(Alarm::CompInterference, false, b.at);
    here_ = begins_at(b.move) + displacement_;
    // behind a barrier moves leave later, unlooked at
    const bool looks_back = b.role == Role::Contour && ready_.empty() && !halted_;
    if (looks_back) look_back_.begin_block(b.element);
    if (b.role == Role::Contour) go_corner(b, start_, 1, start_.count, b.element.start, b.tip);
    go_element(b, b.element.end + end.at[0] + b.tip,
               verdict == Verdict::Corrected || b.role != Role::Contour);
    go_corner(b, end, 1, end.of_first, b.element.end, b.tip);
    if (looks_back)
        if (const auto fault = look_back_.end_block())
            return fail(Alarm::CompInterference, false, *fault);
    Vectors rest;
    for (unsigned i = end.of_first - 1; i < end.count; ++i)
        rest.add(end.at[i], end.by_arc[i], end.overshoot[i]);
    start_ = rest;
    displacement_ = here_ - b.element.end;
    held_ = false;
    idle_blocks_ = 0;
    // moves outside the plane: there the nose is at standstill
    trailing_.change_moves([this](Move& m) { shift(m); });
    ready_.append(trailing_);
    pump();
    return true;
}

// The held block ends without a vector, straight, whatever it was.
void Compensator::finish_at_programmed() {
    if (!release_before()) return;
    Held& b = block_;
    here_ = begins_at(b.move) + displacement_;
    if (b.role == Role::Contour) go_corner(b, start_, 1, start_.count, b.element.start, b.tip);
    go_element(b, b.element.end, true);
    start_ = Vectors::one({});
    displacement_ = {};
    held_ = false;
    idle_blocks_ = 0;
    ready_.append(trailing_);
    pump();
}

// A block outside compensation that takes back the vector, round the corner where vectors are left
// for it.
void Compensator::straight_to_programmed(const Move& m, const BlockContext& at) {
    // at the programmed point by chance, and yet moving round the corner
    if (!displaced() && start_.count <= 1) {
        start_ = Vectors::one({});
        deliver(m, at);
        return;
    }
    Held b{m, at, {}, tip_, Role::Contour};
    const Vec end{m.machine[p_], m.machine[q_]};
    here_ = begins_at(m) + displacement_;
    go_corner(b, start_, 1, start_.count, contour_start(m), displacement_ - start_.at[0]);
    b.element.end = end;
    go_element(b, end, true);
    start_ = Vectors::one({});
    displacement_ = {};
}

void Compensator::go_corner(const Held& b, const Vectors& vectors, unsigned from, unsigned to,
                            Vec corner, Vec tip) {
    for (unsigned i = from; i < to; ++i)
        go(b, corner + vectors.at[i] + tip, vectors.by_arc[i], corner + tip, vectors.overshoot[i]);
}

// A connecting move at a corner: with the feed of block b, other axes are at standstill.
void Compensator::go(const Held& b, Vec to, bool by_arc, Vec about, double overshoot) {
    if (length(to - here_) < kNoseStands) return;
    Move m = b.move;
    for (std::size_t i = 0; i < m.pos.size(); ++i) {
        m.pos[i] -= m.machine[i] - m.machine_start[i];  // programmed start of the block
        m.machine[i] = m.machine_start[i];
    }
    const Vec programmed{m.machine_start[p_], m.machine_start[q_]};
    m.machine_start[p_] = here_.p;
    m.machine_start[q_] = here_.q;
    m.machine[p_] = to.p;
    m.machine[q_] = to.q;
    m.pos[p_] += to.p - programmed.p;
    m.pos[q_] += to.q - programmed.q;
    add_nose(m, to - programmed);
    if (m.kind == MoveKind::Thread) {
        m.feed_mode = FeedMode::PerRevolution;
        m.feed = m.lead_path;
        m.lead = m.lead_path = m.lead_change = 0;
    }
    if (m.kind != MoveKind::Rapid && m.kind != MoveKind::Reference) m.kind = MoveKind::Linear;
    m.sweep = 0;
    m.turns = 0;
    m.through.reset();
    if (by_arc && overshoot > 0) {
        auto through = std::make_shared<std::vector<AxisValues>>();
        for (const Vec point : conic_about(here_, to, about, overshoot)) {
            AxisValues axes = m.machine_start;
            axes[p_] = point.p;
            axes[q_] = point.q;
            through->push_back(axes);
        }
        m.through = std::move(through);
    } else if (by_arc) {
        const Vec a = here_ - about, c = to - about;
        m.sweep = std::atan2(cross(a, c), dot(a, c));
        m.kind = m.sweep > 0 ? MoveKind::ArcCcw : MoveKind::ArcCw;
        m.plane_p = static_cast<std::uint8_t>(p_);
        m.plane_q = static_cast<std::uint8_t>(q_);
        m.centre_p = about.p;
        m.centre_q = about.q;
        m.pos_centre_p = about.p + m.pos[p_] - m.machine[p_];
        m.pos_centre_q = about.q + m.pos[q_] - m.machine[q_];
        m.radius = length(a);
        m.radius_end = length(c);
    }
    m.moved = (to.p != here_.p ? 1u << p_ : 0u) | (to.q != here_.q ? 1u << q_ : 0u);
    here_ = to;
    deliver(m, b.at);
}

// An inner corner of two cuts, sharper than the options say, is cut with less feed.
bool Compensator::slow_corner(const Held& a, const Move& next_move, const Element& next) const {
    const CornerFeed& feed = options_.corner_feed;
    if (!(feed.before > 0 || feed.behind > 0) || a.role != Role::Contour ||
        a.move.kind == MoveKind::Rapid || next_move.kind == MoveKind::Rapid)
        return false;
    // turns away from the nose
    if (dot(a.element.normal_at_end(), next.start_dir) <= 0) return false;
    const double between =
        180.0 - std::acos(std::clamp(dot(a.element.end_dir, next.start_dir), -1.0, 1.0)) *
                    (180.0 / std::numbers::pi);
    return between < feed.below_deg;
}

double Compensator::path_curvature(const Element& e, double radius) const {
    const double r = e.arc ? e.nose_path_radius(radius) : 0.0;
    return r > kNoseStands ? (e.sweep > 0 ? 1.0 : -1.0) / r : 0.0;
}

// A cubic with control points P0 P1 P2 P3. Entering, P3 lies on the contour's equidistant with
// tangent d and curvature k:
//   P2 = P3 - h d                    tangential
//   P1 = P3 - 2h d + 1.5 k h^2 n    n left of d: curvature (2/3) cross(d, P1 - P2)/h^2 = k (Curved)
//   P1 = P0 + (2/3)(C - P0)         the parabola P0 C P3 with C on the tangent            (Smooth)
// with h a third of the chord. Leaving is the mirror image (sinumerik_part2 11.2).
void Compensator::touch(Move& m, Vec dir, double curvature, bool entering) const {
    const Vec from{m.machine_start[p_], m.machine_start[q_]}, to{m.machine[p_], m.machine[q_]};
    const double chord = length(to - from);
    if (chord < kNoseStands) return;
    const Vec contour = entering ? to : from, free = entering ? from : to,
              away = entering ? -1.0 * dir : dir;
    const double h = chord / 3.0;
    const Vec near = contour + h * away;
    const Vec far = options_.entry == Entry::Curved
                        ? contour + 2.0 * h * away + 1.5 * curvature * h * h * left_of(dir)
                        : free + (2.0 / 3.0) * (contour + (chord / 2.0) * away - free);
    const Vec points[] = {from, entering ? far : near, entering ? near : far, to};
    // Chords instead of the cubic: one over 1/n of t is off by at most max|P"| / (8 n^2), with
    // P" = 6 (P0 - 2 P1 + P2) at its beginning and likewise at its end, linear in between.
    constexpr double kChordError = 5e-4;  // mm
    constexpr int kFewest = 2, kMost = 400;
    const double bend = 6.0 * std::fmax(length(points[0] - 2.0 * points[1] + points[2]),
                                        length(points[1] - 2.0 * points[2] + points[3]));
    const int pieces = std::clamp(
        static_cast<int>(std::ceil(std::sqrt(bend / (8.0 * kChordError)))), kFewest, kMost);
    auto through = std::make_shared<std::vector<AxisValues>>();
    for (int k = 1; k < pieces; ++k) {
        const double t = static_cast<double>(k) / pieces, u = 1.0 - t;
        AxisValues point{};
        for (std::size_t i = 0; i < point.size(); ++i)
            point[i] = m.machine_start[i] + t * (m.machine[i] - m.machine_start[i]);
        const Vec on = u * u * u * points[0] + 3.0 * t * u * u * points[1] +
                       3.0 * t * t * u * points[2] + t * t * t * points[3];
        point[p_] = on.p;
        point[q_] = on.q;
        through->push_back(point);
    }
    m.through = std::move(through);
}

void Compensator::go_element(const Held& b, Vec to, bool as_line) {
    Move m = b.move;
    m.slow_head = b.slow_begin ? options_.corner_feed.behind : 0.0;
    m.slow_tail = b.slow_end ? options_.corner_feed.before : 0.0;
    m.slow_share = options_.corner_feed.share;
    const Vec programmed{m.machine[p_], m.machine[q_]};
    m.machine_start[p_] = here_.p;
    m.machine_start[q_] = here_.q;
    m.machine[p_] = to.p;
    m.machine[q_] = to.q;
    m.pos[p_] += to.p - programmed.p;
    m.pos[q_] += to.q - programmed.q;
    add_nose(m, to - programmed);
    m.moved &= ~(1u << p_ | 1u << q_);
    bool curved = b.element.arc && !as_line;
    if (curved) {
        const Vec centre = b.element.centre + b.tip, a = here_ - centre, c = to - centre;
        m.centre_p = centre.p;
        m.centre_q = centre.q;
        m.pos_centre_p += b.tip.p;
        m.pos_centre_q += b.tip.q;
        m.radius = length(a);
        m.radius_end = length(c);
        // the nose just fits: it turns on the spot
        if (m.radius < kNoseStands || m.radius_end < kNoseStands)
            m.sweep = 0;
        else
            m.sweep += std::remainder(std::atan2(cross(a, c), dot(a, c)) - m.sweep, kTurn);
        curved = std::fabs(m.sweep) * m.radius >= kNoseStands;
        if (curved) {
            m.moved |= 1u << p_ | 1u << q_;
            if (options_.inner_arc_feed_from >= 0 && b.element.centre_on_nose_side() &&
                m.feed_mode != FeedMode::InverseTime)
                m.feed *=
                    std::fmax(options_.inner_arc_feed_from, m.radius / b.element.start_radius);
            const bool at_contour =
                options_.arc_feed == ArcFeed::Contour ||
                (options_.arc_feed == ArcFeed::Inner && m.radius < b.element.start_radius);
            if (at_contour && b.element.start_radius > kNoseStands)
                m.feed_scale *= m.radius / b.element.start_radius;
        }
    }
    if (b.element.arc && !curved) {
        m.kind = MoveKind::Linear;
        m.sweep = 0;
        m.turns = 0;
    }
    if (touches_ && !b.element.arc) {
        if (b.role == Role::Begin)
            touch(m, touches_->start_dir, path_curvature(*touches_, touches_->start_radius), true);
        else
            touch(m, touches_->end_dir, path_curvature(*touches_, touches_->end_radius), false);
    }
    if (!curved && length(to - here_) >= kNoseStands)
        m.moved |= (to.p != here_.p ? 1u << p_ : 0u) | (to.q != here_.q ? 1u << q_ : 0u);
    here_ = to;
    if (m.moved) deliver(m, b.at);
}

}  // namespace polyturn::channels::compensation
