#include "channels/state/core.hpp"

#include <cmath>

#include "channels/compensation/compensator.hpp"  // complete here, for the unique_ptr
#include "channels/pipeline/factor_sink.hpp"      // likewise
#include "channels/pipeline/inclined_sink.hpp"
#include "channels/pipeline/route_sink.hpp"
#include "channels/pipeline/transform_sink.hpp"
#include "channels/state/tip_control.hpp"

namespace polyturn::channels {

Core::Core(MachineView& view, Sink& sink, Port& port)
    : view_(&view), sink_(&sink), out_(&sink), outermost_(&sink), port_(&port) {
    path.spindle.spindle = view.config().default_spindle;
    geo_ = {view.axis_by_role(PlaneRole::BasicX), view.axis_by_role(PlaneRole::BasicY),
            view.axis_by_role(PlaneRole::BasicZ)};
}

bool Core::fail(Alarm alarm, char letter, std::string detail, double v0, double v1) {
    fault_ = {alarm, letter, v0, v1, std::move(detail), {}, 0, 0};
    return false;
}

bool Core::program_alarm(const std::string& text, double number) {
    if (port_->program_alarm_is_sure()) return fail(Alarm::MacroAlarm, 0, text, number);
    sink_->alarm({Alarm::ProgramAlarmUnsure, {{}, at.line, 0, 0}, {number, 0.0}, text}, at);
    return true;
}

void Core::start_at_machine(const AxisValues& machine) {
    for (unsigned i = 0; i < view_->axis_count; ++i)
        path.machine[i] = view_->axes[i].from_drive(machine[i]);
    rebase_all();
}

void Core::displaced(const AxisValues& by) {
    for (unsigned i = 0; i < view_->axis_count; ++i)
        path.machine[i] += view_->axes[i].from_drive(by[i]) - view_->axes[i].from_drive(0.0);
    rebase_all();
}

void Core::take_machine(unsigned place, double drive) {
    double machine = view_->axes[place].from_drive(drive);
    if (transforms_) transforms_->axes()[place] = machine;
    if (transformed() && path.transformation.uses(place)) {  // all its roles follow
        AxisValues axes = transforms_->axes();
        places_to_path(path.transformation, axes);
        for (std::size_t r = 0; r < role_count(kind_of(path.transformation.kinematics)); ++r) {
            const unsigned i = path.transformation.kinematics.axis[r];
            if (i == kNoPlace) continue;
            path.machine[i] =
                compensating_ ? axes[i] - (machine_now(i) - path.machine[i]) : axes[i];
            rebase(i);
        }
        return;
    }
    path.machine[place] =
        compensating_ ? machine - (machine_now(place) - path.machine[place]) : machine;
    rebase(place);
}

// An exchange of axes moves nothing: positions are read anew at the same barrier.
void Core::refresh_routes() {
    bool any = false;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        view_->axes[i].mirror_at = path.zero[i];
        any = any || view_->axes[i].turned_round();
    }
    if (any && !routes_) routes_ = std::make_unique<RouteSink>(*outermost_, *view_);
    Sink* out = any ? static_cast<Sink*>(routes_.get()) : outermost_;
    if (transforms_) {
        transforms_->next(*out);
        out = transforms_.get();
    }
    if (factors_) {
        factors_->next(*out);
        out = factors_.get();
    }
    if (out == out_) return;
    // compensation keeps what it has opened; switching codes lie outside of it
    if (sink_ == out_) sink_ = out;
    out_ = out;
}

void Core::refresh_limits() {
    refresh_routes();
    path.second_limits.guard =
        port_->second_limits() ? WorkZone::Guard::NoExit : WorkZone::Guard::Off;
    zones_.count = view_->axis_count;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        ChannelAxis& axis = view_->axes[i];
        StrokeFlags flags = port_->stroke_flags(axis.machine_axis);
        flags.second_off = flags.second_off || path.stroke2_off;
        axis.referenced = port_->axis_referenced(axis.machine_axis);
        zones_.axes[i] =
            axis.stroke.any() ? zone_of(axis.stroke, view_->stroke, flags) : AxisZone{};
        if (axis.by_plc && port_->diameter_inverted(axis.machine_axis) != axis.inverted) {
            axis.inverted = !axis.inverted;
            axis.diameter = !axis.diameter;
        }
        const StrokeInterval& allowed = zones_.axes[i].allowed;
        axis.limited = std::isfinite(allowed.low) && std::isfinite(allowed.high);
        if (axis.limited) {
            axis.limit_max = allowed.high;
            axis.limit_min = allowed.low;
        }
    }
    take_due();
}

// I1 from the machine's side: the axis is at standstill, its programmed number follows.
void Core::rebase(unsigned i) {
    if (path.framed) return rebase_all();
    const ChannelAxis& axis = view_->axes[i];
    double programmed = path.machine[i] - path.zero[i] - path.shift[i] - path.vector[i];
    if (axis.rollover) {
        const double turns = std::floor(programmed / axis.rollover_deg) * axis.rollover_deg;
        path.turns_deg[i] = turns;
        programmed -= turns;
    }
    path.programmed[i] = programmed;
}

AxisValues Core::chain_offset() const {
    AxisValues out{};
    for (unsigned i = 0; i < view_->axis_count; ++i)
        out[i] = path.zero[i] + path.shift[i] + path.vector[i];
    return out;
}

void Core::follow_offsets(const AxisValues& programmed, const AxisValues& before) {
    const AxisValues now = chain_offset();
    for (unsigned i = 0; i < view_->axis_count; ++i) path.machine[i] += now[i] - before[i];
    rebase_all();
    path.programmed = programmed;
    refresh_surface_zero();
}

void Core::sum_zeros() {
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const double before = path.zero[i];
        path.zero[i] = path.external[i] + path.work[i] + path.preset[i] + path.local[i];
        ChannelAxis& axis = view_->axes[i];
        if (!axis.mirrored) continue;
        // the drive stays, its picture on the virtual side does not
        path.machine[i] += 2.0 * (path.zero[i] - before);
        axis.mirror_at = path.zero[i];
    }
    rebase_all();
}

void Core::load_zeros() {
    const auto& zeros = view_->store->zeros;
    const auto row = static_cast<std::size_t>(path.zero_row == kZeroNone ? 0 : path.zero_row);
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const double external =
            zeros[kZeroExternalRow * kChannelAxes + i] + zeros[kZeroShiftRow * kChannelAxes + i];
        path.external[i] = view_->from_table(i, external);
        path.work[i] =
            path.zero_row == kZeroNone ? 0.0 : view_->from_table(i, zeros[row * kChannelAxes + i]);
    }
    sum_zeros();
}

void Core::select_zero(std::int32_t row) {
    path.zero_row = row;
    load_zeros();
    refresh_surface_zero();
}

void Core::preset(unsigned i, double programmed) {
    if (reads_ahead()) drop_compensation_vector();
    // The word is what the display shall show with the travelled offset in it: G50 X Z T
    // (fanuc_lathe 1.4).
    if (path.framed) {
        AxisValues wanted = path.programmed;
        wanted[i] = programmed;
        const AxisValues point = framed(wanted), now = framed_now();
        for (unsigned k = 0; k < view_->axis_count; ++k) path.preset[k] += now[k] - point[k];
        path.preset[i] += path.vector[i];
    } else {
        path.preset[i] +=
            path.machine[i] - path.turns_deg[i] - programmed - path.zero[i] - path.shift[i];
    }
    sum_zeros();
    refresh_surface_zero();
}

void Core::preset_by(unsigned i, double increment) {
    if (reads_ahead()) drop_compensation_vector();
    path.preset[i] -= increment;
    sum_zeros();
    refresh_surface_zero();
}

void Core::local_zero(unsigned i, double value) {
    path.local[i] = value;
    sum_zeros();
    refresh_surface_zero();
}

void Core::hold_zeros_as_preset() {
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        path.preset[i] += path.work[i] + path.local[i];
        path.work[i] = path.local[i] = 0.0;
    }
    path.zero_row = kZeroNone;
    sum_zeros();
}

void Core::clear_preset() {
    path.preset = {};
    sum_zeros();
}

void Core::set_shift(const AxisValues& shift) {
    for (unsigned i = 0; i < view_->axis_count; ++i) path.shift[i] = shift[i];
    if (path.fixture.on) shift_by(path.fixture.now, 1.0);
    rebase_all();
    refresh_surface_zero();
}

void Core::set_wanted(const AxisValues& vector) { path.wanted = vector; }

void Core::take_wanted() {
    path.vector = path.wanted;
    rebase_all();
}

bool Core::vector_pending() const {
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (path.wanted[i] != path.vector[i]) return true;
    return false;
}

bool Core::travel_offset(bool at_rapid) {
    const AxisValues here = path.programmed;
    offset_alone_ = true;
    const bool done = at_rapid ? rapid(here) : linear(here);
    offset_alone_ = false;
    return done;
}

AxisSet Core::plane_axes(int& p, int& q) const {
    static constexpr PlaneRole kRoles[3][2] = {{PlaneRole::BasicX, PlaneRole::BasicY},
                                               {PlaneRole::BasicZ, PlaneRole::BasicX},
                                               {PlaneRole::BasicY, PlaneRole::BasicZ}};
    const auto& roles = kRoles[static_cast<std::size_t>(path.plane)];
    const auto of_role = [this](PlaneRole role) {
        const int virtual_y = path.transformation.virtual_y;
        return role == PlaneRole::BasicY && virtual_y >= 0 ? virtual_y : view_->axis_by_role(role);
    };
    p = path.plane_p >= 0 ? path.plane_p : of_role(roles[0]);
    q = path.plane_q >= 0 ? path.plane_q : of_role(roles[1]);
    AxisSet set = 0;
    if (p >= 0) set |= 1u << p;
    if (q >= 0) set |= 1u << q;
    return set;
}

bool Core::dwell(double value, bool revolutions, std::string_view until) {
    emitted_ = true;
    path.after_thread = false;
    sink_->dwell({revolutions, value, path.spindle.spindle, until, rest_of_dwell}, at);
    rest_of_dwell = false;
    return true;
}

void Core::aux(char letter, double value, std::string_view text, bool drained, bool silent,
               ToolCallBy by, std::string_view name) {
    emitted_ = true;
    sink_->aux({.letter = letter,
                .value = value,
                .text = text,
                .drained = drained,
                .silent = silent,
                .by = by,
                .name = name},
               at);
}

}  // namespace polyturn::channels
