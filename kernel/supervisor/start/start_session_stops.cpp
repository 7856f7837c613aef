// The log of stops and the alarms of all days: reports of the stop watch and the processes go to
// the store, as operations of the supervisor's own.
#include <cstdio>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "kernel/supervisor/start/start_session.hpp"

namespace polyturn::supervisor {
namespace {

constexpr auto kEvery = std::chrono::milliseconds(100);
constexpr std::size_t kMostUntold = 1000, kAlarmsAtOnce = 8, kMostUnderWay = 32;

std::string utc_text(std::int64_t ms) {
    const auto seconds = static_cast<std::time_t>(ms / 1000);
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[40];
    const std::size_t size = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
    std::snprintf(text + size, sizeof text - size, ".%03dZ", static_cast<int>(ms % 1000));
    return text;
}

}  // namespace

std::int64_t utc_ms() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

void StartSession::watch_stops() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_stop_look_) return;
    next_stop_look_ = now + kEvery;
    keep_alarms();
    const auto status = std::make_unique<MachineStatus>();
    const auto inputs = std::make_unique<PlcInputs>();
    if (!controller_->kernel().status.read(*status) ||
        !controller_->kernel().plc_inputs.read(*inputs))
        return;
    std::uint32_t alarms = 0;
    for (unsigned channel = 1; channel <= kMaxChannels; ++channel)
        if (inputs->signal[signals::cn_alarm(channel)] != 0) alarms |= 1u << (channel - 1);
    keep_stops(stops_.look(utc_ms(), *status, alarms, [&](unsigned channel) -> std::string {
        const ChannelSegment* segment = controller_->channel(channel);
        const auto names = std::make_unique<ProgramNames>();
        if (!segment || !segment->programs.read(*names) || names->count == 0) return {};
        return &names->name[std::min(status->channels[channel - 1].file, 31u) * std::size_t{256}];
    }));
}

// None is lost because the store is busy or dead for a while.
void StartSession::keep_stops(std::vector<Stop> stops) {
    for (Stop& one : stops) untold_stops_.push_back(std::move(one));
    while (untold_stops_.size() > kMostUntold) untold_stops_.pop_front();
    while (!untold_stops_.empty() && controller_->running(kProcessStore) &&
           context_.waiting() < kMostUnderWay) {
        const Stop& one = untold_stops_.front();
        nlohmann::json op = {{"do", "stops.note"},     {"utc", utc_text(one.begin_ms)},
                             {"channel", one.channel}, {"cause", one.cause},
                             {"number", one.number},   {"detail", one.detail},
                             {"program", one.program}, {"line", one.line}};
        if (one.seconds >= 0) op["seconds"] = one.seconds;
        own_operation(op.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
        untold_stops_.pop_front();
    }
}

// Some at a time: a program that warns in a loop writes the disk ten times a second at the most,
// and of a flood the newest are kept.
void StartSession::keep_alarms() {
    while (unkept_alarms_.size() > kMostUntold) unkept_alarms_.pop_front();
    if (unkept_alarms_.empty() || !controller_->running(kProcessStore) ||
        context_.waiting() >= kMostUnderWay)
        return;
    std::string events;
    for (std::size_t i = 0; i < kAlarmsAtOnce && !unkept_alarms_.empty();
         ++i, unkept_alarms_.pop_front())
        events += (events.empty() ? "" : ",") + unkept_alarms_.front();
    own_operation(R"({"do":"alarms.note","events":[)" + events + "]}");
}

}  // namespace polyturn::supervisor
