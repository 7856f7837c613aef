// Axes with absolute encoders (nct_parameters_part1 10.3, 10.4): moved while the power was off, its
// encoder decoupled or its battery empty; and the rounds of an encoder that cannot count them
// itself (N0900 CIR), saved in N0908.
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

// `at`: machine coordinate now. The operator says that it is right: reference mode and the jog key
// of the axis.
void Machine::check_absolute(std::uint32_t a, double at) noexcept {
    const ReferenceConfig& reference = core_.config.axes[a].reference;
    const double was_at =
        store_segment_->totals.published().last_position[a] + reference.absolute_origin();
    if (!reference.absolute || reference.floating || reference.alarm_distance <= 0 ||
        !std::isfinite(was_at) || std::fabs(at - was_at) <= reference.alarm_distance)
        return;
    core_.axes[a].referenced = false;
    absolute_seen_[a] = true;  // said once
    core_.alarm(Alarm::EncoderMoved, core_.config.axes[a].channel,
                std::string_view(core_.config.axes[a].name.data()), at - was_at);
}

void Machine::watch_absolute(std::uint32_t a) noexcept {
    AxisUnit& axis = core_.axes[a];
    if (!core_.config.axes[a].reference.absolute) return;
    if (!absolute_seen_[a] && axis.answered()) {
        absolute_seen_[a] = true;
        check_absolute(a, axis.measured());
    }
    std::int64_t rounds = 0;
    if (!axis.encoder().take_store_changes(rounds)) return;
    ShortText line;
    line << "N0908 " << name_of('A', a).view() << "=" << rounds;
    if (!core_.store.ask_parameter(line.view(), core_.tick, core_.config.answer_ticks))
        axis.encoder().not_kept();
}

}  // namespace polyturn::kernel
