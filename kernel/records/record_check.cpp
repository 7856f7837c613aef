#include "kernel/records/record_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ipc/image/balance.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/image/positioning_step.hpp"
#include "ipc/image/program_start.hpp"
#include "kernel/axes/couplings.hpp"

namespace polyturn::kernel {
namespace {
constexpr auto kLastKind = static_cast<std::uint8_t>(RecordKind::LifeGroup);
// mm, degrees: geometry against the points that a record says
constexpr double kOnCurve = 1e-3;
constexpr double kMostInteger = 2'147'483'647.0;
constexpr std::uint32_t kChannelBits = (1u << kMaxChannels) - 1u;

// not for NaN either
bool sane(double value) noexcept { return std::fabs(value) <= RecordCheck::kFarthest; }
bool sane_or_none(double value) noexcept { return std::isnan(value) || sane(value); }
bool ceiling(double value) noexcept { return value > 0; }  // infinity: no axis limits it
bool integer(double value) noexcept { return std::fabs(value) <= kMostInteger; }
bool real_spindle(const PathRecord& r) noexcept { return r.spindle <= kMaxSpindles; }

// An axis of a channel by its parameters, by an exchange of drives, or one that several channels
// command (fanuc F8250 = 3).
bool is_of(const Core& core, std::size_t axis, unsigned channel) noexcept {
    const std::uint32_t home = core.config.axes[axis].channel;
    if (home == channel + 1) return true;
    const ShortName& name = core.config.axes[axis].name;
    if (home != 0 && name[0] == 'B' && name[1] == 0 &&
        params::get(core.table, params::f8250, home) == 3)
        return true;
    if (!core.couplings) return false;
    const std::uint32_t address = core.couplings->route(axis);  // both of an exchange have one
    return address != 0 && address <= kMaxAxes &&
           core.config.axes[address - 1].channel == channel + 1;
}

const char* spindle_mode(const PathRecord& r, const Core& core, unsigned channel) noexcept {
    const auto mode = static_cast<SpindleModeCode>(r.code);
    if (mode < SpindleModeCode::Rpm || mode > SpindleModeCode::Uncouple) return "code";
    if (!real_spindle(r)) return "spindle";
    if (!sane_or_none(r.value)) return "value";
    for (std::size_t i = 0; i < 4; ++i)
        if (!sane_or_none(r.shape[i])) return "shape";
    if (!sane(r.feed)) return "feed";
    if (mode == SpindleModeCode::SurfaceSpeed && r.axis[0] >= kMaxAxes) return "axis";
    if (mode == SpindleModeCode::Position &&
        r.plane[0] > static_cast<std::uint8_t>(SpindleApproach::Incremental))
        return "plane";
    const bool couples = mode == SpindleModeCode::Couple || mode == SpindleModeCode::Uncouple;
    if (couples && (r.axis[0] < kMaxAxes ? !is_of(core, r.axis[0], channel)
                                         : r.axis[0] >= kMaxAxes + kMaxSpindles))
        return "axis";
    if (mode == SpindleModeCode::Couple &&
        ((r.axis[1] >= kMaxAxes && r.axis[1] != kNoHelix) || r.spindle == 0))
        return "axis";
    return nullptr;
}

const char* flag(const PathRecord& r) noexcept {
    if (!sane(r.value) && r.code != kFlagOutputs && r.code != kFlagOutputsWide) return "value";
    switch (r.code) {
        case kFlagControl:
        case kFlagOutputs:
            return r.value >= 0 && r.value <= 4'294'967'295.0 ? nullptr : "value";
        case kFlagOutputsWide:
            return integer(r.value) ? nullptr : "value";
        case kFlagBalance:
            return r.value >= 0 && r.value <= static_cast<double>(kMaxChannels) ? nullptr : "value";
        case kFlagStart:
            return (r.mask & ~kChannelBits) == 0 ? nullptr : "mask";
        default:
            return nullptr;
    }
}

// What the store is asked for: within its tables.
const char* store_write(const PathRecord& r) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Variable:
            return r.mask <= kMaxChannels && (std::isnan(r.value) || std::isfinite(r.value))
                       ? nullptr
                       : "value";
        case RecordKind::Offset: {
            const bool work = static_cast<OffsetTable>(r.code) == OffsetTable::Work;
            if (r.code < 0 || r.code > static_cast<std::int32_t>(OffsetTable::Work)) return "code";
            if (r.mask >= (work ? kWorkZeros : kOffsets)) return "mask";
            if (r.plane[0] >= (work ? kChannelAxes : std::size_t{5})) return "plane";
            if (!work && r.plane[1] > kMaxChannels) return "plane";
            return std::isfinite(r.value) ? nullptr : "value";
        }
        case RecordKind::ToolData:
            return r.mask > 1'000'000'000u || r.code < 0 || r.code > 10'000 ? "code"
                   : std::isfinite(r.value)                                 ? nullptr
                                                                            : "value";
        case RecordKind::LifeGroup:
            if (r.code < 0 || r.code > static_cast<std::int32_t>(LifeGroupStep::Tool))
                return "code";
            if (r.plane[0] > static_cast<std::uint8_t>(LifeKind::Wear)) return "plane";
            return r.mask <= 1'000'000'000u && std::isfinite(r.value) ? nullptr : "value";
        default:
            return nullptr;
    }
}

const char* beside(const PathRecord& r, const Core& core, unsigned channel) noexcept {
    if (r.code < 0 || r.code > static_cast<std::int32_t>(PositioningStep::MoveBy)) return "code";
    if (r.axis_count > 1 ||
        (r.axis_count == 1 && (r.axis[0] >= kMaxAxes || !is_of(core, r.axis[0], channel))))
        return "axis";
    if (!real_spindle(r)) return "spindle";
    if (!sane(r.end[0])) return "end";
    if (!sane(r.feed) || r.feed < 0) return "feed";
    if (!sane(r.v_max) || r.v_max < 0) return "v_max";
    return integer(r.value) ? nullptr : "value";
}

// The records that are no motion, and what is used of them.
const char* event(const PathRecord& r, const Core& core, unsigned channel) noexcept {
    switch (static_cast<RecordKind>(r.kind)) {
        case RecordKind::Dwell:
            if (!real_spindle(r)) return "spindle";
            if (!sane(r.value)) return "value";
            return sane(r.feed) ? nullptr : "feed";
        case RecordKind::Aux:
            if (r.code < 'A' || r.code > 'Z') return "code";
            return integer(r.value) ? nullptr : "value";
        case RecordKind::SpindleMode:
            return spindle_mode(r, core, channel);
        case RecordKind::SpindleSpeed:
            return !real_spindle(r)                    ? "spindle"
                   : sane(r.value) && sane(r.shape[0]) ? nullptr
                                                       : "value";
        case RecordKind::Wait:
            return (r.mask & ~kChannelBits) == 0 ? nullptr : "mask";
        case RecordKind::Variable:
        case RecordKind::Offset:
        case RecordKind::ToolData:
        case RecordKind::LifeGroup:
            return store_write(r);
        case RecordKind::Stop:
            return r.code >= 0 && r.code <= static_cast<std::int32_t>(StopReason::Dialogue)
                       ? nullptr
                       : "code";
        case RecordKind::Part:
            return sane(r.value) ? nullptr : "value";
        case RecordKind::Flag:
            return flag(r);
        case RecordKind::PositioningAxis:
            return beside(r, core, channel);
        case RecordKind::Torque:
            if (r.axis_count > 1 ||
                (r.axis_count == 1 && (r.axis[0] >= kMaxAxes || !is_of(core, r.axis[0], channel))))
                return "axis";
            return sane(r.value) && sane(r.shape[0]) ? nullptr : "value";
        case RecordKind::Await:
        case RecordKind::Home:
            for (std::size_t i = 0; i < r.axis_count; ++i)
                if (r.axis[i] < kMaxAxes ? !is_of(core, r.axis[i], channel)
                                         : r.axis[i] >= kMaxAxes + kMaxSpindles)
                    return "axis";
            return nullptr;
        default:
            return nullptr;
    }
}

bool all_sane(const double* from, std::size_t count) noexcept {
    return std::all_of(from, from + count, sane);
}

const char* shape_of(const PathRecord& r) noexcept {
    if (static_cast<RecordKind>(r.kind) == RecordKind::Arc) {
        if (r.plane[0] >= r.axis_count || r.plane[1] >= r.axis_count || r.plane[0] == r.plane[1])
            return "plane";
        if (!all_sane(&r.shape[0], 6)) return "shape";
    } else if (static_cast<RecordKind>(r.kind) == RecordKind::Curve) {
        if (r.axis_count > kMaxCurveAxes) return "axis_count";
        for (std::size_t n = 0; n < 6 * std::size_t{r.axis_count}; ++n)
            if (!std::isfinite(r.shape[n])) return "shape";
    } else {
        return nullptr;
    }
    for (std::size_t n = curve_shape::kParameter; n < curve_shape::kParameter + 6; ++n)
        if (!std::isfinite(r.shape[n])) return "shape";
    return nullptr;
}

// At both ends the geometry leads to the points: it is driven from within.
const char* meets_points(const PathRecord& r) noexcept {
    if (static_cast<RecordKind>(r.kind) == RecordKind::Line) return nullptr;
    SlotVector first{}, last{};
    position_at(r, r.length * 1e-9, first);
    position_at(r, r.length * (1 - 1e-9), last);
    for (std::size_t i = 0; i < r.axis_count; ++i) {
        if (!(std::fabs(first[i] - r.start[i]) <= kOnCurve)) return "start";
        if (!(std::fabs(last[i] - r.end[i]) <= kOnCurve)) return "end";
    }
    return nullptr;
}
}  // namespace

bool RecordCheck::sound(const Kinematics& k) noexcept {
    if (k.kind == 0 || k.kind > static_cast<std::uint32_t>(KinematicsKind::FiveAxis)) return false;
    const std::size_t roles = role_count(kind_of(k));
    for (std::size_t i = 0; i < roles; ++i)
        if (k.axis[i] >= kMaxAxes || !sane(k.centre[i]) || std::fabs(k.sign[i]) != 1.0 ||
            !sane(k.shift[i]))
            return false;
    if (!std::all_of(k.centre.begin(), k.centre.end(), sane) ||
        !std::all_of(k.value.begin(), k.value.end(), [](double v) { return std::isfinite(v); }))
        return false;
    if (kind_of(k) == KinematicsKind::Cylinder && !(std::fabs(k.value[0]) > 1e-6)) return false;
    return kind_of(k) != KinematicsKind::Inclined || std::fabs(std::cos(k.value[0])) > 1e-3;
}

const char* RecordCheck::motion(const PathRecord& r, const Kinematics* k, const Core& core,
                                unsigned channel) noexcept {
    const bool taps = (r.flags & kTapping) != 0;
    if (r.axis_count > kMaxPathAxes - (taps ? 1u : 0u)) return "axis_count";
    for (std::size_t i = 0; i < r.axis_count; ++i) {
        const std::size_t a = r.axis[i];
        if (a >= kMaxAxes || !is_of(core, a, channel)) return "axis";
        for (std::size_t n = 0; n < i; ++n)
            if (r.axis[n] == a) return "axis";
    }
    if (taps &&
        (r.axis[r.axis_count] < kMaxAxes || r.axis[r.axis_count] >= kMaxAxes + kMaxSpindles))
        return "axis";
    if (!real_spindle(r)) return "spindle";
    if (r.feed_mode > static_cast<std::uint8_t>(FeedMode::Revolutions)) return "feed_mode";
    if (!all_sane(r.start.data(), r.axis_count)) return "start";
    if (!all_sane(r.end.data(), r.axis_count + (taps ? 1u : 0u))) return "end";
    if (!sane(r.length) || r.length < 0) return "length";
    if (!sane(r.feed) || r.feed < 0) return "feed";
    if (r.length > 0 && !ceiling(r.v_max)) return "v_max";
    if (r.length > 0 && !ceiling(r.a_max)) return "a_max";
    if (r.length > 0 && !ceiling(r.j_max)) return "j_max";
    for (const double bend : {r.bend, r.bend_turning, r.bend_along, r.bend_across})
        if (!std::isfinite(bend) || bend < 0) return "bend";
    if ((r.flags & kThread) && (!sane(r.lead) || !sane(r.lead_change) || !sane(r.start_angle) ||
                                !all_sane(r.retract.data(), r.retract.size())))
        return "lead";
    if (!sane(r.value)) return "value";
    if (r.transform > kKinematics || (r.transform != 0 && !k)) return "transform";
    if (r.side > static_cast<std::uint8_t>(SideOfPole::Through)) return "side";
    if (r.transform != 0 && !sane(r.turn)) return "turn";
    if (const char* const field = shape_of(r)) return field;
    if (!(r.length > 0))
        for (std::size_t i = 0; i < r.axis_count; ++i)
            if (!(std::fabs(r.end[i] - r.start[i]) <= kSame)) return "length";
    if (r.length > 0)
        if (const char* const field = meets_points(r)) return field;
    if (has_end_ && r.transform == transform_)
        for (std::size_t i = 0; i < r.axis_count; ++i)
            for (std::size_t n = 0; n < axis_count_; ++n)
                if (axis_[n] == r.axis[i] && !(std::fabs(end_[n] - r.start[i]) <= kSame))
                    return "start";
    return nullptr;
}

void RecordCheck::keep_end(const PathRecord& r) noexcept {
    has_end_ = (r.flags & (kSkipMove | kFixedStop)) == 0;
    axis_count_ = r.axis_count;
    transform_ = r.transform;
    axis_ = r.axis;
    end_ = r.end;
}

const char* RecordCheck::fault_of(const PathRecord& r, const Kinematics* k, const Core& core,
                                  unsigned channel) noexcept {
    if (r.kind == 0 || r.kind > kLastKind) return "kind";
    if (r.axis_count > kMaxPathAxes) return "axis_count";
    if (r.text.back() != 0) return "text";
    const bool moves = r.kind <= static_cast<std::uint8_t>(RecordKind::Curve);
    const char* const field = moves ? motion(r, k, core, channel) : event(r, core, channel);
    if (field) return field;
    if (moves)
        keep_end(r);
    else if (r.flags & kDrains)
        has_end_ = false;  // the channel has read its axes' positions
    else
        switch (static_cast<RecordKind>(r.kind)) {
            case RecordKind::PositioningAxis:
            case RecordKind::Await:
            case RecordKind::Home:
            case RecordKind::Torque:
            case RecordKind::Stop:
            // axes are moved asynchronously
            case RecordKind::SpindleMode:
                has_end_ = false;
                break;
            default:
                break;
        }
    return nullptr;
}

}  // namespace polyturn::kernel
