// Factors of single axes behind compensation: Core's positions have them (they are part of the
// frame), what it delivers has not, FactorSink puts them on again.
#include "channels/pipeline/factor_sink.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels {

void Core::set_factors(const AxisValues& factor, const Frame& frame) {
    const AxisValues was = path.factor;
    const bool were = path.factored;
    path.factor = factor;
    path.factored = false;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        path.factored = path.factored || factor[i] != 1.0;
    if (path.factored) await_factors();
    if (factors_ && reads_ahead() && (were || path.factored))
        change_factors(were ? was : AxisValues{}, were);
    show_factors();
    set_frame(frame);
}

void Core::await_factors() {
    if (factors_) return;
    factors_ = std::make_unique<FactorSink>(*view_, path);
    refresh_routes();
}

// Moves are held: they keep the factors that they were programmed with.
void Core::change_factors(AxisValues was, bool were) {
    AxisValues bias = factors_->bias();
    if (!were) was.fill(1.0);
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const double stands =
            path.machine[i] - path.turns_deg[i] - path.zero[i] - path.shift[i] - path.vector[i];
        bias[i] += stands / was[i] - stands / path.factor[i];
    }
    factors_->change(at.serial, was, path.factor, bias);
}

// A rotary axis with a factor counts on and on, as a linear one does (the surface of a cylinder).
void Core::show_factors() {
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        ChannelAxis& axis = view_->axes[i];
        const bool counts_on = path.factored && path.factor[i] != 1.0;
        if (counts_on && axis.rollover) {
            axis.rollover = false;
            axis.counts_on = true;
        } else if (!counts_on && axis.counts_on) {
            axis.rollover = true;
            axis.counts_on = false;
        }
    }
}

// What the factors are not in yet, of a point in the system around the frame.
AxisValues Core::before_factors(AxisValues point) const {
    if (!path.factored) return point;
    for (unsigned i = 0; i < view_->axis_count; ++i) point[i] /= path.factor[i];
    return point;
}

double Core::behind_factors(unsigned i, double machine, double offset) const {
    return path.factored ? offset + (machine - offset) * path.factor[i] : machine;
}

Frame Core::frame_before_factors() const {
    Frame frame = path.frame;
    if (!path.factored) return frame;
    for (std::size_t k = 0; k < 3; ++k) {
        if (geo_[k] < 0) continue;
        const double f = path.factor[static_cast<std::size_t>(geo_[k])];
        for (double& share : frame.linear[k]) share /= f;
        frame.shift[k] /= f;
    }
    return frame;
}

// move_ as it is before the factors; where it really ends stays in real_end_.
void Core::take_factors_off() {
    if (factors_ && !reads_ahead()) factors_->start(path.machine);
    if (!(path.factored || (factors_ && factors_->changed())) || factors_off_) return;
    factors_off_ = true;
    real_end_ = move_.machine;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const double f = path.factored ? path.factor[i] : 1.0;
        if (f == 1.0) continue;
        const double start = move_.machine_start[i] - path.turns_deg[i] - path.zero[i] -
                             path.shift[i] - path.vector[i];
        move_.machine_start[i] -= start - start / f;
        move_.machine[i] -= move_.pos[i] - move_.pos[i] / f;
        move_.pos[i] /= f;
    }
}

// What holds moves is given no jump where factors have changed.
void Core::add_bias() {
    if (!factors_ || !factors_->changed()) return;
    const AxisValues bias = factors_->bias();
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        move_.machine_start[i] += bias[i];
        move_.machine[i] += bias[i];
    }
    if (is_arc(move_)) {
        move_.centre_p += bias[move_.plane_p];
        move_.centre_q += bias[move_.plane_q];
    }
}

}  // namespace polyturn::channels
