#include "kernel/channel/path/early_function.hpp"

#include <array>
#include <cmath>

#include "kernel/channel/path/drive.hpp"
#include "kernel/protection/guard.hpp"
#include "kernel/records/aux_records.hpp"
#include "kernel/records/record_executor.hpp"

namespace polyturn::kernel {
namespace {

// What may begin while the rapid move before it is still driven: a code of its own block that comes
// after that block's end.
bool starts_in_rapid(Channel& c) noexcept {
    constexpr std::uint32_t kWhole = kRapid | kBlockEnd,
                            kNever = kInPosition | kSkipMove | kFixedStop | kReference | kThread;
    constexpr std::uint32_t kStandsBetween = kKeySingleBlock | kKeyFirstPart;
    if (c.path.cursor + 1 >= c.path.visible_end || c.standing.handshake.early == c.path.cursor + 1)
        return false;
    const PathRecord &r = c.path.here(), &next = c.record(c.path.cursor + 1);
    if ((r.flags & kWhole) != kWhole || (r.flags & kNever) || next.serial == r.serial) return false;
    if (static_cast<RecordKind>(next.kind) != RecordKind::Aux || (next.flags & kPositioning) ||
        (c.panel.keys & kStandsBetween) || c.standing.handshake.unfinished || c.interrupts.due)
        return false;
    return c.program.is(ChannelState::Running) && !c.retrace.wheel.on && !path_input(c).hold &&
           c.path.step.speed > 0;
}

// A T turns the turret while the axes still move. With protection on, the whole circle of the
// turret's tools must be free from here to the end of the move, because the turret may be held
// anywhere on it. Without protection, ROL is the setter's confirmation that it is free. If the
// store must be asked which tool is meant, it is asked early enough for the answer to be there in
// time; a refusal is reported when the path has come to the T.
bool tool_may_begin(Channel& c, const PathRecord& r, const PathRecord& tool,
                    double until) noexcept {
    if (ToolClient::managed(c.core)) {
        const double soon = c.path.step.speed * c.core.config.tick_s *
                            static_cast<double>(2 * c.core.config.answer_ticks);
        if (until <= soon && c.core.tools.call(c.index) == ToolClient::Call::None)
            (void)c.core.tools.ask(c.core, c.index, tool);
        if (c.core.tools.call(c.index) != ToolClient::Call::Answered) return false;
    }
    if (until > 0 || !c.core.guard || !c.core.guard->protects(c.number)) return true;
    if (r.transform != 0 || static_cast<RecordKind>(r.kind) != RecordKind::Line) return false;
    // protection saw the last tick
    const double share =
        (r.length - c.path.step.s + c.path.step.speed * c.core.config.tick_s) / r.length;
    std::array<double, kMaxAxes> way{};
    for (std::uint32_t i = 0; i < r.axis_count; ++i)
        way[r.axis[i]] = share * (r.end[i] - r.start[i]);
    return c.core.guard->circle_is_free(c.number, way);
}

}  // namespace

void begin_function_early(Channel& c) noexcept {
    if (!c.core.config.channels[c.index].rapid_overlaps || !starts_in_rapid(c)) return;
    const PathRecord &r = c.path.here(), &next = c.record(c.path.cursor + 1);
    const double v = c.path.step.speed, left = r.length - c.path.step.s;
    const double braking = 0.5 * v * (v / r.a_max + (r.j_max > 0 ? r.a_max / r.j_max : 0.0));
    constexpr double kNearly = 1.05, kTicks = 2.0;
    const double begins = kNearly * braking + kTicks * v * c.core.config.tick_s;
    if (next.code == 'T' && !tool_may_begin(c, r, next, left - begins)) return;
    if (left > begins) return;
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        const AxisConfig& axis = c.core.config.axes[r.axis[i]];
        if (r.end[i] != r.start[i] &&
            v * std::fabs(r.end[i] - r.start[i]) / r.length >= axis.rapid * axis.rapid_share)
            return;
    }
    c.standing.handshake.early = c.path.cursor + 1;
    begin_record(c, next, 0);
    strobe_function(c, next);
}

}  // namespace polyturn::kernel
