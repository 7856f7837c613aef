#include "channels/fagor/frames/plane.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {

bool g_plane(Execution& x, const GCode& row) {
    if (x.modal.comp != 40 && row.number != x.modal.plane)
        return x.fail(Alarm::CompPlaneChanged, 'G');
    if (row.number == x.modal.plane) return true;  // no change: the polar origin stays (3.6.2)
    x.modal.plane = row.number;
    x.core.path.plane = static_cast<Plane>(row.number - 17);
    x.core.path.plane_p = x.core.path.plane_q = -1;
    reset_polar_origin(x);
    return true;
}

// G16: the axes as they are named, first the abscissa; written as X.. words without numbers.
bool g_plane_of_axes(Execution& x, const GCode&) {
    if (x.modal.comp != 40) return x.fail(Alarm::CompPlaneChanged, 'G');
    int first = -1, second = -1;
    for (unsigned k = 0; k < x.line.block.count; ++k) {
        const Word& word = x.line.block.words[k];
        if (word.letter == 'G') continue;
        const int place = x.places.of(word.letter);
        if (place < 0 || word.given || second >= 0)
            return x.fail_word(word, Alarm::AddressIllegal, std::string(1, word.letter));
        (first < 0 ? first : second) = place;
    }
    if (second < 0) return x.fail(Alarm::FagorMotionWord, 'G', "two axes", 16);
    x.modal.plane = 16;
    x.core.path.plane = Plane::ZX;
    x.core.path.plane_p = static_cast<std::int8_t>(first);
    x.core.path.plane_q = static_cast<std::int8_t>(second);
    reset_polar_origin(x);
    return true;
}

// G93: I is the abscissa, J the ordinate of the plane; alone the present point.
bool g_polar_origin(Execution& x, const GCode&) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    double op = x.core.path.programmed[p], oq = x.core.path.programmed[q];
    if (x.words.has('I') || x.words.has('J')) {
        op = length(x, x.words.number('I'), static_cast<int>(p));
        oq = length(x, x.words.number('J'), static_cast<int>(q));
    }
    set_polar_origin(x, op, oq);
    return true;
}

bool plane_places(Execution& x, unsigned& p, unsigned& q) {
    int pi = -1, qi = -1;
    x.core.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return x.fail(Alarm::PlaneAxisMissing, 'G');
    p = static_cast<unsigned>(pi);
    q = static_cast<unsigned>(qi);
    return true;
}

// The polar origin does not move in the machine; the part's zero may move under it (4.5).
void polar_origin(const Execution& x, double& p, double& q) {
    int pi = -1, qi = -1;
    x.core.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return;
    const auto i = static_cast<std::size_t>(pi), k = static_cast<std::size_t>(qi);
    AxisValues point = x.core.framed(x.core.path.programmed);
    point[i] = x.modal.polar_p - x.core.path.zero[i];
    point[k] = x.modal.polar_q - x.core.path.zero[k];
    const AxisValues part = x.core.unframed(point);
    p = part[i];
    q = part[k];
}

void set_polar_origin(Execution& x, double p, double q) {
    int pi = -1, qi = -1;
    x.core.plane_axes(pi, qi);
    if (pi < 0 || qi < 0) return;
    const auto i = static_cast<std::size_t>(pi), k = static_cast<std::size_t>(qi);
    AxisValues part = x.core.path.programmed;
    part[i] = p;
    part[k] = q;
    const AxisValues point = x.core.framed(part);
    x.modal.polar_p = point[i] + x.core.path.zero[i];
    x.modal.polar_q = point[k] + x.core.path.zero[k];
}

void reset_polar_origin(Execution& x) { set_polar_origin(x, 0.0, 0.0); }

}  // namespace polyturn::channels::fagor
