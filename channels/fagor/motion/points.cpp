#include "channels/fagor/motion/points.hpp"

#include <cmath>

#include "channels/angles.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr double kSamePoint = 1e-7;  // mm

double modulo_turn(double degrees) { return std::fmod(degrees, 360.0); }

// Cosine and sine that are exact at whole quarter turns.
void direction_of(double degrees, double& c, double& s) {
    const double quarter = degrees / 90.0, whole = std::nearbyint(quarter);
    if (std::fabs(quarter - whole) > 1e-12) {
        c = std::cos(degrees * kDegree);
        s = std::sin(degrees * kDegree);
        return;
    }
    static constexpr double kCos[] = {1, 0, -1, 0}, kSin[] = {0, 1, 0, -1};
    const auto i = static_cast<std::size_t>((static_cast<long>(whole) % 4 + 4) % 4);
    c = kCos[i];
    s = kSin[i];
}

// Q is the angle of this segment, one coordinate of the plane is given, the other one follows.
bool angle_point(Execution& x, AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    double c = 1, s = 0;
    direction_of(modulo_turn(x.words.number('Q')), c, s);
    const double p0 = x.core.path.programmed[p], q0 = x.core.path.programmed[q];
    const bool gives_p = x.words.axis[p] != nullptr;
    const double way = gives_p ? target[p] - p0 : target[q] - q0, share = gives_p ? c : s;
    // The direction must lead to the coordinate, not away from it and not past it.
    if (std::fabs(share) >= 1e-9 && std::fabs(way) < kSamePoint) return true;
    if (std::fabs(share) < 1e-9 || way / share < 0)
        return x.fail(Alarm::FagorAngle, 'Q', {}, x.words.number('Q'));
    if (gives_p)
        target[q] = q0 + way * s / c;
    else
        target[p] = p0 + way * c / s;
    return true;
}

}  // namespace

bool read_point(Execution& x, AxisValues& target, AxisSet* named) {
    const MachineView& view = x.core.view();
    target = x.core.path.programmed;
    AxisSet set = 0;
    unsigned p = 0, q = 0;
    int pi = -1, qi = -1;
    x.core.plane_axes(pi, qi);
    if (pi >= 0 && qi >= 0) {
        p = static_cast<unsigned>(pi);
        q = static_cast<unsigned>(qi);
    }
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const Word* word = x.words.axis[i];
        if (!word) continue;
        const ChannelAxis& axis = view.axes[i];
        set |= 1u << i;
        if (x.words.in_machine) {  // from machine zero, in the unit of the machine
            const double scale =
                axis.rotary ? 1.0 : (x.settings.inch ? 25.4 : 1.0) * (axis.diameter ? 0.5 : 1.0);
            AxisValues point = x.core.framed(target);
            point[i] = word->value * scale - x.core.path.zero[i] - x.core.path.wanted[i];
            target[i] = x.core.unframed(point)[i];
            continue;
        }
        const double value = length(x, word->value, static_cast<int>(i));
        if (axis.rollover)
            target[i] = x.core.rollover_target(i, value, x.modal.absolute);
        else
            target[i] = x.modal.absolute ? value : x.core.path.programmed[i] + value;
        if (axis.rotary && get_axis_type(x, i) == 4 &&
            std::fabs(value - std::nearbyint(value)) > 1e-6)
            return x.fail_word(*word, Alarm::FagorValueRange, axis.name, word->value);
    }
    if (named) *named = set;
    const bool polar = x.words.has('Q') || (x.words.has('R') && x.modal.motion < 2);
    if (!polar) return true;
    const unsigned in_plane = ((set >> p) & 1u) + ((set >> q) & 1u);
    if (in_plane == 2)
        return x.fail_word(x.words.has('Q') ? *x.words.word('Q') : *x.words.word('R'),
                           Alarm::AddressIllegal, x.words.has('Q') ? "Q" : "R");
    if (in_plane == 1) {
        if (x.words.has('R') || !x.words.has('Q'))
            return x.fail_word(*x.words.word('R'), Alarm::AddressIllegal, "R");
        return angle_point(x, target);
    }
    if (!plane_places(x, p, q)) return false;
    return polar_point(x, target);
}

// R and Q about the polar origin; what is not programmed keeps its value.
bool polar_point(Execution& x, AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    double op = 0, oq = 0;
    polar_origin(x, op, oq);
    const double dp = x.core.path.programmed[p] - op, dq = x.core.path.programmed[q] - oq;
    double radius = std::hypot(dp, dq), angle = std::atan2(dq, dp) / kDegree;
    if (x.words.has('R')) radius = x.modal.absolute ? distance(x, 'R') : radius + distance(x, 'R');
    if (x.words.has('Q'))
        angle = x.modal.absolute ? modulo_turn(x.words.number('Q'))
                                 : angle + modulo_turn(x.words.number('Q'));
    if (radius < 0) return x.fail(Alarm::FagorPolarRadius, 'R', {}, radius);
    double c = 1, s = 0;
    direction_of(angle, c, s);
    target[p] = op + radius * c;
    target[q] = oq + radius * s;
    return true;
}

// The direction in which the path left the last block, before mirror and scale.
bool end_direction(const Execution& x, double& p, double& q) {
    p = x.modal.direction_p;
    q = x.modal.direction_q;
    return p != 0.0 || q != 0.0;
}

void note_direction(Execution& x, double p, double q) {
    const double length = std::hypot(p, q);
    if (length < 1e-9) return;
    x.modal.direction_p = p / length;
    x.modal.direction_q = q / length;
}

}  // namespace polyturn::channels::fagor
