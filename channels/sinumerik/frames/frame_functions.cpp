// Frames as values: CTRANS, CROT and the like, and their chain by the colon.
#include "channels/sinumerik/frames/frame_functions.hpp"

#include "channels/angles.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// A frame of the control that this one does not have: ADDFRAME's 2. Any other text is wrong: 1.
bool is_other_frame(std::string_view target) {
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

bool f_frame(Execution& x, Call& call, std::string_view name) {
    FrameValue value;
    for (std::size_t k = 0; k < call.arguments.size(); ++k) {
        if (!call.has(k))
            return fail(x, Alarm::ArgumentCountIllegal, std::string(name), static_cast<double>(k));
        const int place = call.value(k).place();
        if (name == "CROT" && call.value(k).type == Type::Axis && place <= kAbsentAxis) {
            if (!call.has(k + 1))
                return fail(x, Alarm::ArgumentCountIllegal, std::string(name),
                            static_cast<double>(k));
            value.absent_deg[static_cast<std::size_t>(kAbsentAxis - place)] = call.number(++k);
            continue;
        }
        if (place < 0 || static_cast<unsigned>(place) >= x.core.view().axis_count)
            return fail(x, Alarm::AxisKindWrong, call.value(k).text);
        const auto i = static_cast<std::size_t>(place);
        if (name == "CMIRROR") {
            value.mirrored |= 1u << i;
            continue;
        }
        if (!call.has(k + 1))
            return fail(x, Alarm::ArgumentCountIllegal, std::string(name), static_cast<double>(k));
        const double number = call.number(++k),
                     mm = x.core.view().axes[i].rotary ? number : number * unit(x);
        if (name == "CTRANS")
            value.coarse_mm[i] = mm;
        else if (name == "CFINE")
            value.fine_mm[i] = mm;
        else if (name == "CROT")
            value.rotation_deg[i] = number;
        else if (number == 0)
            return fail(x, Alarm::FrameFactorIllegal, {}, 0.0);
        else
            value.scale[i] = number;
    }
    call.result = Value::of_frame(value);
    return true;
}

}  // namespace

bool chain_frames(Execution& x, Value& left, const Value& right) {
    static const FrameValue kNone;
    const FrameValue& a = left.frame ? *left.frame : kNone;
    const FrameValue& b = right.frame ? *right.frame : kNone;
    FrameValue like = a;
    like.mirrored ^= b.mirrored;
    FrameValue sum = components_of(x, frame_of(x, a) * frame_of(x, b), like);
    // coarse and fine stay apart where nothing turns or scales them
    bool plain = a.absent_deg == std::array<double, 3>{};
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
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

bool f_ctrans(Execution& x, Call& call) { return f_frame(x, call, "CTRANS"); }
bool f_cfine(Execution& x, Call& call) { return f_frame(x, call, "CFINE"); }
bool f_cscale(Execution& x, Call& call) { return f_frame(x, call, "CSCALE"); }
bool f_crot(Execution& x, Call& call) { return f_frame(x, call, "CROT"); }
bool f_cmirror(Execution& x, Call& call) { return f_frame(x, call, "CMIRROR"); }
// CROTS(X, a, Y, b): the frame that ROTS makes.
bool f_crots(Execution& x, Call& call) {
    std::array<std::optional<double>, 3> angles;
    const auto geo = geometry(x.core.view());
    for (std::size_t k = 0; k + 1 < call.arguments.size(); k += 2) {
        if (!call.has(k) || !call.has(k + 1))
            return fail(x, Alarm::ArgumentCountIllegal, "CROTS", static_cast<double>(k));
        bool found = false;
        for (std::size_t g = 0; g < 3; ++g)
            if (call.value(k).place() ==
                (geo[g] < 0 ? kAbsentAxis - static_cast<int>(g) : geo[g])) {
                angles[g] = call.number(k + 1);
                found = true;
            }
        if (!found) return fail(x, Alarm::AxisKindWrong, call.value(k).text);
    }
    Frame frame;
    if (!solid_angles(x, angles, frame)) return false;
    call.result = Value::of_frame(components_of(x, frame, {}));
    return true;
}
// ADDFRAME(frame, "$P_PFRAME", "$P_UIFR[1]"): what was the whole chain before is now that chain
// with the frame behind it.
bool f_addframe(Execution& x, Call& call) {
    static const FrameValue kNone;
    const Frame added = frame_of(x, call.value(0).frame ? *call.value(0).frame : kNone);
    const std::string target = upper(call.value(1).text);
    GeoModal& geo = x.modal.geo;
    const auto answer = [&](int code) {
        call.result = Value::of_int(code);
        return true;
    };
    if (int number = 0; names_settable(x, target, number)) {
        if (number >= x.settings.frames) return answer(2);
        return add_to_settable(x, number, added) && answer(0);
    }
    if (target != "$P_PFRAME" && target != "$P_ACTBFRAME" && target != "$P_BFRAME")
        return answer(is_other_frame(target) ? 2 : 1);
    const GeoModal before = geo;
    undo(x, [&x, before] {
        x.modal.geo.frame = before.frame;
        x.modal.geo.exact = before.exact;
        x.modal.geo.basic_value = before.basic_value;
        x.modal.geo.basic = before.basic;
        x.core.set_frame(outer_frame(x) * x.modal.geo.exact);
    });
    if (target == "$P_PFRAME") {
        geo.exact = geo.exact * added;
        geo.frame = components_of(x, geo.exact, geo.frame);
    } else {
        const Frame inner = geo.basic.inverse() * outer_frame(x) * geo.exact;
        geo.basic = geo.basic * inner * added * inner.inverse();
        geo.basic_value = components_of(x, geo.basic, geo.basic_value);
    }
    // what is added counts as coarse
    FrameValue& result = target == "$P_PFRAME" ? geo.frame : geo.basic_value;
    const FrameValue& had = target == "$P_PFRAME" ? before.frame : before.basic_value;
    for (std::size_t i = 0; i < result.fine_mm.size(); ++i) {
        result.coarse_mm[i] += result.fine_mm[i] - had.fine_mm[i];
        result.fine_mm[i] = had.fine_mm[i];
    }
    use_frame(x);
    return answer(0);
}
bool f_crpl(Execution& x, Call& call) {  // CRPL(0|1|2|3, angle): the active plane, XY, ZX, YZ
    static constexpr int kApplicate[] = {2, 1, 0};
    const int which = static_cast<int>(call.number(0));
    if (which < 0 || which > 3) return fail(x, Alarm::ValueOutOfRange, "CRPL", which);
    const int upright = kApplicate[which == 0 ? static_cast<std::size_t>(x.core.path.plane)
                                              : static_cast<std::size_t>(which - 1)];
    FrameValue value;
    turn_about(value, geometry(x.core.view()), static_cast<std::size_t>(upright)) = call.number(1);
    call.result = Value::of_frame(value);
    return true;
}
bool f_invframe(Execution& x, Call& call) {
    static const FrameValue kNone;
    const FrameValue& value = call.value(0).frame ? *call.value(0).frame : kNone;
    const Frame inverse = frame_of(x, value).inverse();
    FrameValue like;
    like.mirrored = value.mirrored;
    FrameValue result = components_of(x, inverse, like);
    std::swap(result.coarse_mm, result.fine_mm);
    call.result = Value::of_frame(result);
    return true;
}
}  // namespace polyturn::channels::sinumerik
