// When channels stand and why: what the log of stops is made of. Looks at the machine some times a
// second and says which stops have become long enough to be reported, and which are over. Knows
// nothing of clocks, segments or the store, so that tests can simulate a shift.
//
// A stop begins with the first look at which its cause holds and ends when the channel runs or
// another cause holds. Nothing is reported of a channel that has not run yet. Shorter stops than
// kLeast (waits for a partner: kLeastWait, they belong to every program) are not reported.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

struct Stop {
    std::int64_t begin_ms = 0;  // since 1970, UTC
    unsigned channel = 0;
    std::string cause;           // of kStopCauses
    std::string number, detail;  // of the alarm; of a wait «M503 L2»; M0, M1
    std::string program;
    std::uint32_t line = 0;
    double seconds = -1;  // negative: it is still stopped
};

class StopWatch {
public:
    static constexpr std::int64_t kLeast_ms = 1'000, kLeastWait_ms = 5'000;

    // The newest alarm of a channel, or of the machine (0).
    void alarm(unsigned channel, std::string number, std::string text);
    // One look. `stopped_by_alarm`: bit of channel less one. `program` is asked when a stop begins.
    template <class Program>
    std::vector<Stop> look(std::int64_t now_ms, const MachineStatus& status,
                           std::uint32_t stopped_by_alarm, Program program) {
        std::vector<Stop> out;
        for (unsigned channel = 1; channel <= kMaxChannels; ++channel)
            if (step(now_ms, status, (stopped_by_alarm >> (channel - 1) & 1u) != 0, channel, out))
                now_[channel - 1].stop.program = program(channel);
        return out;
    }
    // The controller ends: open stops end with it.
    std::vector<Stop> close(std::int64_t now_ms);

    static std::string_view cause_of(const MachineStatus& status, const ChannelStatus& channel,
                                     bool alarm, bool& runs);

private:
    struct Now {
        Stop stop;  // cause empty: it runs, or has not yet
        bool ran = false, told = false;
        // of the wait: the next one is another stop, though it was not seen running between them
        std::int32_t code = 0;
    };
    // true: a stop begins
    bool step(std::int64_t now_ms, const MachineStatus& status, bool alarm, unsigned channel,
              std::vector<Stop>& out);
    void end(Now& now, std::int64_t now_ms, std::vector<Stop>& out);
    std::array<Now, kMaxChannels> now_{};
    std::array<std::pair<std::string, std::string>, kMaxChannels + 1> alarms_{};
};

}  // namespace polyturn::supervisor
