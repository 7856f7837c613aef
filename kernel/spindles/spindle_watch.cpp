#include "kernel/spindles/spindle_watch.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {

void SpindleWatch::fluctuation(bool on, double time_s, double start_percent, double percent,
                               double rpm) noexcept {
    watched_ = on;
    started_ = fluctuates_ = false;
    waited_s_ = 0;
    time_s_ = time_s;
    start_percent_ = start_percent;
    percent_ = percent;
    rpm_ = rpm;
}

void SpindleWatch::update(const SpindleConfig& config, double command, double measured,
                          double dt) noexcept {
    if (config.encoder_counts <= 0) {
        reached_ = standing_ = fluctuates_ = false;
        return;
    }
    deviation_ = std::fabs(measured - command);
    standing_ = std::fabs(measured) <= config.standstill_rpm;
    reached_ =
        standing_ || deviation_ <= std::max(config.tolerance_percent * 0.01 * std::fabs(command),
                                            config.tolerance_rpm);
    const auto given = [](double programmed, double parameter) {
        return std::isnan(programmed) ? parameter : programmed;
    };
    const double size = std::fabs(command);
    // A new command; constant surface speed changes it a little at every tick, which is none.
    if (std::fabs(command - command_) >
        given(start_percent_, config.watch_start_percent) * 0.01 * size) {
        started_ = fluctuates_ = false;
        waited_s_ = 0;
    }
    command_ = command;
    if (!watched_ || command == 0) return;
    if (!started_) {
        waited_s_ += dt;
        started_ = deviation_ <= given(start_percent_, config.watch_start_percent) * 0.01 * size ||
                   waited_s_ >= given(time_s_, config.watch_time_s);
    }
    if (started_ && deviation_ > std::max(given(percent_, config.watch_percent) * 0.01 * size,
                                          given(rpm_, config.watch_rpm)))
        fluctuates_ = true;
}

}  // namespace polyturn::kernel
