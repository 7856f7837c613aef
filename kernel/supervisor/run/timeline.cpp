#include "kernel/supervisor/run/timeline.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::supervisor {

namespace {
constexpr double kSameTime_s = 0.0015;  // channels of a rendezvous leave in the same tick
constexpr double kShortest_s = 0.01;    // shorter waits are no waits for people
}  // namespace

std::vector<Meeting> meetings(const RunRecord& record) {
    std::vector<Meeting> out;
    for (const Activity& activity : record.activities) {
        if (activity.doing != Doing::Wait) continue;
        const auto found = std::find_if(out.begin(), out.end(), [&](const Meeting& meeting) {
            return meeting.code == activity.code &&
                   std::abs(meeting.end_s - activity.end_s) <= kSameTime_s;
        });
        if (found == out.end())
            out.push_back({activity.end_s, activity.code, {activity.channel}});
        else
            found->channels.push_back(activity.channel);
    }
    std::erase_if(out, [](const Meeting& meeting) { return meeting.channels.size() < 2; });
    for (Meeting& meeting : out) std::sort(meeting.channels.begin(), meeting.channels.end());
    std::sort(out.begin(), out.end(),
              [](const Meeting& a, const Meeting& b) { return a.end_s < b.end_s; });
    return out;
}

std::vector<WaitSpan> wait_spans(const RunRecord& record) {
    std::vector<WaitSpan> out;
    for (const Activity& activity : record.activities) {
        if (activity.doing != Doing::Wait || activity.end_s - activity.t_s < kShortest_s) continue;
        WaitSpan span{activity.channel,
                      activity.t_s,
                      activity.end_s,
                      activity.code,
                      activity.file,
                      activity.line,
                      0};
        double latest = activity.t_s;
        for (const Activity& other : record.activities) {
            if (other.doing != Doing::Wait || other.channel == activity.channel ||
                other.code != activity.code)
                continue;
            if (std::abs(other.end_s - activity.end_s) > kSameTime_s || other.t_s < latest)
                continue;
            latest = other.t_s;
            span.last = other.channel;
        }
        out.push_back(std::move(span));
    }
    return out;
}

std::vector<Pass> passes(const RunRecord& record) {
    std::vector<Pass> out;
    std::map<unsigned, std::ptrdiff_t> open;  // by channel: index of the pass that goes on, -1 none
    for (const Activity& activity : record.activities) {
        const bool cuts = activity.doing == Doing::Cut || activity.doing == Doing::Thread;
        auto [place, fresh] = open.try_emplace(activity.channel, -1);
        if (!cuts) {
            place->second = -1;
            continue;
        }
        const bool thread = activity.doing == Doing::Thread;
        if (place->second >= 0) {
            Pass& pass = out[static_cast<std::size_t>(place->second)];
            if (pass.tool == activity.tool && pass.thread == thread && pass.file == activity.file) {
                pass.end_s = std::max(pass.end_s, activity.end_s);
                pass.first_line = std::min(pass.first_line, activity.line);
                pass.last_line = std::max(pass.last_line, activity.line);
                continue;
            }
        }
        place->second = static_cast<std::ptrdiff_t>(out.size());
        out.push_back({activity.channel, activity.t_s, activity.end_s, activity.file, activity.tool,
                       activity.line, activity.line, thread});
    }
    return out;
}

std::vector<Advice> advice(const RunRecord& record, std::size_t most) {
    std::vector<Advice> out;
    const auto all_passes = passes(record);
    const auto all_meetings = meetings(record);
    for (const WaitSpan& wait : wait_spans(record)) {
        if (!wait.last) continue;
        // The section of the one who came last: since these two met before.
        double from = 0.0;
        for (const Meeting& meeting : all_meetings)
            if (meeting.end_s < wait.end_s - kSameTime_s &&
                std::binary_search(meeting.channels.begin(), meeting.channels.end(),
                                   wait.channel) &&
                std::binary_search(meeting.channels.begin(), meeting.channels.end(), wait.last))
                from = std::max(from, meeting.end_s);
        Advice best{wait, {}, 0.0};
        for (const Pass& pass : all_passes) {
            if (pass.channel != wait.last || pass.thread || pass.t_s < from - kSameTime_s ||
                pass.end_s > wait.end_s + kSameTime_s)
                continue;
            const double gain = std::min(pass.seconds(), wait.seconds() - pass.seconds());
            if (gain > best.gain_s) {
                best.gain_s = gain;
                best.pass = pass;
            }
        }
        if (best.gain_s > 0.05) out.push_back(std::move(best));
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Advice& a, const Advice& b) { return a.gain_s > b.gain_s; });
    if (out.size() > most) out.resize(most);
    return out;
}

}  // namespace polyturn::supervisor
