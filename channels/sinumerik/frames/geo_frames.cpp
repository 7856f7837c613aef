// Programmable frames: TRANS ROT SCALE MIRROR and their additive forms, G58 G59, frame functions
// (sinumerik_part2 13).
#include "channels/sinumerik/frames/geo_frames.hpp"

#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/grammar/words.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// X''Y'Z: about Z, then the new Y, then the new X. Euler (MD10600): about Z, then the new X, then
// the new Z by the angle of Y (13.2).
Frame turned(const Point3& degrees, bool euler) {
    if (euler)
        return Frame::rotation(GeoAxis::Z, degrees[2]) * Frame::rotation(GeoAxis::X, degrees[0]) *
               Frame::rotation(GeoAxis::Z, degrees[1]);
    return Frame::rotation(GeoAxis::Z, degrees[2]) * Frame::rotation(GeoAxis::Y, degrees[1]) *
           Frame::rotation(GeoAxis::X, degrees[0]);
}

// The angles of turned() of a pure rotation.
Point3 angles_of(const std::array<Point3, 3>& m, bool euler) {
    if (euler) {  // X from 0 to 180
        const double x = std::atan2(std::hypot(m[2][0], m[2][1]), m[2][2]);
        if (std::hypot(m[2][0], m[2][1]) < 1e-12)
            return {x / kDegree, 0.0, std::atan2(m[1][0], m[0][0]) / kDegree};
        return {x / kDegree, std::atan2(m[2][0], m[2][1]) / kDegree,
                std::atan2(m[0][2], -m[1][2]) / kDegree};
    }
    const double y = std::asin(std::fmax(-1.0, std::fmin(1.0, -m[2][0])));
    if (std::fabs(m[2][0]) > 1 - 1e-12)
        return {std::atan2(-m[1][2], m[1][1]) / kDegree, y / kDegree, 0.0};
    return {std::atan2(m[2][1], m[2][2]) / kDegree, y / kDegree,
            std::atan2(m[1][0], m[0][0]) / kDegree};
}

// What one frame command says, as components. Values of X are radii whatever DIAMON says (MD20360,
// delivery state).
bool frame_words(Execution& x, const GCode& code, FrameValue& value, std::optional<Frame>& about) {
    const MachineView& view = x.core.view();
    const auto geo = geometry(view);
    const std::string_view kind = code.name[0] == 'A' ? code.name.substr(1) : code.name;
    const Word* rpl = word(x, "RPL");
    if (rpl && kind != "ROT") return fail_word(x, Alarm::AddressIllegal, *rpl, "RPL");
    if (rpl) {
        static constexpr std::size_t kApplicate[] = {2, 1, 0};
        const bool turns_others =
            std::any_of(x.block.words.begin(), x.block.words.end(),
                        [](const Word& w) { return w.axis >= 0 && w.number() != 0; });
        // ROT X0 Y0 Z0 of a lathe: no rotation (13.5)
        if (turns_others) return fail_word(x, Alarm::CodesContradict, *rpl, "RPL, X Y Z");
        const std::size_t upright = kApplicate[static_cast<std::size_t>(x.core.path.plane)];
        if (std::fabs(rpl->number()) > 360)
            return fail_word(x, Alarm::ValueOutOfRange, *rpl, "RPL", rpl->number());
        turn_about(value, geo, upright) = rpl->number();
        // a lathe has no Y, and turns about it
        about = Frame::rotation(static_cast<GeoAxis>(upright), rpl->number());
    }
    for (const Word& w : x.block.words) {
        if (w.axis < 0 || w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        if (kind == "TRANS") {
            value.coarse_mm[i] = view.axes[i].rotary ? w.number() : w.number() * unit(x);
        } else if (kind == "ROT" || kind == "ROTS") {
            if (w.axis != geo[0] && w.axis != geo[1] && w.axis != geo[2])
                return fail_word(x, Alarm::AxisKindWrong, w, view.axes[i].name);
            if (std::fabs(w.number()) > 360)
                return fail_word(x, Alarm::ValueOutOfRange, w, view.axes[i].name, w.number());
            value.rotation_deg[i] = w.number();
        } else if (kind == "SCALE") {
            if (w.number() == 0) return fail_word(x, Alarm::FrameFactorIllegal, w, {}, 0.0);
            value.scale[i] = std::fabs(w.number());
            if (w.number() < 0) value.mirrored |= 1u << i;
        } else {
            value.mirrored |= 1u << i;
        }
    }
    return true;
}

// MD10610: the mirror of another geometry axis is that of the reference axis and half a turn about
// the third one. The rule is the same; what $P_PFRAME shows is not.
void mirror_by_reference(const Execution& x, FrameValue& said) {
    const auto geo = geometry(x.core.view());
    const auto reference = static_cast<std::size_t>(x.settings.mirror_reference - 1);
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == reference || geo[k] < 0 || geo[reference] < 0 || !(said.mirrored >> geo[k] & 1u))
            continue;
        said.mirrored ^= 1u << geo[k] | 1u << geo[reference];
        turn_about(said, geo, 3 - k - reference) += 180.0;
    }
}

}  // namespace

// Component order inside one frame: translation, rotation, scale, mirror (13.2).
Frame frame_of(const Execution& x, const FrameValue& value) {
    const MachineView& view = x.core.view();
    const auto geo = geometry(view);
    Point3 shift{}, degrees{}, factor{1, 1, 1};
    Frame f;
    for (std::size_t k = 0; k < 3; ++k) {
        if (geo[k] < 0) {
            degrees[k] = value.absent_deg[k];
            continue;
        }
        const auto i = static_cast<std::size_t>(geo[k]);
        shift[k] = value.coarse_mm[i] + value.fine_mm[i];
        degrees[k] = value.rotation_deg[i];
        factor[k] =
            (value.scale[i] == 0 ? 1.0 : value.scale[i]) * (value.mirrored >> i & 1u ? -1.0 : 1.0);
    }
    f = Frame::translation(shift) * turned(degrees, x.settings.euler_angles) *
        Frame::scaling(factor);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        if (static_cast<int>(i) == geo[0] || static_cast<int>(i) == geo[1] ||
            static_cast<int>(i) == geo[2])
            continue;
        f.offset[i] = value.coarse_mm[i] + value.fine_mm[i];
        f.scale[i] =
            (value.scale[i] == 0 ? 1.0 : value.scale[i]) * (value.mirrored >> i & 1u ? -1.0 : 1.0);
    }
    return f;
}

// The components of a rule that is one of `like` and further translations, rotations, scales and
// mirrors: what has changed of the translation counts as fine.
FrameValue components_of(const Execution& x, const Frame& frame, const FrameValue& like) {
    const MachineView& view = x.core.view();
    const auto geo = geometry(view);
    FrameValue value = like;
    auto m = frame.linear;
    for (std::size_t k = 0; k < 3; ++k) {
        double length = std::sqrt(m[0][k] * m[0][k] + m[1][k] * m[1][k] + m[2][k] * m[2][k]);
        const bool mirrored = geo[k] >= 0 && (like.mirrored >> geo[k] & 1u);
        for (auto& row : m) row[k] /= mirrored ? -length : length;
        if (geo[k] < 0) continue;
        const auto i = static_cast<std::size_t>(geo[k]);
        value.scale[i] = length;
        value.fine_mm[i] = frame.shift[k] - like.coarse_mm[i];
    }
    const Point3 degrees = angles_of(m, x.settings.euler_angles);
    for (std::size_t k = 0; k < 3; ++k) turn_about(value, geo, k) = degrees[k];
    for (unsigned i = 0; i < view.axis_count; ++i) {
        if (static_cast<int>(i) == geo[0] || static_cast<int>(i) == geo[1] ||
            static_cast<int>(i) == geo[2])
            continue;
        value.fine_mm[i] = frame.offset[i] - like.coarse_mm[i];
        value.scale[i] = std::fabs(frame.scale[i]);
    }
    return value;
}

// $P_PFRAME = ..., or one component of it.
bool set_programmable_frame(Execution& x, const FrameValue& value) {
    const Frame frame = frame_of(x, value);
    if (!frame.invertible()) return fail(x, Alarm::FrameFactorIllegal, {}, 0.0);
    x.modal.geo.frame = value;
    x.modal.geo.exact = frame;
    use_frame(x);
    return true;
}

// ROTS: the first angle turns about one axis, the second about the turned other one (13.6).
bool solid_angles(Execution& x, const std::array<std::optional<double>, 3>& of, Frame& frame) {
    struct Order {
        std::size_t first, second;
        GeoAxis about_first, about_second;
    };
    static constexpr Order kOrders[] = {{0, 1, GeoAxis::Y, GeoAxis::X},
                                        {2, 0, GeoAxis::X, GeoAxis::Z},
                                        {1, 2, GeoAxis::Z, GeoAxis::Y}};
    const unsigned count =
        static_cast<unsigned>(of[0].has_value()) + of[1].has_value() + of[2].has_value();
    if (count > 2) return fail(x, Alarm::FrameAnglesTooMany);
    if (count == 1) {
        for (std::size_t k = 0; k < 3; ++k)
            if (of[k]) frame = Frame::rotation(static_cast<GeoAxis>(k), *of[k]);
        return true;
    }
    for (const Order& order : kOrders)
        if (of[order.first] && of[order.second])
            frame = Frame::rotation(order.about_first, *of[order.first]) *
                    Frame::rotation(order.about_second, *of[order.second]);
    return true;
}

bool solid_angles(Execution& x, Frame& frame) {
    const auto geo = geometry(x.core.view());
    std::array<std::optional<double>, 3> of;
    for (const Word& w : x.block.words)
        for (std::size_t k = 0; k < 3; ++k)
            if (w.address->name == "axis" && w.axis == geo[k] && w.axis >= 0) of[k] = w.number();
    return solid_angles(x, of, frame);
}

bool geo_frame(Execution& x, const GCode& code) {
    const bool additive = code.name[0] == 'A';
    const std::string_view kind = additive ? code.name.substr(1) : code.name;
    GeoModal& geo = x.modal.geo;
    FrameValue said;
    std::optional<Frame> about;
    if (!frame_words(x, code, said, about)) return false;
    if (kind == "MIRROR" && x.settings.mirror_toggle) {  // MD10612: the value says whether
        for (const Word& w : x.block.words) {
            if (w.axis < 0 || w.address->name != "axis") continue;
            const AxisSet bit = 1u << w.axis;
            const bool wanted = w.number() != 0, is = additive && (geo.frame.mirrored & bit);
            if (wanted == is) said.mirrored &= ~bit;
        }
    }
    Frame step = about ? *about : frame_of(x, said);
    if (kind == "ROTS" && !solid_angles(x, step)) return false;
    if (kind == "MIRROR" && x.settings.mirror_reference > 0) mirror_by_reference(x, said);
    if (!additive) {
        geo.exact = step;
        geo.frame = said;
        if (kind == "ROTS" || (about && x.settings.euler_angles))
            geo.frame = components_of(x, step, said);
    } else {
        geo.frame.mirrored ^= said.mirrored;
        geo.exact = geo.exact * step;
        geo.frame = components_of(x, geo.exact, geo.frame);
    }
    use_frame(x);
    return true;
}

// TOROT, TOFRAME and their X and Y forms: the named axis of the workpiece system points along the
// tool, which is perpendicular to the plane; the programmable frame keeps where it is and its
// factors (13.9). TOROTOF takes the rotation back.
bool g_tool_frame(Execution& x, const GCode& code) {
    if (code.number == 1 && active(x, 53) == 1) return true;
    static constexpr std::size_t kApplicate[] = {2, 1, 0};
    const std::size_t upright = kApplicate[static_cast<std::size_t>(x.core.path.plane)];
    const char letter = code.name.back();
    const std::size_t named = letter == 'X' ? 0 : letter == 'Y' ? 1 : 2;
    Frame rotation;
    if (code.number != 1) {
        Frame wanted, outer;
        wanted.linear = {};
        for (std::size_t k = 0; k < 3; ++k) wanted.linear[(upright + k) % 3][(named + k) % 3] = 1.0;
        outer.linear = outer_frame(x).linear;
        for (std::size_t k = 0; k < 3; ++k) {
            const double length = std::sqrt(outer.linear[0][k] * outer.linear[0][k] +
                                            outer.linear[1][k] * outer.linear[1][k] +
                                            outer.linear[2][k] * outer.linear[2][k]);
            for (auto& row : outer.linear) row[k] /= length;
        }
        rotation = outer.inverse() * wanted;
    }
    GeoModal& geo = x.modal.geo;
    const auto places = geometry(x.core.view());
    Frame turned_frame = geo.exact;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(places[k]);
        const double factor = places[k] < 0 ? 1.0
                                            : (geo.frame.scale[i] == 0 ? 1.0 : geo.frame.scale[i]) *
                                                  (geo.frame.mirrored >> i & 1u ? -1.0 : 1.0);
        for (std::size_t row = 0; row < 3; ++row)
            turned_frame.linear[row][k] = rotation.linear[row][k] * factor;
    }
    geo.exact = turned_frame;
    geo.frame = components_of(x, turned_frame, geo.frame);
    use_frame(x);
    return true;
}

// G58, G59: coarse and fine translation of the named axes (13.4); on the 828D they are settable
// offsets.
bool geo_partial_shift(Execution& x, const GCode& code) {
    if (!x.settings.fine_translation)
        return fail(x, Alarm::FineTranslationOff, std::string(code.name));
    GeoModal& geo = x.modal.geo;
    const auto places = geometry(x.core.view());
    for (const Word& w : x.block.words) {
        if (w.axis < 0 || w.address->name != "axis") continue;
        if (std::ranges::find(places, w.axis) == places.end())
            return fail_word(x, Alarm::AxisKindWrong, w, axis_name(x, w.axis));
        const auto i = static_cast<std::size_t>(w.axis);
        double& part = code.name == "G58" ? geo.frame.coarse_mm[i] : geo.frame.fine_mm[i];
        const double value = w.number() * unit(x), by = value - part;
        part = value;
        for (std::size_t k = 0; k < 3; ++k)
            if (places[k] == w.axis) geo.exact.shift[k] += by;
    }
    use_frame(x);
    return true;
}

// --- frames as values: CTRANS(X,10):CROT(Z,90)

}  // namespace polyturn::channels::sinumerik
