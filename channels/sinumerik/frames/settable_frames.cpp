// Frames around the programmable one: settable ($P_UIFR), grinding ($P_GFR) and basic frames
// (sinumerik_part1 2.4, part 2 13).
//
//   workpiece -- programmable -- grinding -- settable -- basic --> machine
//
// The shift of a settable frame lies in the store, where operators enter it, and acts as Core's
// zero. What else a program gives a frame (fine shift, rotation, scale, mirror) it keeps for its
// own run.
#include "channels/sinumerik/frames/settable_frames.hpp"

#include <charconv>
#include <cmath>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/frames/geo_variables.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr PlaneRole kBasicAxes[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};

std::optional<std::size_t> row_of(int number) {
    return number == 0 ? work_zero_row("G500")
                       : settable_zero_row(static_cast<std::size_t>(number));
}

// A shift by what Core adds outside its frame.
Frame shift_by(const MachineView& view, const AxisValues& by, double sign) {
    Frame f;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        bool geometry = false;
        for (std::size_t k = 0; k < 3; ++k)
            if (view.axes[i].role == kBasicAxes[k]) {
                f.shift[k] = sign * by[i];
                geometry = true;
            }
        if (!geometry) f.offset[i] = sign * by[i];
    }
    return f;
}

bool is_basic(const std::string& name) {
    return name == "$P_ACTBFRAME" || name == "$P_BFRAME" || name == "$P_CHBFRAME";
}

FrameValue settable_frame(Execution& x, int number) {
    FrameValue value;
    if (const auto found = x.frames.settable.find(number); found != x.frames.settable.end())
        value = found->second;
    if (const auto row = row_of(number))
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            value.coarse_mm[i] =
                x.core.view().from_shown(i, x.core.view().store->zeros[*row * kChannelAxes + i]);
    return value;
}

bool set_settable_frame(Execution& x, int number, const FrameValue& value) {
    const auto row = row_of(number);
    if (!row) return fail(x, Alarm::ArrayIndexIllegal, "$P_UIFR", number);
    FrameValue parts = value;
    parts.coarse_mm = {};
    if (!frame_of(x, parts).invertible()) return fail(x, Alarm::FrameFactorIllegal, {}, 0.0);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        double& cell = x.core.view().store->zeros[*row * kChannelAxes + i];
        const double shown = x.core.view().to_shown(i, value.coarse_mm[i]);
        if (cell == shown) continue;
        undo(x, [at = &cell, before = cell] { *at = before; });
        cell = shown;
        x.frames.written.push_back({number, static_cast<std::int32_t>(*row), i, shown});
    }
    const auto before = x.frames.settable.find(number);
    undo(x, [&x, number, had = before != x.frames.settable.end(),
             old = before != x.frames.settable.end() ? before->second : FrameValue{}] {
        if (had)
            x.frames.settable[number] = old;
        else
            x.frames.settable.erase(number);
    });
    const bool plain = frame_of(x, parts).is_identity();
    if (plain)
        x.frames.settable.erase(number);
    else
        x.frames.settable[number] = parts;
    return true;
}

// The number of the frame that the first index names.
bool frame_number(Execution& x, const std::string& name, const std::vector<Value>& indices,
                  int most, int& number) {
    const double n = indices.empty() || !indices[0].is_number() ? -1 : indices[0].number;
    if (!(n >= 0 && n <= most) || n != std::floor(n))
        return fail(x, Alarm::ArrayIndexIllegal, name, n);
    number = static_cast<int>(n);
    return true;
}

bool component_named(Execution& x, const std::string& name, const std::vector<Value>& indices,
                     std::size_t first, std::size_t& place, std::string& part) {
    if (indices.size() != first + 2) return fail(x, Alarm::ArrayIndexMissing, name);
    const int axis = indices[first].type == Type::Axis ? indices[first].place() : -1;
    part = upper(indices[first + 1].text);
    if (indices[first].type == Type::Axis && axis <= kAbsentAxis) {  // frame_part()
        if (part != "RT") return fail(x, Alarm::AxisArgumentMissing, name);
        place = kChannelAxes + static_cast<std::size_t>(kAbsentAxis - axis);
        return true;
    }
    if (axis < 0 || axis >= static_cast<int>(x.core.view().axis_count))
        return fail(x, Alarm::AxisArgumentMissing, name);
    place = static_cast<std::size_t>(axis);
    return true;
}

// Zeros, frames and tools change what the programmed numbers mean; an incremental block may travel
// the difference.
void zeros_change(Execution& x, const std::function<void()>& change) {
    const AxisValues before = x.core.path.programmed;
    change();
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        x.modal.pending_zero[i] += before[i] - x.core.path.programmed[i];
}

}  // namespace

// What lies between the programmable frame and Core's zero.
Frame outer_frame(const Execution& x) {
    Frame outer;
    const auto found = x.frames.settable.find(static_cast<int>(x.modal.active[8]) - 1);
    if (found != x.frames.settable.end()) outer = frame_of(x, found->second);
    if (const auto own = x.frames.grinding.find(static_cast<int>(x.modal.active[64]) - 1);
        own != x.frames.grinding.end())
        outer = outer * frame_of(x, own->second);
    if (x.modal.geo.basic.is_identity()) return outer;
    const MachineView& view = x.core.view();
    const AxisValues& zero = x.core.path.work;
    return shift_by(view, zero, -1.0) * x.modal.geo.basic * shift_by(view, zero, 1.0) * outer;
}

AxisValues programmable(const Execution& x, const AxisValues& target) {
    const MachineView& view = x.core.view();
    const Frame& frame = x.modal.geo.exact;
    AxisValues out = target;
    Point3 point{};
    for (unsigned i = 0; i < view.axis_count; ++i)
        out[i] = frame.scale[i] * target[i] + frame.offset[i];
    for (std::size_t k = 0; k < 3; ++k)
        if (const int place = view.axis_by_role(kBasicAxes[k]); place >= 0)
            point[k] = target[static_cast<std::size_t>(place)];
    point = frame.map(point);
    for (std::size_t k = 0; k < 3; ++k)
        if (const int place = view.axis_by_role(kBasicAxes[k]); place >= 0)
            out[static_cast<std::size_t>(place)] = point[k];
    return out;
}

void use_frame(Execution& x) {
    x.run.state_changed = true;
    zeros_change(x, [&x] { x.core.set_frame(outer_frame(x) * x.modal.geo.exact); });
}

bool g_grinding(Execution& x, const GCode& code) {
    x.modal.active[64] = code.number;
    use_frame(x);
    return true;
}

// A zero whose place in the store is `row` is chosen: its other parts come with it.
void choose_settable(Execution& x, int number, std::int32_t row) {
    x.modal.active[8] = static_cast<std::uint8_t>(number + 1);
    zeros_change(x, [&] {
        x.core.select_zero(row);
        if (x.core.path.framed || !x.frames.settable.empty() || !x.modal.geo.basic.is_identity())
            x.core.set_frame(outer_frame(x) * x.modal.geo.exact);
    });
}

// --- $P_UIFR[n], $P_UIFR[n,axis,TR]

// "$P_UIFR[3]", or "$P_IFRAME" for the active one.
bool names_settable(const Execution& x, const std::string& text, int& number) {
    constexpr std::string_view kArray = "$P_UIFR[";
    if (text == "$P_IFRAME") {
        number = static_cast<int>(x.modal.active[8]) - 1;
        return true;
    }
    if (!text.starts_with(kArray) || !text.ends_with(']')) return false;
    const char* const end = text.data() + text.size() - 1;
    const auto [behind, wrong] = std::from_chars(text.data() + kArray.size(), end, number);
    return wrong == std::errc{} && behind == end && number >= 0;
}

// The frame is put so into a settable one that the whole chain is what it was with the frame behind
// it; an active one acts at once.
bool add_to_settable(Execution& x, int number, const Frame& added) {
    const bool acts = number == static_cast<int>(x.modal.active[8]) - 1;
    const auto row = row_of(number);
    if (acts && row) {  // when it is taken back the store is as it was already
        undo(x,
             [&x, number, place = static_cast<std::int32_t>(*row), pending = x.modal.pending_zero] {
                 choose_settable(x, number, place);
                 x.modal.pending_zero = pending;
             });
    }
    Frame inner = x.modal.geo.exact;
    if (const auto own = x.frames.grinding.find(static_cast<int>(x.modal.active[64]) - 1);
        own != x.frames.grinding.end())
        inner = frame_of(x, own->second) * inner;
    const FrameValue had = settable_frame(x, number);
    FrameValue value = components_of(x, frame_of(x, had) * inner * added * inner.inverse(), had);
    for (std::size_t i = 0; i < value.fine_mm.size(); ++i) {
        value.coarse_mm[i] += value.fine_mm[i] - had.fine_mm[i];
        value.fine_mm[i] = had.fine_mm[i];
    }
    if (!set_settable_frame(x, number, value)) return false;
    if (acts && row) choose_settable(x, number, static_cast<std::int32_t>(*row));
    return true;
}

// Whole, or one component: indices from `first` on are axis and part.
bool frame_component(Execution& x, const std::string& name, const FrameValue& frame,
                     const std::vector<Value>& indices, std::size_t first, Value& value) {
    if (indices.size() == first) {
        value = Value::of_frame(frame);
        return true;
    }
    std::size_t place = 0;
    std::string part;
    if (!component_named(x, name, indices, first, place, part)) return false;
    if (part == "MI") {
        value = Value::of_bool(frame.mirrored >> place & 1u);
        return true;
    }
    bool good = false;
    FrameValue copy = frame;
    double number = frame_part(copy, place, part, good);
    if (!good) return fail(x, Alarm::ArrayIndexIllegal, part);
    if (part == "SC" && number == 0) number = 1.0;
    if ((part == "TR" || part == "FI") && !x.core.view().axes[place].rotary) number /= unit(x);
    value = Value::of_real(number);
    return true;
}

bool change_frame_component(Execution& x, const std::string& name, FrameValue& frame,
                            const std::vector<Value>& indices, std::size_t first,
                            const Value& value) {
    if (indices.size() == first) {
        if (value.type != Type::Frame) return fail(x, Alarm::ConversionImpossible, name);
        frame = value.frame ? *value.frame : FrameValue{};
        return true;
    }
    std::size_t place = 0;
    std::string part;
    if (!component_named(x, name, indices, first, place, part)) return false;
    if (!value.is_number()) return fail(x, Alarm::ConversionImpossible, name);
    if (part == "MI") {
        frame.mirrored =
            value.is_true() ? frame.mirrored | 1u << place : frame.mirrored & ~(1u << place);
        return true;
    }
    bool good = false;
    double& cell = frame_part(frame, place, part, good);
    if (!good) return fail(x, Alarm::ArrayIndexIllegal, part);
    if (part == "SC" && value.number == 0) return fail(x, Alarm::FrameFactorIllegal, {}, 0.0);
    const bool length = (part == "TR" || part == "FI") && !x.core.view().axes[place].rotary;
    cell = value.number * (length ? unit(x) : 1.0);
    return true;
}

// $P_UIFR, $P_IFRAME (the active one), $P_GFR, $P_GFRAME (the active one), $P_ACTBFRAME and the
// basic frames.
bool outer_frame_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                       Value& value, bool& known) {
    known = true;
    int number = 0;
    if (name == "$P_UIFR")
        return frame_number(x, name, indices, x.settings.frames - 1, number) &&
               frame_component(x, name, settable_frame(x, number), indices, 1, value);
    if (name == "$P_IFRAME")
        return frame_component(x, name, settable_frame(x, static_cast<int>(x.modal.active[8]) - 1),
                               indices, 0, value);
    if (name == "$P_GFR")
        return frame_number(x, name, indices, 100, number) &&
               frame_component(x, name, x.frames.grinding[number], indices, 1, value);
    if (name == "$P_GFRAME")
        return frame_component(x, name, x.frames.grinding[static_cast<int>(x.modal.active[64]) - 1],
                               indices, 0, value);
    if (is_basic(name))
        return frame_component(x, name, x.modal.geo.basic_value, indices,
                               name == "$P_CHBFRAME" ? 1 : 0, value);
    known = false;
    return true;
}

bool write_outer_frame(Execution& x, const std::string& name, const std::vector<Value>& indices,
                       const Value& value, bool& known) {
    known = true;
    int number = 0;
    if (name == "$P_UIFR") {  // acts with the next G54 .. G599
        if (!frame_number(x, name, indices, x.settings.frames - 1, number)) return false;
        FrameValue frame = settable_frame(x, number);
        return change_frame_component(x, name, frame, indices, 1, value) &&
               set_settable_frame(x, number, frame);
    }
    if (name == "$P_GFR") {
        if (!frame_number(x, name, indices, 100, number)) return false;
        if (number == 0) return fail(x, Alarm::SystemVariableReadOnly, "$P_GFR[0]");
        FrameValue frame = x.frames.grinding[number];
        if (!change_frame_component(x, name, frame, indices, 1, value)) return false;
        undo(x, [&x, number, before = x.frames.grinding[number]] {
            x.frames.grinding[number] = before;
        });
        x.frames.grinding[number] = frame;
        return true;
    }
    if (is_basic(name)) {
        FrameValue frame = x.modal.geo.basic_value;
        if (!change_frame_component(x, name, frame, indices, name == "$P_CHBFRAME" ? 1 : 0, value))
            return false;
        if (!frame_of(x, frame).invertible()) return fail(x, Alarm::FrameFactorIllegal, {}, 0.0);
        undo(x, [&x, value = x.modal.geo.basic_value, exact = x.modal.geo.basic] {
            x.modal.geo.basic_value = value;
            x.modal.geo.basic = exact;
            x.core.set_frame(outer_frame(x) * x.modal.geo.exact);
        });
        x.modal.geo.basic_value = frame;
        x.modal.geo.basic = frame_of(x, frame);
        use_frame(x);
        return true;
    }
    known = false;
    return true;
}

void tell_written_zeros(Execution& x) {
    for (const WrittenZero& one : x.frames.written) {
        const std::string name = one.number == 0  ? "G500"
                                 : one.number < 5 ? "G" + std::to_string(53 + one.number)
                                                  : "G" + std::to_string(500 + one.number);
        OffsetWrite told;
        told.table = "work";
        told.axis = x.core.view().axes[one.place].name;
        told.zero_name = name;
        told.number = one.number;
        told.store_table = OffsetTable::Work;
        told.work = true;
        told.row = one.row;
        told.place = static_cast<std::int32_t>(one.place);
        told.value = one.value;
        x.core.mark_emitted();
        x.core.sink().offset(told, x.core.at);
    }
    x.frames.written.clear();
}

}  // namespace polyturn::channels::sinumerik
