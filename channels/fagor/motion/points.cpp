// From the words of a block to the point it means: cartesian, polar, angle and one coordinate
// (fagor_8037t part 1, 3.6).
#include <cmath>

#include "channels/angles.hpp"
#include "channels/fagor/interpreter.hpp"

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

}  // namespace

bool Interpreter::plane_places(unsigned& p, unsigned& q) {
    int pi = -1, qi = -1;
    core_.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    p = static_cast<unsigned>(pi);
    q = static_cast<unsigned>(qi);
    return true;
}

// The polar origin does not move in the machine; the part's zero may move under it (4.5).
void Interpreter::polar_origin(double& p, double& q) const {
    int pi = -1, qi = -1;
    core_.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return;
    const auto i = static_cast<std::size_t>(pi), k = static_cast<std::size_t>(qi);
    AxisValues point = core_.framed(core_.path.programmed);
    point[i] = modal_.polar_p - core_.path.zero[i];
    point[k] = modal_.polar_q - core_.path.zero[k];
    const AxisValues part = core_.unframed(point);
    p = part[i];
    q = part[k];
}

void Interpreter::set_polar_origin(double p, double q) {
    int pi = -1, qi = -1;
    core_.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return;
    const auto i = static_cast<std::size_t>(pi), k = static_cast<std::size_t>(qi);
    AxisValues part = core_.path.programmed;
    part[i] = p;
    part[k] = q;
    const AxisValues point = core_.framed(part);
    modal_.polar_p = point[i] + core_.path.zero[i];
    modal_.polar_q = point[k] + core_.path.zero[k];
}

void Interpreter::reset_polar_origin() { set_polar_origin(0.0, 0.0); }

bool Interpreter::read_point(AxisValues& target, AxisSet* named) {
    const MachineView& view = core_.view();
    target = core_.path.programmed;
    AxisSet set = 0;
    unsigned p = 0, q = 0;
    int pi = -1, qi = -1;
    core_.plane_axes(pi, qi);
    if (pi >= 0 && qi >= 0) {
        p = static_cast<unsigned>(pi);
        q = static_cast<unsigned>(qi);
    }
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const Word* word = axis_words_[i];
        if (!word) continue;
        const ChannelAxis& axis = view.axes[i];
        set |= 1u << i;
        if (in_machine_) {  // from machine zero, in the unit of the machine
            const double scale =
                axis.rotary ? 1.0 : (settings_.inch ? 25.4 : 1.0) * (axis.diameter ? 0.5 : 1.0);
            AxisValues point = core_.framed(target);
            point[i] = word->value * scale - core_.path.zero[i] - core_.path.wanted[i];
            target[i] = core_.unframed(point)[i];
            continue;
        }
        const double value = length(word->value, static_cast<int>(i));
        if (axis.rollover)
            target[i] = core_.rollover_target(i, value, modal_.absolute);
        else
            target[i] = modal_.absolute ? value : core_.path.programmed[i] + value;
        if (axis.rotary && get_axis_type(i) == 4 && std::fabs(value - std::nearbyint(value)) > 1e-6)
            return fail_word(*word, Alarm::FagorValueRange, axis.name, word->value);
    }
    if (named) *named = set;
    const bool polar = has('Q') || (has('R') && modal_.motion < 2);
    if (!polar) return true;
    const unsigned in_plane = ((set >> p) & 1u) + ((set >> q) & 1u);
    if (in_plane == 2)
        return fail_word(has('Q') ? *word('Q') : *word('R'), Alarm::AddressIllegal,
                         has('Q') ? "Q" : "R");
    if (in_plane == 1) {
        if (has('R') || !has('Q')) return fail_word(*word('R'), Alarm::AddressIllegal, "R");
        return angle_point(target);
    }
    if (!plane_places(p, q)) return false;
    return polar_point(target);
}

// R and Q about the polar origin; what is not programmed keeps its value.
bool Interpreter::polar_point(AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    double op = 0, oq = 0;
    polar_origin(op, oq);
    const double dp = core_.path.programmed[p] - op, dq = core_.path.programmed[q] - oq;
    double radius = std::hypot(dp, dq), angle = std::atan2(dq, dp) / kDegree;
    if (has('R')) radius = modal_.absolute ? distance('R') : radius + distance('R');
    if (has('Q'))
        angle = modal_.absolute ? modulo_turn(number('Q')) : angle + modulo_turn(number('Q'));
    if (radius < 0) return core_.fail(Alarm::FagorPolarRadius, 'R', {}, radius);
    double c = 1, s = 0;
    direction_of(angle, c, s);
    target[p] = op + radius * c;
    target[q] = oq + radius * s;
    return true;
}

// Q is the angle of this segment, one coordinate of the plane is given, the other one follows.
bool Interpreter::angle_point(AxisValues& target) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    double c = 1, s = 0;
    direction_of(modulo_turn(number('Q')), c, s);
    const double p0 = core_.path.programmed[p], q0 = core_.path.programmed[q];
    const bool gives_p = axis_words_[p] != nullptr;
    const double way = gives_p ? target[p] - p0 : target[q] - q0, share = gives_p ? c : s;
    // The direction must lead to the coordinate, not away from it and not past it.
    if (std::fabs(share) >= 1e-9 && std::fabs(way) < kSamePoint) return true;
    if (std::fabs(share) < 1e-9 || way / share < 0)
        return core_.fail(Alarm::FagorAngle, 'Q', {}, number('Q'));
    if (gives_p)
        target[q] = q0 + way * s / c;
    else
        target[p] = p0 + way * c / s;
    return true;
}

// Centre of an arc from I, J, K: relative to the start (true distances), or from part zero with
// G06. Letters belong to axes.
char Interpreter::centre_letter(unsigned place) const {
    const std::string& name = core_.view().axes[place].name;
    switch (name[0]) {
        case 'X':
        case 'U':
        case 'A':
            return 'I';
        case 'Y':
        case 'V':
        case 'B':
            return 'J';
        default:
            return 'K';
    }
}

bool Interpreter::arc_centre(const AxisValues&, bool absolute, double& cp, double& cq) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    const char lp = centre_letter(p), lq = centre_letter(q);
    const Word* wp = word(lp);
    const Word* wq = word(lq);
    // the plane X U: the first word belongs to the axis that is first in the order of axes
    if (lp == lq) {
        const bool p_first =
            axis_number(core_.view().axes[p].name[0]) < axis_number(core_.view().axes[q].name[0]);
        wp = p_first ? wp : centre_second_;
        wq = p_first ? centre_second_ : word(lq);
    }
    for (const char letter : {'I', 'J', 'K'})
        if (has(letter) && letter != lp && letter != lq)
            return fail_word(*word(letter), Alarm::FagorNotInPlane, std::string(1, letter));
    const AxisValues& now = core_.path.programmed;
    if (absolute) {
        cp = wp ? length(wp->value, static_cast<int>(p)) : 0.0;
        cq = wq ? length(wq->value, static_cast<int>(q)) : 0.0;
    } else {
        cp = now[p] + (wp ? wp->value * unit() : 0.0);
        cq = now[q] + (wq ? wq->value * unit() : 0.0);
    }
    return true;
}

int Interpreter::get_axis_type(unsigned place) const {
    const MachineView& view = core_.view();
    return static_cast<int>(
        params::get(view.table(), params::fg_axistype, view.axes[place].machine_axis + 1u));
}

}  // namespace polyturn::channels::fagor
