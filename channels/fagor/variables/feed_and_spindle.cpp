#include "channels/fagor/variables/feed_and_spindle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr double kPanelMost = 120.0;  // %, the end of the feed switch (part 1, 5.2)

// 1/min that the commands come to: in G96 at the present diameter, with the override of the
// program.
double spindle_turns_at(const Execution& x) {
    const SpindleState& s = x.core.path.spindle;
    if (s.turn == SpindleTurn::Stop) return 0.0;
    double rpm = s.rpm;
    const int place = x.core.view().axis_by_role(PlaneRole::BasicX);
    if (s.mode == SpindleModeCode::SurfaceSpeed && place >= 0) {
        const double radius =
            std::fabs(x.core.framed(x.core.path.programmed)[static_cast<std::size_t>(place)]);
        rpm = radius > 0 ? 1000.0 * s.surface_m_min / (2 * std::numbers::pi * radius) : s.limit_rpm;
    }
    if (x.modal.spindle_override_program > 0) rpm *= x.modal.spindle_override_program / 100.0;
    return s.limit_rpm > 0 ? std::fmin(rpm, s.limit_rpm) : rpm;
}

}  // namespace

Access read_feed_or_spindle(Execution& x, const Target& target, double& value) {
    const SpindleState& s = x.core.path.spindle;
    Port& port = x.core.port();
    const double panel = std::round(port.feed_override() * 100.0),
                 spindle_panel =
                     s.spindle ? std::round(port.spindle_override(s.spindle) * 100.0) : 100.0;
    switch (target.row->var) {
        case Var::Feed:
            value = from_length_plain(
                x, x.modal.feed_code == 32 ? x.modal.feed_of_block : x.modal.feed_minute);
            break;
        case Var::FeedProgram:
            value = from_length_plain(x, x.modal.feed_minute);
            break;
        case Var::FeedRev:
        case Var::FeedRevProgram:
            value = from_length_plain(x, x.modal.feed_revolution);
            break;
        case Var::FeedInverse:
            value = x.modal.feed_inverse;
            break;
        case Var::Override:
            value = x.modal.override_program > 0
                        ? x.modal.override_program
                        : std::fmin(std::fmin(panel, kPanelMost), x.settings.override_max);
            break;
        case Var::OverrideProgram:
            value = x.modal.override_program;
            break;
        case Var::OverridePanel:
            value = panel;
            break;
        case Var::SpindleOverridePanel:
            value = spindle_panel;
            break;
        case Var::SpindleOverride:
            value = x.modal.spindle_override_program > 0
                        ? x.modal.spindle_override_program
                        : std::min(std::max(spindle_panel, x.settings.spindle_override_min),
                                   x.settings.spindle_override_max);
            break;
        case Var::SpindleOverrideProgram:
            value = x.modal.spindle_override_program;
            break;
        case Var::SpindleReal: {
            const auto turns = s.spindle ? port.spindle_speed(s.spindle) : std::nullopt;
            // beyond tenths an encoder reports noise
            value = turns ? std::round(*turns * 10.0) / 10.0 : spindle_turns_at(x);
            break;
        }
        case Var::SpindleTheoretical:
            value = spindle_turns_at(x);
            break;
        case Var::SpindleSpeed:
        case Var::SpindleProgram:
            value = s.rpm;
            break;
        case Var::SurfaceSpeed:
        case Var::SurfaceProgram:
            value = x.modal.inch ? s.surface_m_min / 0.3048 : s.surface_m_min;
            break;
        case Var::SpindleLimit:
            value = x.modal.speed_limit;
            break;
        case Var::SpindleAngle:
        case Var::SpindleAngleProgram:
            value = x.modal.position_angle;
            break;
        case Var::SpindleTurnAngle:
            value = x.modal.position_angle - std::floor(x.modal.position_angle / 360.0) * 360.0;
            break;
        // nothing moves while a program reads it
        default:
            value = 0.0;
            break;
    }
    return Access::Ok;
}

}  // namespace polyturn::channels::fagor
