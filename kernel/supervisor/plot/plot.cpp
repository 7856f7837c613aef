#include "kernel/supervisor/plot/plot.hpp"

#include <fmt/format.h>

#include "kernel/supervisor/plot/plot_panels.hpp"

namespace polyturn::supervisor {

namespace {

constexpr double kWidth = 1240.0, kLeft = 64.0, kRight = 40.0;

void definitions(Svg& svg, const JobPlan& plan) {
    svg.raw(
        "<defs>\n"
        "<linearGradient id=\"part\" x1=\"0\" y1=\"0\" x2=\"0\" y2=\"1\"><stop offset=\"0\" "
        "stop-color=\"#b4bec4\"/><stop offset=\"0.28\" "
        "stop-color=\"#eef1f2\"/>"
        "<stop offset=\"0.55\" stop-color=\"#d3dadd\"/><stop offset=\"1\" "
        "stop-color=\"#a3afb6\"/></linearGradient>\n"
        "<pattern id=\"stock\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(45)\"><rect width=\"7\" height=\"7\" "
        "fill=\"#f4f1e8\"/>"
        "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"7\" stroke=\"#e2dac6\" "
        "stroke-width=\"1.4\"/></pattern>\n"
        "<pattern id=\"wait\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" "
        "fill=\"#ffffff\"/>"
        "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"6\" stroke=\"#cdd3d6\" "
        "stroke-width=\"2\"/></pattern>\n");
    for (const auto& [channel, program] : plan.programs)
        svg.raw(fmt::format(
            "<pattern id=\"thread{0}\" width=\"4\" height=\"4\" "
            "patternUnits=\"userSpaceOnUse\"><rect width=\"4\" height=\"4\" fill=\"{1}\"/>"
            "<line x1=\"1\" y1=\"0\" x2=\"1\" y2=\"4\" stroke=\"#ffffff\" stroke-width=\"1.2\" "
            "stroke-opacity=\"0.75\"/></pattern>\n",
            channel, look::channel_colour(channel)));
    svg.raw("</defs>\n");
}

void legend(Svg& svg, double x, double y) {
    const auto words = [&](double at, const char* text) {
        svg.text({at, y + 4}, text, fmt::format("font-size=\"11.5\" fill=\"{}\"", look::kQuiet));
    };
    const char* ink = "#4a545c";
    svg.line({x, y}, {x + 26, y},
             fmt::format("stroke=\"{}\" stroke-width=\"1.8\" stroke-linecap=\"round\"", ink));
    words(x + 33, "cutting");
    svg.line({x + 90, y}, {x + 116, y},
             fmt::format(
                 "stroke=\"{}\" stroke-width=\"1\" stroke-dasharray=\"4 3\" stroke-opacity=\"0.7\"",
                 ink));
    words(x + 123, "rapid");
    svg.line({x + 170, y}, {x + 196, y},
             fmt::format("stroke=\"{}\" stroke-width=\"3.6\" stroke-dasharray=\"1.1 1.7\"", ink));
    words(x + 203, "thread");
    svg.rect(x + 256, y - 6, 26, 12, "fill=\"url(#wait)\" stroke=\"#c3c9cd\" stroke-width=\"0.6\"",
             1.5);
    words(x + 289, "waiting");
    svg.rect(x + 344, y - 6, 26, 12, "fill=\"#a9b1b7\"", 1.5);
    words(x + 377, "dwell, M S T");
    svg.line({x + 468, y - 8}, {x + 468, y + 8},
             fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", look::kInk));
    svg.circle(
        {x + 468, y}, 3.2,
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.3\"", look::kPaper, look::kInk));
    words(x + 479, "meeting at a waiting code");
}

std::string subtitle(const RunRecord& record) {
    double one_by_one = 0.0;
    for (const auto& [channel, times] : record.channels)
        one_by_one += times.cycle_s - times.waiting_s;
    std::string out = fmt::format("{:.1f} s", record.seconds);
    if (record.channels.size() > 1)
        out += fmt::format(";  one turret after the other: {:.1f} s", one_by_one);
    return out;
}

}  // namespace

std::string plot_text(const RunRecord& record, const JobPlan& plan) {
    const double inner = kWidth - kLeft - kRight;
    const PathPanel paths(record, plan, inner);
    const TimelinePanel timeline(record, plan);
    const double top = 78.0, timeline_y = top + paths.height() + (paths.empty() ? 0.0 : 52.0);
    Svg svg(kWidth, timeline_y + timeline.height() + 34.0);
    definitions(svg, plan);
    const std::string title = plan.job && !plan.job->name.empty() ? plan.job->name : "Polyturn run";
    svg.text({kLeft, 38}, title, "font-size=\"22\" font-weight=\"650\"");
    svg.text({kLeft, 59}, subtitle(record),
             fmt::format("font-size=\"13\" fill=\"{}\"", look::kQuiet));
    paths.draw(svg, {kLeft, top, inner});
    legend(svg, kLeft, paths.empty() ? top - 8 : top + paths.height() + 12);
    timeline.draw(svg, {kLeft, timeline_y, inner});
    return std::move(svg).finish();
}

}  // namespace polyturn::supervisor
