#include "kernel/supervisor/run/run.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "ipc/image/commands.hpp"
#include "ipc/model/files/read_file.hpp"
#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/press/signal_words.hpp"
#include "kernel/supervisor/run/run_session.hpp"

namespace polyturn::supervisor {

namespace {

std::optional<double> number_of(std::string_view words) {
    double value = 0;
    const auto end = std::from_chars(words.data(), words.data() + words.size(), value);
    if (end.ec != std::errc() || end.ptr != words.data() + words.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// "L=VALUE" or "2=VALUE": channel and the rest; channel 0 when there is none.
std::pair<unsigned, std::string_view> split_channel(std::string_view words) {
    const auto equals = words.find('=');
    if (equals == std::string_view::npos) return {0, words};
    std::string_view whom = words.substr(0, equals);
    if (!whom.empty() && whom[0] == 'L') whom.remove_prefix(1);
    const auto number = number_of(whom);
    if (!number || *number < 1 || *number > static_cast<double>(kMaxChannels))
        return {kMaxChannels + 1, words};
    return {static_cast<unsigned>(*number), words.substr(equals + 1)};
}

bool read_wishes(const JobOptions& options, const JobPlan& plan, RunRequests& wishes,
                 std::vector<Diagnosis>& diagnoses) {
    const auto fault = [&](Alarm alarm, std::string detail) {
        diagnoses.push_back(Diagnosis{alarm, {}, {}, std::move(detail)});
    };
    for (const std::string& name : options.watch) {
        const auto signal = parse_signal(name);
        if (!signal) {
            Diagnosis diagnosis = signal.diagnosis();
            diagnosis.place.file = "--watch";
            diagnoses.push_back(std::move(diagnosis));
            continue;
        }
        const std::uint32_t side =
            signal->row->writer == SignalWriter::Plc ? kSlotOfPlc : kSlotOfNc;
        wishes.watch.push_back(
            {name, signal->slot(), side, signal->row->kind == SignalKind::Double});
    }
    if (wishes.watch.size() > kMaxWatches)
        fault(Alarm::PressArgument,
              fmt::format("--watch: {} names, {} are possible", wishes.watch.size(), kMaxWatches));
    for (const std::string& words : options.overrides) {
        const auto [channel, value] = split_channel(words);
        const auto percent = number_of(
            !value.empty() && value.back() == '%' ? value.substr(0, value.size() - 1) : value);
        if (channel > kMaxChannels || !percent || *percent < 0 || *percent > 200) {
            fault(Alarm::PressArgument,
                  fmt::format("--override {} is not of the form [L=]PERCENT, 0 to 200", words));
            continue;
        }
        for (unsigned number = 1; number <= kMaxChannels; ++number)
            if (channel == 0 || channel == number) wishes.feed_override[number] = *percent / 100.0;
    }
    for (const std::string& words : options.from) {
        auto [channel, block] = split_channel(words);
        if (!block.empty() && (block[0] == 'N' || block[0] == 'n')) block.remove_prefix(1);
        const auto number = number_of(block);
        if (channel < 1 || channel > kMaxChannels || !number || *number < 0 ||
            *number != std::floor(*number))
            fault(Alarm::PressArgument, fmt::format("--from {} is not of the form L=N120", words));
        else if (!plan.programs.count(channel))
            fault(Alarm::PressArgument,
                  fmt::format("--from {}: channel {} has no program", words, channel));
        else
            wishes.restart_at[channel] = *number;
    }
    if (!options.scenario.empty()) {
        const auto content = text::read_text_file(options.scenario);
        if (!content) {
            diagnoses.push_back(content.diagnosis());
        } else {
            const std::size_t before = diagnoses.size();
            const text::Scenario scenario =
                text::parse_scenario(*content, options.scenario, diagnoses);
            if (diagnoses.size() == before)
                wishes.scenario = ScenarioPlayer::make(scenario, *plan.machine, diagnoses);
        }
    }
    return diagnoses.empty();
}

int refuse(const std::vector<Diagnosis>& diagnoses, int exit_status) {
    Output output;
    for (const Diagnosis& diagnosis : diagnoses) {
        print_diagnosis(diagnosis, Dialect::Polyturn);
        output.write(alarm_event(diagnosis, Dialect::Polyturn, 0));
    }
    return exit_status;
}

}  // namespace

int run_programs(const JobOptions& options) {
    PlanFailure failure;
    auto plan = plan_job(options, JobWork::Run, failure);
    if (!plan) return refuse(failure.diagnoses, failure.exit_status);
    RunRequests wishes;
    std::vector<Diagnosis> diagnoses;
    if (!read_wishes(options, *plan, wishes, diagnoses)) return refuse(diagnoses, 2);
    if (!options.instance.empty() && !valid_instance(options.instance))
        return refuse({Diagnosis{Alarm::InstanceName, {}, {}, options.instance}}, 2);
    RunSession session(options, *plan, std::move(wishes));
    return session.run();
}

}  // namespace polyturn::supervisor
