// Mirror, scale and rotation between what is programmed and the work zero: G50 G51, G50.1 G51.1,
// G68 G69, G68.1, G15 G16.
//
//   point outside = rotation( scaling( mirror( programmed ) ) )     in this order whatever order they were switched on in
#include <cmath>
#include <numbers>

#include "channels/fanuc/interpreter.hpp"

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

}  // namespace

void Interpreter::apply_frames() {
    core_.set_frame(frames_of_.rotation * frames_of_.scaling * frames_of_.mirror);
}

// X, Y, Z words as a point, mm and radii; the present point where nothing is programmed.
Point3 Interpreter::frame_point(bool present, std::array<bool, 3>* named) {
    Point3 point{};
    const MachineView& view = core_.view();
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place < 0) continue;
        if (present) point[k] = core_.path.programmed[static_cast<std::size_t>(place)];
        for (unsigned w = 0; w < axis_word_count_; ++w) {
            const Word& word = block_.words[axis_words_[w]];
            if (axis_of(word).place != place) continue;
            point[k] = length(word, place) *
                       (view.axes[static_cast<std::size_t>(place)].diameter ? 0.5 : 1.0);
            if (named) (*named)[k] = true;
        }
    }
    return point;
}

bool Interpreter::g_scale(const GCode& row) {
    frames_of_.scaling = Frame{};
    if (row.tenths == 510) {
        Point3 factors{1, 1, 1};
        const auto factor = [this](char letter) {
            const Word& word = block_.word(letter);
            return word.has_point || settings_.nct ? word.value : word.value * 0.001;
        };
        if (block_.has('P')) factors = {factor('P'), factor('P'), factor('P')};
        static constexpr char kEach[] = {'I', 'J', 'K'};
        for (std::size_t k = 0; k < 3; ++k)
            if (block_.has(kEach[k])) factors[k] = factor(kEach[k]);
        if (!block_.has('P') && !block_.has('I') && !block_.has('J') && !block_.has('K'))
            return core_.fail(Alarm::CycleWordMissing, 'G', "P");
        for (std::size_t k = 0; k < 3; ++k)
            if (factors[k] == 0)
                return core_.fail(Alarm::CycleValueIllegal, block_.has(kEach[k]) ? kEach[k] : 'P',
                                  "P", 0);
        const Point3 centre = frame_point(true, nullptr);
        words_used_ = true;
        frames_of_.scaling = Frame::scaling(factors);
        for (std::size_t k = 0; k < 3; ++k)
            frames_of_.scaling.shift[k] = centre[k] * (1 - factors[k]);
    }
    apply_frames();
    return true;
}

// G51.1: the named axes are mirrored about the named points; G50.1: no more, without a name none at
// all.
bool Interpreter::g_mirror(const GCode& row) {
    std::array<bool, 3> named{};
    const Point3 about = frame_point(false, &named);
    const bool on = row.tenths == 511;
    if (on && !named[0] && !named[1] && !named[2])
        return core_.fail(Alarm::CoordinateAxisNone, 'G', "G51.1");
    const bool all = !on && !named[0] && !named[1] && !named[2];
    for (std::size_t k = 0; k < 3; ++k) {
        if (!named[k] && !all) continue;
        frames_of_.mirror.linear[k][k] = on ? -1.0 : 1.0;
        frames_of_.mirror.shift[k] = on ? 2 * about[k] : 0.0;
    }
    words_used_ = true;
    apply_frames();
    return true;
}

// G68 of a fanuc lathe: the turret on the other side works, X counts the other way. With PT_BALANCE
// it is the balance cut with another channel instead (BalanceSink).
bool Interpreter::g_turret_mirror(const GCode&) {
    if (params::get(core_.view().table(), params::pt_balance, core_.view().channel) != 0) {
        if (core_.reads_ahead()) return core_.fail(Alarm::TransformPlace, 'G', "G41 G42");
        if (polygon_on_) return core_.fail(Alarm::PolygonBalance, 'G');
        balance_on_ = true;
        core_.signal("BALANCE", 1);
        return wants_barrier_ = true;
    }
    frames_of_.rotation = Frame::mirror(true, false, false);
    apply_frames();
    return true;
}

bool Interpreter::g_rotation(const GCode& row) {
    if (row.tenths == 690 &&
        params::get(core_.view().table(), params::pt_balance, core_.view().channel) != 0) {
        balance_on_ = false;
        core_.signal("BALANCE", 0);
        wants_barrier_ = true;
    }
    frames_of_.rotation = Frame{};
    if (row.tenths == 680 || row.tenths == 681) {
        words_used_ = true;
        if (!block_.has('R')) return core_.fail(Alarm::CycleWordMissing, 'G', "R");
        const Word& word = block_.word('R');
        const double degrees =
            word.has_point || word.from_expression || settings_.nct || settings_.point_means_nothing
                ? word.value
                : word.value * 0.001;
        const bool spatial = block_.has('I') || block_.has('J') || block_.has('K');
        Point3 direction{};
        if (spatial) {
            if (const char first = block_.has('I')   ? 'I'
                                   : block_.has('J') ? 'J'
                                                     : 'K';
                row.tenths == 680)
                return core_.fail(Alarm::AddressIllegal, first, std::string(1, first));
            direction = {block_.has('I') ? block_.value('I') : 0,
                         block_.has('J') ? block_.value('J') : 0,
                         block_.has('K') ? block_.value('K') : 0};
            if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
                return core_.fail(Alarm::CycleValueIllegal, 'I', "I J K", 0);
        } else {  // from the plane's first to its second axis; Z X: about +Y
            direction[core_.path.plane == Plane::XY   ? 2
                      : core_.path.plane == Plane::ZX ? 1
                                                      : 0] = 1;
        }
        frames_of_.rotation = turn_about(direction, frame_point(true, nullptr), degrees);
    }
    apply_frames();
    return !settings_.offsets_turn || core_.transformed() || apply_tool_offsets();
}

// G16: the plane's first axis names a radius, the second an angle; the pole is the zero of the
// workpiece system.
bool Interpreter::g_polar(const GCode& row) {
    polar_ = row.tenths == 160;
    polar_known_ = false;
    return true;
}

// Plane words of a block under G16 become a point.
bool Interpreter::polar_target(AxisValues& target, AxisSet named) {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    if (p < 0 || q < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    if (!(named >> i & 1u) && !(named >> k & 1u)) return true;
    if (!polar_known_) {
        polar_radius_ = std::hypot(core_.path.programmed[i], core_.path.programmed[k]);
        polar_angle_ = std::atan2(core_.path.programmed[k], core_.path.programmed[i]) * 180.0 /
                       std::numbers::pi;
        polar_known_ = true;
    }
    for (unsigned w = 0; w < axis_word_count_; ++w) {
        const Word& word = block_.words[axis_words_[w]];
        const auto [place, incremental] = axis_of(word);
        if (place == p) polar_radius_ = length(word, -1) + (incremental ? polar_radius_ : 0.0);
        if (place == q) {
            const double degrees =
                word.has_point || word.from_expression || settings_.point_means_nothing
                    ? word.value
                    : word.value * 0.001;
            polar_angle_ = degrees + (incremental ? polar_angle_ : 0.0);
        }
    }
    const double a = polar_angle_ * std::numbers::pi / 180.0;
    target[i] = polar_radius_ * std::cos(a);
    target[k] = polar_radius_ * std::sin(a);
    return true;
}

}  // namespace polyturn::channels::fanuc
