// Programmable frames: TRANS ROT SCALE MIRROR and their additive forms, G58 G59, frame functions
// (sinumerik_part2 13).
#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Places of X, Y, Z in the channel; -1 missing.
std::array<int, 3> geometry(const MachineView& view) {
    return {view.axis_by_role(PlaneRole::BasicX), view.axis_by_role(PlaneRole::BasicY),
            view.axis_by_role(PlaneRole::BasicZ)};
}

// Rotation about X, Y or Z, whether the channel has that axis or not.
double& turn_about(FrameValue& value, const std::array<int, 3>& geo, std::size_t k) {
    return geo[k] < 0 ? value.absent_deg[k] : value.rotation_deg[static_cast<std::size_t>(geo[k])];
}

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

}  // namespace

// Component order inside one frame: translation, rotation, scale, mirror (13.2).
Frame Interpreter::frame_of(const FrameValue& value) const {
    const MachineView& view = core_.view();
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
    f = Frame::translation(shift) * turned(degrees, settings_.euler_angles) *
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
FrameValue Interpreter::components_of(const Frame& frame, const FrameValue& like) const {
    const MachineView& view = core_.view();
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
    const Point3 degrees = angles_of(m, settings_.euler_angles);
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
bool Interpreter::set_programmable_frame(const FrameValue& value) {
    const Frame frame = frame_of(value);
    if (!frame.invertible()) return fail(Alarm::FrameFactorIllegal, {}, 0.0);
    modal_.geo.frame = value;
    modal_.geo.exact = frame;
    use_frame();
    return true;
}

// What one frame command says, as components. Values of X are radii whatever DIAMON says (MD20360,
// delivery state).
bool Interpreter::frame_words(const GCode& code, FrameValue& value, std::optional<Frame>& about) {
    const MachineView& view = core_.view();
    const auto geo = geometry(view);
    const std::string_view kind = code.name[0] == 'A' ? code.name.substr(1) : code.name;
    const Word* rpl = word("RPL");
    if (rpl && kind != "ROT") return fail_word(Alarm::AddressIllegal, *rpl, "RPL");
    if (rpl) {
        static constexpr std::size_t kApplicate[] = {2, 1, 0};
        const bool turns_others =
            std::any_of(block_.words.begin(), block_.words.end(),
                        [](const Word& w) { return w.axis >= 0 && w.number() != 0; });
        // ROT X0 Y0 Z0 of a lathe: no rotation (13.5)
        if (turns_others) return fail_word(Alarm::CodesContradict, *rpl, "RPL, X Y Z");
        const std::size_t upright = kApplicate[static_cast<std::size_t>(core_.path.plane)];
        if (std::fabs(rpl->number()) > 360)
            return fail_word(Alarm::ValueOutOfRange, *rpl, "RPL", rpl->number());
        turn_about(value, geo, upright) = rpl->number();
        // a lathe has no Y, and turns about it
        about = Frame::rotation(static_cast<GeoAxis>(upright), rpl->number());
    }
    for (const Word& w : block_.words) {
        if (w.axis < 0 || w.address->name != "axis") continue;
        const auto i = static_cast<std::size_t>(w.axis);
        if (kind == "TRANS") {
            value.coarse_mm[i] = view.axes[i].rotary ? w.number() : w.number() * unit();
        } else if (kind == "ROT" || kind == "ROTS") {
            if (w.axis != geo[0] && w.axis != geo[1] && w.axis != geo[2])
                return fail_word(Alarm::AxisKindWrong, w, view.axes[i].name);
            if (std::fabs(w.number()) > 360)
                return fail_word(Alarm::ValueOutOfRange, w, view.axes[i].name, w.number());
            value.rotation_deg[i] = w.number();
        } else if (kind == "SCALE") {
            if (w.number() == 0) return fail_word(Alarm::FrameFactorIllegal, w, {}, 0.0);
            value.scale[i] = std::fabs(w.number());
            if (w.number() < 0) value.mirrored |= 1u << i;
        } else {
            value.mirrored |= 1u << i;
        }
    }
    return true;
}

// ROTS: the first angle turns about one axis, the second about the turned other one (13.6).
bool Interpreter::solid_angles(const std::array<std::optional<double>, 3>& of, Frame& frame) {
    struct Order {
        std::size_t first, second;
        GeoAxis about_first, about_second;
    };
    static constexpr Order kOrders[] = {{0, 1, GeoAxis::Y, GeoAxis::X},
                                        {2, 0, GeoAxis::X, GeoAxis::Z},
                                        {1, 2, GeoAxis::Z, GeoAxis::Y}};
    const unsigned count =
        static_cast<unsigned>(of[0].has_value()) + of[1].has_value() + of[2].has_value();
    if (count > 2) return fail(Alarm::FrameAnglesTooMany);
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

bool Interpreter::solid_angles(Frame& frame) {
    const auto geo = geometry(core_.view());
    std::array<std::optional<double>, 3> of;
    for (const Word& w : block_.words)
        for (std::size_t k = 0; k < 3; ++k)
            if (w.address->name == "axis" && w.axis == geo[k] && w.axis >= 0) of[k] = w.number();
    return solid_angles(of, frame);
}

// MD10610: the mirror of another geometry axis is that of the reference axis and half a turn about
// the third one. The rule is the same; what $P_PFRAME shows is not.
void Interpreter::mirror_by_reference(FrameValue& said) const {
    const auto geo = geometry(core_.view());
    const auto reference = static_cast<std::size_t>(settings_.mirror_reference - 1);
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == reference || geo[k] < 0 || geo[reference] < 0 || !(said.mirrored >> geo[k] & 1u))
            continue;
        said.mirrored ^= 1u << geo[k] | 1u << geo[reference];
        turn_about(said, geo, 3 - k - reference) += 180.0;
    }
}

bool Interpreter::geo_frame(const GCode& code) {
    const bool additive = code.name[0] == 'A';
    const std::string_view kind = additive ? code.name.substr(1) : code.name;
    GeoModal& geo = modal_.geo;
    FrameValue said;
    std::optional<Frame> about;
    if (!frame_words(code, said, about)) return false;
    if (kind == "MIRROR" && settings_.mirror_toggle) {  // MD10612: the value says whether
        for (const Word& w : block_.words) {
            if (w.axis < 0 || w.address->name != "axis") continue;
            const AxisSet bit = 1u << w.axis;
            const bool wanted = w.number() != 0, is = additive && (geo.frame.mirrored & bit);
            if (wanted == is) said.mirrored &= ~bit;
        }
    }
    Frame step = about ? *about : frame_of(said);
    if (kind == "ROTS" && !solid_angles(step)) return false;
    if (kind == "MIRROR" && settings_.mirror_reference > 0) mirror_by_reference(said);
    if (!additive) {
        geo.exact = step;
        geo.frame = said;
        if (kind == "ROTS" || (about && settings_.euler_angles))
            geo.frame = components_of(step, said);
    } else {
        geo.frame.mirrored ^= said.mirrored;
        geo.exact = geo.exact * step;
        geo.frame = components_of(geo.exact, geo.frame);
    }
    use_frame();
    return true;
}

// TOROT, TOFRAME and their X and Y forms: the named axis of the workpiece system points along the
// tool, which is perpendicular to the plane; the programmable frame keeps where it is and its
// factors (13.9). TOROTOF takes the rotation back.
bool Interpreter::g_tool_frame(const GCode& code) {
    if (code.number == 1 && active(53) == 1) return true;
    static constexpr std::size_t kApplicate[] = {2, 1, 0};
    const std::size_t upright = kApplicate[static_cast<std::size_t>(core_.path.plane)];
    const char letter = code.name.back();
    const std::size_t named = letter == 'X' ? 0 : letter == 'Y' ? 1 : 2;
    Frame rotation;
    if (code.number != 1) {
        Frame wanted, outer;
        wanted.linear = {};
        for (std::size_t k = 0; k < 3; ++k) wanted.linear[(upright + k) % 3][(named + k) % 3] = 1.0;
        outer.linear = outer_frame().linear;
        for (std::size_t k = 0; k < 3; ++k) {
            const double length = std::sqrt(outer.linear[0][k] * outer.linear[0][k] +
                                            outer.linear[1][k] * outer.linear[1][k] +
                                            outer.linear[2][k] * outer.linear[2][k]);
            for (auto& row : outer.linear) row[k] /= length;
        }
        rotation = outer.inverse() * wanted;
    }
    GeoModal& geo = modal_.geo;
    const auto places = geometry(core_.view());
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
    geo.frame = components_of(turned_frame, geo.frame);
    use_frame();
    return true;
}

// G58, G59: coarse and fine translation of the named axes (13.4); on the 828D they are settable
// offsets.
bool Interpreter::geo_partial_shift(const GCode& code) {
    if (!settings_.fine_translation) return fail(Alarm::FineTranslationOff, std::string(code.name));
    GeoModal& geo = modal_.geo;
    const auto places = geometry(core_.view());
    for (const Word& w : block_.words) {
        if (w.axis < 0 || w.address->name != "axis") continue;
        if (std::ranges::find(places, w.axis) == places.end())
            return fail_word(Alarm::AxisKindWrong, w, axis_name(w.axis));
        const auto i = static_cast<std::size_t>(w.axis);
        double& part = code.name == "G58" ? geo.frame.coarse_mm[i] : geo.frame.fine_mm[i];
        const double value = w.number() * unit(), by = value - part;
        part = value;
        for (std::size_t k = 0; k < 3; ++k)
            if (places[k] == w.axis) geo.exact.shift[k] += by;
    }
    use_frame();
    return true;
}

// --- frames as values: CTRANS(X,10):CROT(Z,90)

bool Interpreter::chain_frames(Value& left, const Value& right) {
    static const FrameValue kNone;
    const FrameValue& a = left.frame ? *left.frame : kNone;
    const FrameValue& b = right.frame ? *right.frame : kNone;
    FrameValue like = a;
    like.mirrored ^= b.mirrored;
    FrameValue sum = components_of(frame_of(a) * frame_of(b), like);
    // coarse and fine stay apart where nothing turns or scales them
    bool plain = a.absent_deg == std::array<double, 3>{};
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        plain = plain && a.rotation_deg[i] == 0 && (a.scale[i] == 0 || a.scale[i] == 1) &&
                !(a.mirrored >> i & 1u);
    for (std::size_t i = 0; i < sum.fine_mm.size(); ++i) {
        if (plain) {
            sum.coarse_mm[i] = a.coarse_mm[i] + b.coarse_mm[i];
            sum.fine_mm[i] = a.fine_mm[i] + b.fine_mm[i];
        } else {
            sum.coarse_mm[i] += sum.fine_mm[i] - a.fine_mm[i];
            sum.fine_mm[i] = a.fine_mm[i];
        }
    }
    left = Value::of_frame(sum);
    return true;
}

bool Interpreter::f_frame(Call& call, std::string_view name) {
    FrameValue value;
    for (std::size_t k = 0; k < call.arguments.size(); ++k) {
        if (!call.has(k))
            return fail(Alarm::ArgumentCountIllegal, std::string(name), static_cast<double>(k));
        const int place = call.value(k).place();
        if (name == "CROT" && call.value(k).type == Type::Axis && place <= kAbsentAxis) {
            if (!call.has(k + 1))
                return fail(Alarm::ArgumentCountIllegal, std::string(name), static_cast<double>(k));
            value.absent_deg[static_cast<std::size_t>(kAbsentAxis - place)] = call.number(++k);
            continue;
        }
        if (place < 0 || static_cast<unsigned>(place) >= core_.view().axis_count)
            return fail(Alarm::AxisKindWrong, call.value(k).text);
        const auto i = static_cast<std::size_t>(place);
        if (name == "CMIRROR") {
            value.mirrored |= 1u << i;
            continue;
        }
        if (!call.has(k + 1))
            return fail(Alarm::ArgumentCountIllegal, std::string(name), static_cast<double>(k));
        const double number = call.number(++k),
                     mm = core_.view().axes[i].rotary ? number : number * unit();
        if (name == "CTRANS")
            value.coarse_mm[i] = mm;
        else if (name == "CFINE")
            value.fine_mm[i] = mm;
        else if (name == "CROT")
            value.rotation_deg[i] = number;
        else if (number == 0)
            return fail(Alarm::FrameFactorIllegal, {}, 0.0);
        else
            value.scale[i] = number;
    }
    call.result = Value::of_frame(value);
    return true;
}
bool Interpreter::f_ctrans(Call& call) { return f_frame(call, "CTRANS"); }
bool Interpreter::f_cfine(Call& call) { return f_frame(call, "CFINE"); }
bool Interpreter::f_cscale(Call& call) { return f_frame(call, "CSCALE"); }
bool Interpreter::f_crot(Call& call) { return f_frame(call, "CROT"); }
bool Interpreter::f_cmirror(Call& call) { return f_frame(call, "CMIRROR"); }

// CROTS(X, a, Y, b): the frame that ROTS makes.
bool Interpreter::f_crots(Call& call) {
    std::array<std::optional<double>, 3> angles;
    const auto geo = geometry(core_.view());
    for (std::size_t k = 0; k + 1 < call.arguments.size(); k += 2) {
        if (!call.has(k) || !call.has(k + 1))
            return fail(Alarm::ArgumentCountIllegal, "CROTS", static_cast<double>(k));
        bool found = false;
        for (std::size_t g = 0; g < 3; ++g)
            if (call.value(k).place() ==
                (geo[g] < 0 ? kAbsentAxis - static_cast<int>(g) : geo[g])) {
                angles[g] = call.number(k + 1);
                found = true;
            }
        if (!found) return fail(Alarm::AxisKindWrong, call.value(k).text);
    }
    Frame frame;
    if (!solid_angles(angles, frame)) return false;
    call.result = Value::of_frame(components_of(frame, {}));
    return true;
}

// A frame of the control that this one does not have: ADDFRAME's 2. Any other text is wrong: 1.
static bool is_other_frame(std::string_view target) {
    static constexpr std::string_view kNames[] = {"TRAFR",  "PARTFR", "SETFR",  "EXTFR",  "TOOLFR",
                                                  "WPFR",   "CYCFR",  "CHBFR",  "NCBFR",  "GFR",
                                                  "ISO1FR", "ISO2FR", "ISO3FR", "ISO4FR", "RELFR"};
    if (!target.starts_with("$P_")) return false;
    target.remove_prefix(3);
    if (const auto bracket = target.find('[');
        bracket != std::string_view::npos && target.ends_with(']'))
        target = target.substr(0, bracket);
    for (const std::string_view name : kNames)
        if (target == name || (target.starts_with(name) && target.substr(name.size()) == "AME"))
            return true;
    return false;
}

// ADDFRAME(frame, "$P_PFRAME", "$P_UIFR[1]"): what was the whole chain before is now that chain
// with the frame behind it.
bool Interpreter::f_addframe(Call& call) {
    static const FrameValue kNone;
    const Frame added = frame_of(call.value(0).frame ? *call.value(0).frame : kNone);
    const std::string target = upper(call.value(1).text);
    GeoModal& geo = modal_.geo;
    const auto answer = [&](int code) {
        call.result = Value::of_int(code);
        return true;
    };
    if (int number = 0; names_settable(target, number)) {
        if (number >= settings_.frames) return answer(2);
        return add_to_settable(number, added) && answer(0);
    }
    if (target != "$P_PFRAME" && target != "$P_ACTBFRAME" && target != "$P_BFRAME")
        return answer(is_other_frame(target) ? 2 : 1);
    const GeoModal before = geo;
    undo([this, before] {
        modal_.geo.frame = before.frame;
        modal_.geo.exact = before.exact;
        modal_.geo.basic_value = before.basic_value;
        modal_.geo.basic = before.basic;
        core_.set_frame(outer_frame() * modal_.geo.exact);
    });
    if (target == "$P_PFRAME") {
        geo.exact = geo.exact * added;
        geo.frame = components_of(geo.exact, geo.frame);
    } else {
        const Frame inner = geo.basic.inverse() * outer_frame() * geo.exact;
        geo.basic = geo.basic * inner * added * inner.inverse();
        geo.basic_value = components_of(geo.basic, geo.basic_value);
    }
    // what is added counts as coarse
    FrameValue& result = target == "$P_PFRAME" ? geo.frame : geo.basic_value;
    const FrameValue& had = target == "$P_PFRAME" ? before.frame : before.basic_value;
    for (std::size_t i = 0; i < result.fine_mm.size(); ++i) {
        result.coarse_mm[i] += result.fine_mm[i] - had.fine_mm[i];
        result.fine_mm[i] = had.fine_mm[i];
    }
    use_frame();
    return answer(0);
}

bool Interpreter::f_crpl(Call& call) {  // CRPL(0|1|2|3, angle): the active plane, XY, ZX, YZ
    static constexpr int kApplicate[] = {2, 1, 0};
    const int which = static_cast<int>(call.number(0));
    if (which < 0 || which > 3) return fail(Alarm::ValueOutOfRange, "CRPL", which);
    const int upright = kApplicate[which == 0 ? static_cast<std::size_t>(core_.path.plane)
                                              : static_cast<std::size_t>(which - 1)];
    FrameValue value;
    turn_about(value, geometry(core_.view()), static_cast<std::size_t>(upright)) = call.number(1);
    call.result = Value::of_frame(value);
    return true;
}

bool Interpreter::f_invframe(Call& call) {
    static const FrameValue kNone;
    const FrameValue& value = call.value(0).frame ? *call.value(0).frame : kNone;
    const Frame inverse = frame_of(value).inverse();
    FrameValue like;
    like.mirrored = value.mirrored;
    FrameValue result = components_of(inverse, like);
    std::swap(result.coarse_mm, result.fine_mm);
    call.result = Value::of_frame(result);
    return true;
}

}  // namespace polyturn::channels::sinumerik
