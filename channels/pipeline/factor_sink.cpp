#include "channels/pipeline/factor_sink.hpp"

#include <cmath>

#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

constexpr double kSagitta = 0.001;  // mm between a chord and its arc

// Travel of a move as the feed counts it: all axes, degrees as millimetres.
double way_of(const Move& m, const AxisValues& start, const AxisValues& end, double radius,
              unsigned count) {
    double square = 0.0;
    for (unsigned i = 0; i < count; ++i) {
        if (is_arc(m) && (i == m.plane_p || i == m.plane_q)) continue;
        square += (end[i] - start[i]) * (end[i] - start[i]);
    }
    if (is_arc(m)) square += radius * radius * m.sweep * m.sweep;
    return std::sqrt(square);
}

}  // namespace

void FactorSink::change(std::uint64_t serial, const AxisValues& was, const AxisValues& factor,
                        const AxisValues& bias) {
    if (stages_.empty()) stages_.push_back({0, was, {}});
    stages_.push_back({serial, factor, bias});
}

void FactorSink::move(const Move& m, const BlockContext& at) {
    if (stages_.empty()) {
        if (!path_->factored) {
            axes_ = m.machine;
            return next_->move(m, at);
        }
        factor_ = &path_->factor;
        return multiply(m, at);
    }
    const Stage* stage = &stages_.front();
    for (const Stage& other : stages_)
        if (other.serial <= at.serial) stage = &other;
    factor_ = &stage->factor;
    unbiased_ = m;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        unbiased_.machine[i] -= stage->bias[i];
        unbiased_.machine_start[i] -= stage->bias[i];
    }
    if (is_arc(m)) {
        unbiased_.centre_p -= stage->bias[m.plane_p];
        unbiased_.centre_q -= stage->bias[m.plane_q];
    }
    multiply(unbiased_, at);
}

void FactorSink::multiply(const Move& m, const BlockContext& at) {
    const AxisValues& factor = *factor_;
    if (is_arc(m) && factor[m.plane_p] != factor[m.plane_q]) return chords(m, at);
    out_ = m;
    if (is_arc(m)) {
        const double f = factor[m.plane_p];
        out_.centre_p += (f - 1) * m.pos_centre_p;
        out_.centre_q += (f - 1) * m.pos_centre_q;
        out_.pos_centre_p *= f;
        out_.pos_centre_q *= f;
        out_.radius *= f;
        out_.radius_end *= f;
    }
    deliver(m, way_of(m, m.machine_start, m.machine, m.radius, view_->axis_count), at);
}

// Ends, feed and lead of out_, whose other members are set; `way`: of the motion before the
// factors.
void FactorSink::deliver(const Move& m, double way, const BlockContext& at) {
    const unsigned count = view_->axis_count;
    unsigned along = 0;
    double longest = -1.0;
    for (unsigned i = 0; i < count; ++i) {
        const double f = (*factor_)[i], part = std::fabs(out_.machine[i] - out_.machine_start[i]);
        if (!view_->axes[i].rotary && part > longest) {
            longest = part;
            along = i;
        }
        if (f == 1.0 && stages_.empty()) continue;
        out_.machine[i] += (f - 1) * out_.pos[i];
        out_.pos[i] *= f;
        out_.nose[i] = f * m.nose[i];
        out_.machine_start[i] = axes_[i];
    }
    const double share =
        way > 0 ? way_of(out_, out_.machine_start, out_.machine, out_.radius, count) / way : 1.0;
    if (m.feed_mode == FeedMode::PerMinute || m.feed_mode == FeedMode::PerRevolution)
        out_.feed_scale *= share;
    if (m.kind == MoveKind::Thread) {
        out_.lead *= (*factor_)[along];
        out_.lead_change *= (*factor_)[along];
        out_.lead_path *= share;
    }
    axes_ = out_.machine;
    next_->move(out_, at);
}

void FactorSink::chords(const Move& m, const BlockContext& at) {
    const unsigned count = view_->axis_count;
    const double most = std::fmax((*factor_)[m.plane_p], (*factor_)[m.plane_q]);
    const double radius = std::fmax(m.radius * most, 2 * kSagitta);
    const int steps =
        1 + static_cast<int>(std::fabs(m.sweep) / (2 * std::acos(1 - kSagitta / radius)));
    const double first = std::atan2(m.machine_start[m.plane_q] - m.centre_q,
                                    m.machine_start[m.plane_p] - m.centre_p);
    AxisValues from = m.machine_start;
    for (int k = 1; k <= steps; ++k) {
        const double part = static_cast<double>(k) / steps, angle = first + m.sweep * part,
                     r = m.radius + part * (m.radius_end - m.radius);
        out_ = m;
        out_.kind = MoveKind::Linear;
        for (unsigned i = 0; i < count; ++i)
            out_.machine[i] = m.machine_start[i] + part * (m.machine[i] - m.machine_start[i]);
        if (k < steps) {
            out_.machine[m.plane_p] = m.centre_p + r * std::cos(angle);
            out_.machine[m.plane_q] = m.centre_q + r * std::sin(angle);
        }
        for (unsigned i = 0; i < count; ++i)
            out_.pos[i] = m.pos[i] + (out_.machine[i] - m.machine[i]);
        out_.machine_start = from;
        from = out_.machine;
        if (k < steps) out_.exact_stop = out_.in_position = false;
        if (m.feed_mode == FeedMode::InverseTime) out_.feed = m.feed * steps;
        out_.sweep = 0.0;
        const double way = way_of(out_, out_.machine_start, out_.machine, 0.0, count);
        deliver(out_, way, at);
    }
}

}  // namespace polyturn::channels
