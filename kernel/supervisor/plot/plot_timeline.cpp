// The lower panel: what each channel did when, and where they waited for each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/supervisor/plot/plot_panels.hpp"
#include "kernel/supervisor/run/timeline.hpp"

namespace polyturn::supervisor {

namespace {
constexpr double kRow = 44.0, kBar = 24.0, kHead = 34.0, kScale = 30.0;

std::string fill_of(Doing doing, unsigned channel) {
    switch (doing) {
        case Doing::Cut:
            return fmt::format("fill=\"{}\"", look::channel_colour(channel));
        case Doing::Thread:
            return fmt::format("fill=\"url(#thread{})\"", channel);
        case Doing::Rapid:
            return fmt::format("fill=\"{}\"", look::channel_tint(channel));
        case Doing::Wait:
            return "fill=\"url(#wait)\" stroke=\"#c3c9cd\" stroke-width=\"0.6\"";
        case Doing::Dwell:
        case Doing::Aux:
            return "fill=\"#a9b1b7\"";
    }
    return {};
}
}  // namespace

TimelinePanel::TimelinePanel(const RunRecord& record, const JobPlan& plan)
    : record_(record), plan_(plan) {}

double TimelinePanel::height() const {
    return kHead + kRow * static_cast<double>(plan_.programs.size()) + kScale;
}

void TimelinePanel::draw(Svg& svg, const Frame& frame) const {
    const double span = std::max(record_.seconds, 1e-3), per_second = frame.width / span;
    const double bottom = frame.y + height() - kScale;
    const auto x_of = [&](double t) { return frame.x + t * per_second; };
    std::map<unsigned, double> row_y;
    double y = frame.y + kHead;
    for (const auto& [channel, program] : plan_.programs) {
        row_y[channel] = y;
        y += kRow;
    }

    const double step = round_step(span, 12);
    for (double t = 0; t <= span + 1e-9; t += step) {
        svg.line({x_of(t), frame.y + kHead - 8}, {x_of(t), bottom},
                 fmt::format("stroke=\"{}\" stroke-width=\"0.7\"", look::kGrid));
        svg.text({x_of(t), bottom + 16}, fmt::format("{:g}", t),
                 fmt::format("text-anchor=\"middle\" font-size=\"11\" fill=\"{}\"", look::kQuiet));
    }
    svg.text({frame.x + frame.width, bottom + 29}, "seconds since cycle start",
             fmt::format("text-anchor=\"end\" font-size=\"11\" fill=\"{}\"", look::kQuiet));

    for (const auto& [channel, top] : row_y) {
        svg.text({frame.x - 10, top + kBar / 2 + 4.5}, fmt::format("L{}", channel),
                 fmt::format("text-anchor=\"end\" font-weight=\"600\" fill=\"{}\"",
                             look::channel_colour(channel)));
        svg.rect(frame.x, top, frame.width, kBar, "fill=\"#f1f3f3\"", 2.0);
        // Neighbours of one kind become one bar, so that a program of a million blocks is still a
        // picture.
        double from = 0, to = -1;
        Doing doing = Doing::Cut;
        const auto flush = [&] {
            if (to > from)
                svg.rect(x_of(from), top, std::max((to - from) * per_second, 0.4), kBar,
                         fill_of(doing, channel));
            to = -1;
        };
        for (const Activity& activity : record_.activities) {
            if (activity.channel != channel || activity.end_s <= activity.t_s) continue;
            if (to >= 0 && activity.doing == doing && activity.doing != Doing::Wait &&
                (activity.t_s - to) * per_second < 0.6) {
                to = std::max(to, activity.end_s);
                continue;
            }
            flush();
            from = activity.t_s;
            to = activity.end_s;
            doing = activity.doing;
        }
        flush();
    }

    // Meetings as bridges over the channels that take part.
    double last_label = -1e9;
    for (const Meeting& meeting : meetings(record_)) {
        const double x = x_of(meeting.end_s);
        const auto first = row_y.find(meeting.channels.front()),
                   last = row_y.find(meeting.channels.back());
        if (first == row_y.end() || last == row_y.end()) continue;
        svg.line({x, first->second - 5}, {x, last->second + kBar + 5},
                 fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", look::kInk));
        for (const unsigned channel : meeting.channels)
            svg.circle({x, row_y[channel] + kBar / 2}, 3.2,
                       fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.3\"", look::kPaper,
                                   look::kInk));
        // the lines are there, their names would run into each other
        if (x - last_label < 30) continue;
        svg.text({x, frame.y + kHead - 13}, meeting.code,
                 fmt::format("text-anchor=\"middle\" font-size=\"10.5\" fill=\"{}\"", look::kInk));
        last_label = x;
    }
}

}  // namespace polyturn::supervisor
