#include "kernel/supervisor/run/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/run/timeline.hpp"

namespace polyturn::supervisor {

namespace {

std::string base_name(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

std::string pass_lines(const Pass& pass) {
    return pass.first_line == pass.last_line
               ? fmt::format(fmt::runtime(say("line {}")), pass.first_line)
               : fmt::format(fmt::runtime(say("lines {} to {}")), pass.first_line, pass.last_line);
}

}  // namespace

std::string report_text(const RunRecord& record, const JobPlan& plan) {
    std::string out = "\n";
    const std::string name =
        plan.job && !plan.job->name.empty() ? plan.job->name : std::string(say("the run"));
    out += fmt::format("{}: {:.1f} s\n\n", name, record.seconds);

    out += fmt::format("  {:<22}{:>10}{:>10}{:>10}{:>10}{:>10}\n", say("channel"), say("cycle"),
                       say("cutting"), say("rapid"), say("waiting"), say("other"));
    double one_after_the_other = 0.0;
    for (const auto& [channel, times] : record.channels) {
        const auto program = plan.programs.find(channel);
        const std::string file =
            program == plan.programs.end() ? std::string() : base_name(program->second.file);
        const double other =
            std::max(0.0, times.cycle_s - times.cutting_s - times.rapid_s - times.waiting_s);
        out += fmt::format("  {:<22}{:>8.1f} s{:>8.1f} s{:>8.1f} s{:>8.1f} s{:>8.1f} s\n",
                           fmt::format("L{} {}", channel, file), times.cycle_s, times.cutting_s,
                           times.rapid_s, times.waiting_s, other);
        one_after_the_other += times.cycle_s - times.waiting_s;
    }
    if (record.channels.size() > 1 && record.seconds > 0) {
        const double saved = one_after_the_other - record.seconds;
        out += "\n  " +
               fmt::format(
                   fmt::runtime(say(
                       "One turret after the other would take {:.1f} s; working at once they save "
                       "{:.1f} s ({:.0f} %).")),
                   one_after_the_other, saved,
                   one_after_the_other > 0 ? 100.0 * saved / one_after_the_other : 0.0) +
               "\n";
    }

    auto waits = wait_spans(record);
    std::stable_sort(waits.begin(), waits.end(), [](const WaitSpan& a, const WaitSpan& b) {
        return a.seconds() > b.seconds();
    });
    if (!waits.empty()) out += fmt::format("\n  {}\n", say("Who waited"));
    std::size_t shown = 0;
    double rest = 0.0;
    for (const WaitSpan& wait : waits) {
        if (++shown > 12) {
            rest += wait.seconds();
            continue;
        }
        out += fmt::format("    L{:<2} {:>7.2f} s  {} {:<6} {}:{}{}\n", wait.channel,
                           wait.seconds(), say("at"), wait.code, base_name(wait.file), wait.line,
                           wait.last ? "  " + fmt::format(fmt::runtime(say("for L{}")), wait.last)
                                     : fmt::format("  {}", say("(nobody came)")));
    }
    if (shown > 12)
        out += "    " +
               fmt::format(fmt::runtime(say("and {} shorter ones, {:.2f} s together")), shown - 12,
                           rest) +
               "\n";

    const auto moves = advice(record, 3);
    if (!moves.empty()) out += fmt::format("\n  {}\n", say("Which cut to move"));
    for (const Advice& one : moves)
        out +=
            "    " +
            fmt::format(
                fmt::runtime(
                    say("{} {} of L{} ({:.1f} s{}): L{} waits {:.1f} s for it at {}. Given to L{} "
                        "it saves up to {:.1f} s.")),
                base_name(one.pass.file), pass_lines(one.pass), one.pass.channel,
                one.pass.seconds(), one.pass.tool.empty() ? std::string() : ", " + one.pass.tool,
                one.wait.channel, one.wait.seconds(), one.wait.code, one.wait.channel, one.gain_s) +
            "\n";
    return out;
}

}  // namespace polyturn::supervisor
