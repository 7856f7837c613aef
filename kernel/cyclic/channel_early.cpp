// How much the path knows of what is prepared, and a function that begins before the rapid move in front of it has come to rest.
#include <cmath>

#include "ipc/image/compensated_flag.hpp"
#include "kernel/cyclic/channel_runner.hpp"

namespace polyturn::kernel {

// N1301 MBM 0: of what is prepared the path knows the running block and the next one, three with nose-radius compensation. A
// thread counts as one block: it starts when all of it is known.
std::uint64_t ChannelRunner::end_of_few_blocks(std::uint64_t most) const noexcept {
    std::uint64_t end = cursor_;
    unsigned left = cursor_ < most && (record(cursor_).flags & kCompensated) ? 4 : 2;
    for (; end < most && left > 0; ++end) {
        const std::uint32_t flags = record(end).flags;
        if ((flags & kBlockEnd) && !((flags & kThread) && !(flags & kThreadEnd))) --left;
    }
    return end;
}

// N0421 ROL (nct_parameters_part1 6.4): a block without movement behind a rapid move begins when that is braking to its end and each
// of its axes has fallen below its share of rapid (N0422).
void ChannelRunner::begin_function_early() noexcept {
    constexpr std::uint32_t kWhole = kRapid | kBlockEnd, kNever = kInPosition | kSkipMove | kFixedStop | kReference | kThread;
    constexpr std::uint32_t kStandsBetween = kKeySingleBlock | kKeyFirstPart;
    if (!core_.config.channels[index_].rapid_overlaps || cursor_ + 1 >= visible_end_ || early_ == cursor_ + 1) return;
    const PathRecord &r = record(cursor_), &next = record(cursor_ + 1);
    if ((r.flags & kWhole) != kWhole || (r.flags & kNever) || next.serial == r.serial) return;
    if (static_cast<RecordKind>(next.kind) != RecordKind::Aux || (next.flags & kBesidePath) || (keys & kStandsBetween) || unfinished_ || interrupt_due_) return;
    if (next.code == 'T' && ToolDesk::managed(core_)) return;   // the store is asked first
    if (state_ != ChannelState::Running || wheel_ || path_input().hold) return;
    const double v = step_.speed, left = r.length - step_.s;
    const double braking = 0.5 * v * (v / r.a_max + (r.j_max > 0 ? r.a_max / r.j_max : 0.0));
    constexpr double kNearly = 1.05, kTicks = 2.0;
    if (v <= 0 || left > kNearly * braking + kTicks * v * core_.config.tick_s) return;
    for (std::uint32_t i = 0; i < r.axis_count; ++i) {
        const AxisConfig& axis = core_.config.axes[r.axis[i]];
        if (r.end[i] != r.start[i] && v * std::fabs(r.end[i] - r.start[i]) / r.length >= axis.rapid * axis.rapid_share) return;
    }
    early_ = cursor_ + 1;
    begin_record(next, 0);
    strobe(next);
}

}  // namespace polyturn::kernel
