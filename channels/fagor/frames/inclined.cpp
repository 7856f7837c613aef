#include "channels/fagor/frames/inclined.hpp"

#include <numbers>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"

namespace polyturn::channels::fagor {

bool g_inclined(Execution& x, const GCode&) {
    std::int64_t state = 0;
    if (x.words.has('S') && !whole(x, *x.words.word('S'), state)) return false;
    if (state > 2) return x.fail(Alarm::FagorValueRange, 'S', "S", static_cast<double>(state));
    if (state == 0) {
        set_inclined(x, 0);
        return true;
    }
    const auto place = [&x](int number) {
        return number >= 1 && number <= 9
                   ? x.places.of(kAxisLetters[static_cast<std::size_t>(number - 1)])
                   : -1;
    };
    x.inclined.axis = place(x.settings.inclined_axis);
    x.inclined.orthogonal = place(x.settings.orthogonal_axis);
    if (x.inclined.axis < 0 || x.inclined.orthogonal < 0 ||
        x.inclined.axis == x.inclined.orthogonal || x.settings.inclined_deg == 0.0)
        return x.fail(Alarm::FagorInclined, 'G', "FG.ANGAXNA, FG.ORTAXNA, FG.ANGANTR");
    if (x.core.reads_ahead()) return x.fail(Alarm::FagorIncompatible, 'G', "G41 G46");
    set_inclined(x, static_cast<int>(state));
    return true;
}

// The real axes stand still when the transformation changes: the cartesian point becomes another
// number.
void set_inclined(Execution& x, int state) {
    if ((state != 0) != x.core.transformed()) {
        x.core.transform_off();
        if (state != 0) {
            Transformation wanted;
            wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Inclined);
            wanted.kinematics.axis[0] = static_cast<std::uint8_t>(x.inclined.axis);
            wanted.kinematics.axis[1] = static_cast<std::uint8_t>(x.inclined.orthogonal);
            wanted.kinematics.centre[0] = x.settings.inclined_origin;
            wanted.kinematics.value[0] = x.settings.inclined_deg * std::numbers::pi / 180.0;
            (void)x.core.transform(wanted);  // g_inclined has seen to it that it can
        }
    }
    x.modal.inclined = state;
}

// While frozen only the inclined axis moves: the point slides along it (13.2).
void slide_along_inclined(const Execution& x, AxisValues& target, AxisSet named) {
    if (x.modal.inclined != 2 || !(named >> x.inclined.axis & 1u) ||
        (named >> x.inclined.orthogonal & 1u))
        return;
    const auto inclined = static_cast<std::size_t>(x.inclined.axis),
               orthogonal = static_cast<std::size_t>(x.inclined.orthogonal);
    AxisValues from = x.core.framed(x.core.path.programmed), to = x.core.framed(target);
    to[orthogonal] =
        from[orthogonal] +
        (to[inclined] - from[inclined]) * std::tan(x.core.path.transformation.kinematics.value[0]);
    target = x.core.unframed(to);
}

}  // namespace polyturn::channels::fagor
