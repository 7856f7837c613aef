// Frames around the programmable one: settable ($P_UIFR), grinding ($P_GFR) and basic frames
// (sinumerik_part1 2.4, part 2 13).
//
//   workpiece -- programmable -- grinding -- settable -- basic --> machine
//
// The shift of a settable frame lies in the store, where operators enter it, and acts as Core's
// zero. What else a program gives a frame (fine shift, rotation, scale, mirror) it keeps for its
// own run.
#include <charconv>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"

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

}  // namespace

// What lies between the programmable frame and Core's zero.
Frame Interpreter::outer_frame() const {
    Frame outer;
    const auto found = settable_parts_.find(static_cast<int>(modal_.active[8]) - 1);
    if (found != settable_parts_.end()) outer = frame_of(found->second);
    if (const auto own = grinding_frames_.find(static_cast<int>(modal_.active[64]) - 1);
        own != grinding_frames_.end())
        outer = outer * frame_of(own->second);
    if (modal_.geo.basic.is_identity()) return outer;
    const MachineView& view = core_.view();
    const AxisValues& zero = core_.path.work;
    return shift_by(view, zero, -1.0) * modal_.geo.basic * shift_by(view, zero, 1.0) * outer;
}

AxisValues Interpreter::programmable(const AxisValues& target) const {
    const MachineView& view = core_.view();
    const Frame& frame = modal_.geo.exact;
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

void Interpreter::use_frame() {
    state_changed_ = true;
    zeros_change([this] { core_.set_frame(outer_frame() * modal_.geo.exact); });
}

bool Interpreter::g_grinding(const GCode& code) {
    modal_.active[64] = code.number;
    use_frame();
    return true;
}

// A zero whose place in the store is `row` is chosen: its other parts come with it.
void Interpreter::choose_settable(int number, std::int32_t row) {
    modal_.active[8] = static_cast<std::uint8_t>(number + 1);
    zeros_change([&] {
        core_.select_zero(row);
        if (core_.path.framed || !settable_parts_.empty() || !modal_.geo.basic.is_identity())
            core_.set_frame(outer_frame() * modal_.geo.exact);
    });
}

// --- $P_UIFR[n], $P_UIFR[n,axis,TR]

FrameValue Interpreter::settable_frame(int number) {
    FrameValue value;
    if (const auto found = settable_parts_.find(number); found != settable_parts_.end())
        value = found->second;
    if (const auto row = row_of(number))
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            value.coarse_mm[i] =
                core_.view().from_shown(i, core_.view().store->zeros[*row * kChannelAxes + i]);
    return value;
}

bool Interpreter::set_settable_frame(int number, const FrameValue& value) {
    const auto row = row_of(number);
    if (!row) return fail(Alarm::ArrayIndexIllegal, "$P_UIFR", number);
    FrameValue parts = value;
    parts.coarse_mm = {};
    if (!frame_of(parts).invertible()) return fail(Alarm::FrameFactorIllegal, {}, 0.0);
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        double& cell = core_.view().store->zeros[*row * kChannelAxes + i];
        const double shown = core_.view().to_shown(i, value.coarse_mm[i]);
        if (cell == shown) continue;
        undo([at = &cell, before = cell] { *at = before; });
        cell = shown;
        written_zeros_.push_back({number, static_cast<std::int32_t>(*row), i, shown});
    }
    const auto before = settable_parts_.find(number);
    undo([this, number, had = before != settable_parts_.end(),
          old = before != settable_parts_.end() ? before->second : FrameValue{}] {
        if (had)
            settable_parts_[number] = old;
        else
            settable_parts_.erase(number);
    });
    const bool plain = frame_of(parts).is_identity();
    if (plain)
        settable_parts_.erase(number);
    else
        settable_parts_[number] = parts;
    return true;
}

// "$P_UIFR[3]", or "$P_IFRAME" for the active one.
bool Interpreter::names_settable(const std::string& text, int& number) const {
    constexpr std::string_view kArray = "$P_UIFR[";
    if (text == "$P_IFRAME") {
        number = static_cast<int>(modal_.active[8]) - 1;
        return true;
    }
    if (!text.starts_with(kArray) || !text.ends_with(']')) return false;
    const char* const end = text.data() + text.size() - 1;
    const auto [behind, wrong] = std::from_chars(text.data() + kArray.size(), end, number);
    return wrong == std::errc{} && behind == end && number >= 0;
}

// The frame is put so into a settable one that the whole chain is what it was with the frame behind
// it; an active one acts at once.
bool Interpreter::add_to_settable(int number, const Frame& added) {
    const bool acts = number == static_cast<int>(modal_.active[8]) - 1;
    const auto row = row_of(number);
    if (acts && row) {  // when it is taken back the store is as it was already
        undo(
            [this, number, place = static_cast<std::int32_t>(*row), pending = modal_.pending_zero] {
                choose_settable(number, place);
                modal_.pending_zero = pending;
            });
    }
    Frame inner = modal_.geo.exact;
    if (const auto own = grinding_frames_.find(static_cast<int>(modal_.active[64]) - 1);
        own != grinding_frames_.end())
        inner = frame_of(own->second) * inner;
    const FrameValue had = settable_frame(number);
    FrameValue value = components_of(frame_of(had) * inner * added * inner.inverse(), had);
    for (std::size_t i = 0; i < value.fine_mm.size(); ++i) {
        value.coarse_mm[i] += value.fine_mm[i] - had.fine_mm[i];
        value.fine_mm[i] = had.fine_mm[i];
    }
    if (!set_settable_frame(number, value)) return false;
    if (acts && row) choose_settable(number, static_cast<std::int32_t>(*row));
    return true;
}

// The number of the frame that the first index names.
bool Interpreter::frame_number(const std::string& name, const std::vector<Value>& indices, int most,
                               int& number) {
    const double n = indices.empty() || !indices[0].is_number() ? -1 : indices[0].number;
    if (!(n >= 0 && n <= most) || n != std::floor(n))
        return fail(Alarm::ArrayIndexIllegal, name, n);
    number = static_cast<int>(n);
    return true;
}

// Whole, or one component: indices from `first` on are axis and part.
bool Interpreter::frame_component(const std::string& name, const FrameValue& frame,
                                  const std::vector<Value>& indices, std::size_t first,
                                  Value& value) {
    if (indices.size() == first) {
        value = Value::of_frame(frame);
        return true;
    }
    std::size_t place = 0;
    std::string part;
    if (!component_named(name, indices, first, place, part)) return false;
    if (part == "MI") {
        value = Value::of_bool(frame.mirrored >> place & 1u);
        return true;
    }
    bool good = false;
    FrameValue copy = frame;
    double number = frame_part(copy, place, part, good);
    if (!good) return fail(Alarm::ArrayIndexIllegal, part);
    if (part == "SC" && number == 0) number = 1.0;
    if ((part == "TR" || part == "FI") && !core_.view().axes[place].rotary) number /= unit();
    value = Value::of_real(number);
    return true;
}

bool Interpreter::change_frame_component(const std::string& name, FrameValue& frame,
                                         const std::vector<Value>& indices, std::size_t first,
                                         const Value& value) {
    if (indices.size() == first) {
        if (value.type != Type::Frame) return fail(Alarm::ConversionImpossible, name);
        frame = value.frame ? *value.frame : FrameValue{};
        return true;
    }
    std::size_t place = 0;
    std::string part;
    if (!component_named(name, indices, first, place, part)) return false;
    if (!value.is_number()) return fail(Alarm::ConversionImpossible, name);
    if (part == "MI") {
        frame.mirrored =
            value.is_true() ? frame.mirrored | 1u << place : frame.mirrored & ~(1u << place);
        return true;
    }
    bool good = false;
    double& cell = frame_part(frame, place, part, good);
    if (!good) return fail(Alarm::ArrayIndexIllegal, part);
    if (part == "SC" && value.number == 0) return fail(Alarm::FrameFactorIllegal, {}, 0.0);
    const bool length = (part == "TR" || part == "FI") && !core_.view().axes[place].rotary;
    cell = value.number * (length ? unit() : 1.0);
    return true;
}

bool Interpreter::component_named(const std::string& name, const std::vector<Value>& indices,
                                  std::size_t first, std::size_t& place, std::string& part) {
    if (indices.size() != first + 2) return fail(Alarm::ArrayIndexMissing, name);
    const int axis = indices[first].type == Type::Axis ? indices[first].place() : -1;
    part = upper(indices[first + 1].text);
    if (indices[first].type == Type::Axis && axis <= kAbsentAxis) {  // frame_part()
        if (part != "RT") return fail(Alarm::AxisArgumentMissing, name);
        place = kChannelAxes + static_cast<std::size_t>(kAbsentAxis - axis);
        return true;
    }
    if (axis < 0 || axis >= static_cast<int>(core_.view().axis_count))
        return fail(Alarm::AxisArgumentMissing, name);
    place = static_cast<std::size_t>(axis);
    return true;
}

// $P_UIFR, $P_IFRAME (the active one), $P_GFR, $P_GFRAME (the active one), $P_ACTBFRAME and the
// basic frames.
bool Interpreter::outer_frame_value(const std::string& name, const std::vector<Value>& indices,
                                    Value& value, bool& known) {
    known = true;
    int number = 0;
    if (name == "$P_UIFR")
        return frame_number(name, indices, settings_.frames - 1, number) &&
               frame_component(name, settable_frame(number), indices, 1, value);
    if (name == "$P_IFRAME")
        return frame_component(name, settable_frame(static_cast<int>(modal_.active[8]) - 1),
                               indices, 0, value);
    if (name == "$P_GFR")
        return frame_number(name, indices, 100, number) &&
               frame_component(name, grinding_frames_[number], indices, 1, value);
    if (name == "$P_GFRAME")
        return frame_component(name, grinding_frames_[static_cast<int>(modal_.active[64]) - 1],
                               indices, 0, value);
    if (is_basic(name))
        return frame_component(name, modal_.geo.basic_value, indices, name == "$P_CHBFRAME" ? 1 : 0,
                               value);
    known = false;
    return true;
}

bool Interpreter::write_outer_frame(const std::string& name, const std::vector<Value>& indices,
                                    const Value& value, bool& known) {
    known = true;
    int number = 0;
    if (name == "$P_UIFR") {  // acts with the next G54 .. G599
        if (!frame_number(name, indices, settings_.frames - 1, number)) return false;
        FrameValue frame = settable_frame(number);
        return change_frame_component(name, frame, indices, 1, value) &&
               set_settable_frame(number, frame);
    }
    if (name == "$P_GFR") {
        if (!frame_number(name, indices, 100, number)) return false;
        if (number == 0) return fail(Alarm::SystemVariableReadOnly, "$P_GFR[0]");
        FrameValue frame = grinding_frames_[number];
        if (!change_frame_component(name, frame, indices, 1, value)) return false;
        undo([this, number, before = grinding_frames_[number]] {
            grinding_frames_[number] = before;
        });
        grinding_frames_[number] = frame;
        return true;
    }
    if (is_basic(name)) {
        FrameValue frame = modal_.geo.basic_value;
        if (!change_frame_component(name, frame, indices, name == "$P_CHBFRAME" ? 1 : 0, value))
            return false;
        if (!frame_of(frame).invertible()) return fail(Alarm::FrameFactorIllegal, {}, 0.0);
        undo([this, value = modal_.geo.basic_value, exact = modal_.geo.basic] {
            modal_.geo.basic_value = value;
            modal_.geo.basic = exact;
            core_.set_frame(outer_frame() * modal_.geo.exact);
        });
        modal_.geo.basic_value = frame;
        modal_.geo.basic = frame_of(frame);
        use_frame();
        return true;
    }
    known = false;
    return true;
}

void Interpreter::tell_written_zeros() {
    for (const WrittenZero& one : written_zeros_) {
        const std::string name = one.number == 0  ? "G500"
                                 : one.number < 5 ? "G" + std::to_string(53 + one.number)
                                                  : "G" + std::to_string(500 + one.number);
        OffsetWrite told;
        told.table = "work";
        told.axis = core_.view().axes[one.place].name;
        told.zero_name = name;
        told.number = one.number;
        told.store_table = OffsetTable::Work;
        told.work = true;
        told.row = one.row;
        told.place = static_cast<std::int32_t>(one.place);
        told.value = one.value;
        core_.mark_emitted();
        core_.sink().offset(told, core_.at);
    }
    written_zeros_.clear();
}

}  // namespace polyturn::channels::sinumerik
