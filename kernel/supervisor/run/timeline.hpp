// What the activities of a run say about its waits: who waited where, how long and for whom, and
// which cut of the one who was waited for the other could take over. For the report and the
// picture. Pure.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernel/supervisor/run/run_record.hpp"

namespace polyturn::supervisor {

struct WaitSpan {
    unsigned channel = 0;
    double t_s = 0.0, end_s = 0.0;
    std::string code, file;
    std::uint32_t line = 0;
    unsigned last = 0;  // the channel that came last to the rendezvous; 0: no channel was waited
                        // for
    double seconds() const { return end_s - t_s; }
};

// Cuts that follow one another without a rapid between them.
struct Pass {
    unsigned channel = 0;
    double t_s = 0.0, end_s = 0.0;
    std::string file, tool;
    std::uint32_t first_line = 0, last_line = 0;
    bool thread = false;
    double seconds() const { return end_s - t_s; }
};

// Channels that left one wait together.
struct Meeting {
    double end_s = 0.0;
    std::string code;
    std::vector<unsigned> channels;
};

// A pass given to the channel that waited for it.
struct Advice {
    WaitSpan wait;
    Pass pass;
    double gain_s = 0.0;  // the rendezvous would come so much earlier
};

std::vector<WaitSpan> wait_spans(const RunRecord& record);
std::vector<Meeting> meetings(const RunRecord& record);
std::vector<Pass> passes(const RunRecord& record);
// The move of a pass that saves most, best first. Moving x seconds out of a section that somebody
// waited w seconds for shortens it by x and lengthens the other's by x, so it gains min(x, w - x);
// a thread stays where its tool is.
std::vector<Advice> advice(const RunRecord& record, std::size_t most);

}  // namespace polyturn::supervisor
