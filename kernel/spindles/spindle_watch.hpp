// Monitoring of a spindle's speed (nct_parameters_part1 8.5): reached (SN_NS), standstill (SN_N0),
// fluctuating (SN_FLU).
//
//   G26 and a new command    waiting     until the speed is within N0631 of the command, or N0630
//                                        has passed
//                            watching    until it leaves both bands N0632 and N0633: fluctuating
// Nothing is reported of a spindle without an encoder (N0608 = 0).
#pragma once
#include "kernel/config/spindle_config.hpp"

namespace polyturn::kernel {

class SpindleWatch {
public:
    // command, measured: 1/min with sign, or both without (UNI).
    void update(const SpindleConfig& config, double command, double measured, double dt) noexcept;
    // G26: values that the program gives; NaN: those of the parameters.
    void fluctuation(bool on, double time_s, double start_percent, double percent,
                     double rpm) noexcept;
    bool reached() const noexcept { return reached_; }  // or stopped: both are on at standstill
    bool standing() const noexcept { return standing_; }
    bool fluctuates() const noexcept { return fluctuates_; }
    double deviation() const noexcept { return deviation_; }

private:
    bool reached_ = false, standing_ = false, fluctuates_ = false;
    bool watched_ = false, started_ = false;
    double command_ = 0, waited_s_ = 0, deviation_ = 0;
    double time_s_ = 0, start_percent_ = 0, percent_ = 0, rpm_ = 0;
};

}  // namespace polyturn::kernel
