#include "channels/fagor/variables/states.hpp"

#include <algorithm>
#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {
namespace {

bool g_active(const Execution& x, unsigned n) {
    const Modal& m = x.modal;
    if (n <= 3 || n == 33 || n == 34) return m.motion == n;
    if (n == 5 || n == 7 || n == 50 || n == 51) return m.corner == n;
    if (n == 10) return m.mirrored == 0;
    if (n >= 11 && n <= 13) {
        static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY,
                                               PlaneRole::BasicZ};
        const int place = x.core.view().axis_by_role(kRoles[n - 11]);
        return place >= 0 && (m.mirrored >> place & 1u);
    }
    if (n == 14) return m.mirrored != 0;
    if (n >= 16 && n <= 19) return m.plane == n;
    if (n == 32 || n == 94 || n == 95) return m.feed_code == n;
    if (n >= 40 && n <= 42) return m.comp == n;
    if (n == 46) return m.inclined != 0;
    if (n == 53) return m.zero == 0;
    if (n >= 54 && n <= 57) return m.zero == n;
    if (n == 58 || n == 59) return m.zero_added == n;
    if (n == 70 || n == 71) return m.inch == (n == 70);
    if (n == 72) {
        for (const double factor : m.axis_scale)
            if (factor != 0.0 && factor != 1.0) return true;
        return m.scale != 1.0;
    }
    if (n == 90 || n == 91) return m.absolute == (n == 90);
    if (n == 92) return m.zero == 92;
    if (n == 96 || n == 97)
        return (x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed) == (n == 96);
    if (n == 151 || n == 152) return m.diameter == (n == 151);
    if (n == 159) return m.zero == 159;
    return n == 233 && m.withdraws;
}

}  // namespace

Access read_state(Execution& x, const Target& target, double& value) {
    const VariableRow& row = *target.row;
    const PathState& path = x.core.path;
    const MachineView& view = x.core.view();
    switch (row.var) {
        case Var::CallParameters:
            value = 0;
            for (auto frame = x.calls.frames().rbegin(); frame != x.calls.frames().rend(); ++frame)
                if (frame->own_level) {
                    value = frame->given;
                    break;
                }
            return Access::Ok;
        case Var::Mode:
            value = x.core.port().single_block() ? 11 : 10;
            return Access::Ok;
        case Var::ModeBits:
            value = 1;
            return Access::Ok;
        case Var::Program:
            value = static_cast<double>(x.calls.here().program);
            return Access::Ok;
        case Var::Label:
            value = static_cast<double>(std::max<std::int64_t>(x.modal.last_label, 0));
            return Access::Ok;
        case Var::GState:
            value = target.index >= 0 && target.index < 1000 &&
                    g_active(x, static_cast<unsigned>(target.index));
            return Access::Ok;
        case Var::MState:
            value = target.index >= 0 && target.index < 64 &&
                    (x.modal.m_states >> static_cast<unsigned>(target.index) & 1u);
            return Access::Ok;
        case Var::PlaneAxes: {
            int p = -1, q = -1;
            x.core.plane_axes(p, q);
            // G17 G18 G19: X = 1, Y = 2, Z = 3, on a machine without them too
            static constexpr int kBasic[][2] = {{1, 2}, {3, 1}, {2, 3}};
            const auto& basic = kBasic[static_cast<std::size_t>(path.plane)];
            const auto axis = [&](int place, int named) {
                return place < 0 ? named
                                 : axis_number(view.axes[static_cast<std::size_t>(place)].name[0]);
            };
            value = axis(p, basic[0]) * 16 + axis(q, basic[1]);
            return Access::Ok;
        }
        case Var::LengthAxis: {
            const int z = view.axis_by_role(PlaneRole::BasicZ);
            value = z < 0 ? 0 : axis_number(view.axes[static_cast<std::size_t>(z)].name[0]);
            return Access::Ok;
        }
        case Var::Mirror: {  // by the order of the axes that exist (14)
            double bit = 1.0;
            value = 0.0;
            for (const char letter : kAxisLetters) {
                const int place = x.places.of(letter);
                if (place < 0) continue;
                if (x.modal.mirrored >> place & 1u) value += bit;
                bit *= 2;
            }
            return Access::Ok;
        }
        case Var::Scale:
            value = x.modal.scale;
            return Access::Ok;
        case Var::ScaleAxis: {
            const double factor =
                x.modal.axis_scale[static_cast<std::size_t>(x.places.of(target.axis))];
            value = factor == 0.0 ? 1.0 : factor;
            return Access::Ok;
        }
        case Var::Probe: {
            const auto given = x.core.port().given_variable("PRBST");
            value = given ? *given
                          : x.core.port().measuring_input(x.modal.probe_input == 2 ? "2" : "1",
                                                          view, path.machine);
            return Access::Ok;
        }
        case Var::Clock: {
            const CalendarTime t = x.core.port().clock();
            value = t.hour * 3600.0 + t.minute * 60.0 + t.second;
            return Access::Ok;
        }
        case Var::Time: {
            const CalendarTime t = x.core.port().clock();
            value = t.hour * 10'000.0 + t.minute * 100.0 + t.second;
            return Access::Ok;
        }
        case Var::Date: {
            const CalendarTime t = x.core.port().clock();
            value = (t.year % 100) * 10'000.0 + t.month * 100.0 + t.day;
            return Access::Ok;
        }
        case Var::CycleTime:
            value = std::trunc((x.core.port().running_ms() - x.facts.began_ms) / 10.0);
            return Access::Ok;
        case Var::First:
            value = x.facts.first_run;
            return Access::Ok;
        case Var::ProbeInput:
            value = x.modal.probe_input;
            return Access::Ok;
        case Var::Diameter:
            value = x.modal.diameter;
            return Access::Ok;
        case Var::ProbeMode:
            value = x.modal.probe_mode;
            return Access::Ok;
        case Var::Parts:
            value = x.modal.parts;
            return Access::Ok;
        default:
            break;
    }
    value = 0.0;
    return Access::Ok;
}

// Machine parameters by the numbers that the manual names.
double machine_parameter(const Execution& x, const Target& target) {
    const auto n = static_cast<int>(target.index);
    if (target.row->var == Var::ParameterGeneral) {
        switch (n) {
            case 8:
                return x.settings.inch;
            case 35:
            case 36:
            case 37:
            case 38:
                return x.settings.interrupt_subroutine[static_cast<std::size_t>(n - 35)];
            case 73:
                return x.settings.interpolation_period;
            case 119:
                return x.settings.probe_error;
            case 123:
                return x.settings.geometry_by_offset;
            case 160:
                return x.settings.look_ahead_kind;
            default:
                return 0.0;
        }
    }
    if (target.row->var == Var::ParameterAxis) {
        const MachineView& view = x.core.view();
        const ChannelAxis& axis = view.axes[static_cast<std::size_t>(x.places.of(target.axis))];
        switch (n) {
            case 1: {
                const auto format = static_cast<double>(
                    params::get(view.table(), params::fg_dformat, axis.machine_axis + 1u));
                return format >= 0 ? format
                       : params::bit(view.table(), params::n0106_axis_properties,
                                     axis.machine_axis + 1u, 0)
                           ? 4.0
                           : 0.0;
            }
            // in the active unit (11.2.4)
            case 5:
                return axis.rotary ? axis.limit_max : from_length_plain(x, axis.limit_max);
            case 6:
                return axis.rotary ? axis.limit_min : from_length_plain(x, axis.limit_min);
            default:
                return 0.0;
        }
    }
    if (target.row->var == Var::ParameterSpindle && n == 43) return x.settings.thread_angle;
    return 0.0;
}

}  // namespace polyturn::channels::fagor
