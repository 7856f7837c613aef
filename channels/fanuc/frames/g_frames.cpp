// Mirror, scale and rotation between what is programmed and the work zero: G50 G51, G50.1 G51.1,
// G68 G69, G68.1, G15 G16.
//
//   point outside = rotation( scaling( mirror( programmed ) ) )     in this order whatever order they were switched on in
#include "channels/fanuc/frames/g_frames.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/tool_words.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};

// About an axis through `centre`, right-handed (Rodrigues).
Frame turn_about(const Point3& direction, const Point3& centre, double degrees) {
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    const double x = direction[0] / length, y = direction[1] / length, z = direction[2] / length;
    const double a = degrees * std::numbers::pi / 180.0;
    const double quarter = std::fmod(degrees, 90.0);
    const double c = quarter == 0 ? std::nearbyint(std::cos(a)) : std::cos(a),
                 s = quarter == 0 ? std::nearbyint(std::sin(a)) : std::sin(a);
    Frame frame;
    frame.linear = {{{c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s},
                     {y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s},
                     {z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)}}};
    const Point3 turned = frame.direction(centre);
    for (std::size_t k = 0; k < 3; ++k) frame.shift[k] = centre[k] - turned[k];
    return frame;
}

// X, Y, Z words as a point, mm and radii; the present point where nothing is programmed.
Point3 frame_point(Execution& x, bool present, std::array<bool, 3>* named) {
    Point3 point{};
    const MachineView& view = x.core.view();
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place < 0) continue;
        if (present) point[k] = x.core.path.programmed[static_cast<std::size_t>(place)];
        for (unsigned w = 0; w < x.words.axis_count; ++w) {
            const Word& word = x.block.words[x.words.axes[w]];
            if (axis_of(x, word).place != place) continue;
            point[k] = length_of(x, word, place) *
                       (view.axes[static_cast<std::size_t>(place)].diameter ? 0.5 : 1.0);
            if (named) (*named)[k] = true;
        }
    }
    return point;
}

}  // namespace

void apply_frames(Execution& x) {
    x.core.set_frame(x.modal.frames.rotation * x.modal.frames.scaling * x.modal.frames.mirror);
}

bool g_scale(Execution& x, const GCode& row) {
    x.modal.frames.scaling = Frame{};
    if (row.tenths == 510) {
        Point3 factors{1, 1, 1};
        const auto factor = [&x](char letter) {
            const Word& word = x.block.word(letter);
            return word.has_point || x.settings.policy.words.whole_factors ? word.value
                                                                           : word.value * 0.001;
        };
        if (x.block.has('P')) factors = {factor('P'), factor('P'), factor('P')};
        static constexpr char kEach[] = {'I', 'J', 'K'};
        for (std::size_t k = 0; k < 3; ++k)
            if (x.block.has(kEach[k])) factors[k] = factor(kEach[k]);
        if (!x.block.has('P') && !x.block.has('I') && !x.block.has('J') && !x.block.has('K'))
            return x.core.fail(Alarm::CycleWordMissing, 'G', "P");
        for (std::size_t k = 0; k < 3; ++k)
            if (factors[k] == 0)
                return x.core.fail(Alarm::CycleValueIllegal, x.block.has(kEach[k]) ? kEach[k] : 'P',
                                   "P", 0);
        const Point3 centre = frame_point(x, true, nullptr);
        x.words.used = true;
        x.modal.frames.scaling = Frame::scaling(factors);
        for (std::size_t k = 0; k < 3; ++k)
            x.modal.frames.scaling.shift[k] = centre[k] * (1 - factors[k]);
    }
    apply_frames(x);
    return true;
}

// G51.1: the named axes are mirrored about the named points; G50.1: no more, without a name none at
// all.
bool g_mirror(Execution& x, const GCode& row) {
    std::array<bool, 3> named{};
    const Point3 about = frame_point(x, false, &named);
    const bool on = row.tenths == 511;
    if (on && !named[0] && !named[1] && !named[2])
        return x.core.fail(Alarm::CoordinateAxisNone, 'G', "G51.1");
    const bool all = !on && !named[0] && !named[1] && !named[2];
    for (std::size_t k = 0; k < 3; ++k) {
        if (!named[k] && !all) continue;
        x.modal.frames.mirror.linear[k][k] = on ? -1.0 : 1.0;
        x.modal.frames.mirror.shift[k] = on ? 2 * about[k] : 0.0;
    }
    x.words.used = true;
    apply_frames(x);
    return true;
}

// G68 of a fanuc lathe: the turret on the other side works, X counts the other way. With PT_BALANCE
// it is the balance cut with another channel instead (BalanceSink).
bool g_turret_mirror(Execution& x, const GCode&) {
    if (params::get(x.core.view().table(), params::pt_balance, x.core.view().channel) != 0) {
        if (x.core.reads_ahead()) return x.core.fail(Alarm::TransformPlace, 'G', "G41 G42");
        if (x.machine.polygon_on) return x.core.fail(Alarm::PolygonBalance, 'G');
        x.machine.balance_on = true;
        x.core.signal("BALANCE", 1);
        return x.run.wants_barrier = true;
    }
    x.modal.frames.rotation = Frame::mirror(true, false, false);
    apply_frames(x);
    return true;
}

bool g_rotation(Execution& x, const GCode& row) {
    if (row.tenths == 690 &&
        params::get(x.core.view().table(), params::pt_balance, x.core.view().channel) != 0) {
        x.machine.balance_on = false;
        x.core.signal("BALANCE", 0);
        x.run.wants_barrier = true;
    }
    x.modal.frames.rotation = Frame{};
    if (row.tenths == 680 || row.tenths == 681) {
        x.words.used = true;
        if (!x.block.has('R')) return x.core.fail(Alarm::CycleWordMissing, 'G', "R");
        const Word& word = x.block.word('R');
        const double degrees = word.has_point || word.from_expression ||
                                       x.settings.policy.words.whole_rotation ||
                                       x.settings.point_means_nothing
                                   ? word.value
                                   : word.value * 0.001;
        const bool spatial = x.block.has('I') || x.block.has('J') || x.block.has('K');
        Point3 direction{};
        if (spatial) {
            if (const char first = x.block.has('I')   ? 'I'
                                   : x.block.has('J') ? 'J'
                                                      : 'K';
                row.tenths == 680)
                return x.core.fail(Alarm::AddressIllegal, first, std::string(1, first));
            direction = {x.block.has('I') ? x.block.value('I') : 0,
                         x.block.has('J') ? x.block.value('J') : 0,
                         x.block.has('K') ? x.block.value('K') : 0};
            if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
                return x.core.fail(Alarm::CycleValueIllegal, 'I', "I J K", 0);
        } else {  // from the plane's first to its second axis; Z X: about +Y
            direction[x.core.path.plane == Plane::XY   ? 2
                      : x.core.path.plane == Plane::ZX ? 1
                                                       : 0] = 1;
        }
        x.modal.frames.rotation = turn_about(direction, frame_point(x, true, nullptr), degrees);
    }
    apply_frames(x);
    return !x.settings.offsets_turn || x.core.transformed() || apply_tool_offsets(x);
}

// G16: the plane's first axis names a radius, the second an angle; the pole is the zero of the
// workpiece system.
bool g_polar(Execution& x, const GCode& row) {
    x.modal.polar.on = row.tenths == 160;
    x.modal.polar.known = false;
    return true;
}

// Plane words of a block under G16 become a point.
bool polar_target(Execution& x, AxisValues& target, AxisSet named) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    if (p < 0 || q < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    if (!(named >> i & 1u) && !(named >> k & 1u)) return true;
    if (!x.modal.polar.known) {
        x.modal.polar.radius = std::hypot(x.core.path.programmed[i], x.core.path.programmed[k]);
        x.modal.polar.angle = std::atan2(x.core.path.programmed[k], x.core.path.programmed[i]) *
                              180.0 / std::numbers::pi;
        x.modal.polar.known = true;
    }
    for (unsigned w = 0; w < x.words.axis_count; ++w) {
        const Word& word = x.block.words[x.words.axes[w]];
        const auto [place, incremental] = axis_of(x, word);
        if (place == p)
            x.modal.polar.radius =
                length_of(x, word, -1) + (incremental ? x.modal.polar.radius : 0.0);
        if (place == q) {
            const double degrees =
                word.has_point || word.from_expression || x.settings.point_means_nothing
                    ? word.value
                    : word.value * 0.001;
            x.modal.polar.angle = degrees + (incremental ? x.modal.polar.angle : 0.0);
        }
    }
    const double a = x.modal.polar.angle * std::numbers::pi / 180.0;
    target[i] = x.modal.polar.radius * std::cos(a);
    target[k] = x.modal.polar.radius * std::sin(a);
    return true;
}

}  // namespace polyturn::channels::fanuc
