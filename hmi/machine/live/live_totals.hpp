// The hours of the machine at this moment. The kernel counts them at each tick and hands them to
// the store every ten seconds, for each is a write to the disk; what has come since is seen in the
// image: the tick, what the channels do, what they have cut in the running cycle.
#pragma once
#include <array>

#include "hmi/machine/live/live.hpp"
#include "ipc/requests/counters.hpp"

namespace polyturn::hmi {

class LiveTotals {
public:
    void follow(const Live& live);  // each frame
    // of a parameter (place in params::Table::numbers) that counts time; -1: it is none
    double ms(std::size_t slot) const;

private:
    struct Hours {
        // milliseconds; stored -1: not known yet
        double stored = -1, since = 0;
        double now() const { return stored < 0 ? -1 : stored + since; }
        void add(double stored_ms, double more_ms);
    };
    struct Seen {
        double cutting_s = 0, cycle_s = 0;
        bool operates = false;
    };
    Hours& hours(Counter counter, unsigned channel) {
        return hours_[static_cast<std::size_t>(counter_number(counter, channel))];
    }
    std::array<Hours, static_cast<std::size_t>(kPowerOnTime) + 1> hours_{};
    std::array<Seen, kMaxChannels> seen_{};
    std::uint64_t run_ = 0;
    std::int64_t tick_ = -1;
};

}  // namespace polyturn::hmi
