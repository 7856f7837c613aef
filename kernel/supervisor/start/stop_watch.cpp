#include "kernel/supervisor/start/stop_watch.hpp"

#include "ipc/image/enums.hpp"
#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::supervisor {
namespace {

std::string wait_text(const ChannelStatus& channel) {
    std::string out = channel.wait_code > 0
                          ? wait_name(static_cast<Dialect>(channel.speaks), channel.wait_code)
                          : std::string();
    for (unsigned other = 0; other < kMaxChannels; ++other)
        if (channel.wait_missing >> other & 1u)
            out += (out.empty() ? "L" : " L") + std::to_string(other + 1);
    return out;
}

}  // namespace

void StopWatch::alarm(unsigned channel, std::string number, std::string text) {
    if (channel <= kMaxChannels) alarms_[channel] = {std::move(number), std::move(text)};
}

// The cause of the stop; empty: it runs or is not there. What stops everything is named before what
// stops one channel.
std::string_view StopWatch::cause_of(const MachineStatus& status, const ChannelStatus& channel,
                                     bool alarm, bool& runs) {
    const auto state = static_cast<ChannelState>(channel.state);
    runs = state == ChannelState::Running;
    if (state == ChannelState::Absent) return {};
    const auto step = static_cast<MachineStep>(status.step);
    if (step == MachineStep::EmergencyStop) return "emergency";
    if (step == MachineStep::Off) return "off";
    if (state == ChannelState::Dead) return "dead";
    if (step == MachineStep::Stopped || (alarm && !runs)) return "alarm";
    switch (state) {
        case ChannelState::Waiting:
            return "wait";
        case ChannelState::Interrupted:
            return "alarm";
        case ChannelState::Ended:
            return "ended";
        case ChannelState::Reset:
            return "reset";
        case ChannelState::Held:
        case ChannelState::ProgramStop:
            switch (static_cast<StopReason>(channel.stop_reason)) {
                case StopReason::M00:
                case StopReason::M01:
                case StopReason::FirstPart:
                case StopReason::Dialogue:
                    return "program";
                case StopReason::SingleBlock:
                    return "single";
                case StopReason::Restart:
                case StopReason::Retrace:
                    return "operator";
                case StopReason::Waiting:
                    return "wait";
                case StopReason::Alarm:
                    return "alarm";
                default:
                    return "hold";
            }
        default:
            return {};
    }
}

bool StopWatch::step(std::int64_t now_ms, const MachineStatus& status, bool alarm, unsigned channel,
                     std::vector<Stop>& out) {
    const ChannelStatus& is = status.channels[channel - 1];
    Now& now = now_[channel - 1];
    bool runs = false;
    const std::string_view cause = cause_of(status, is, alarm, runs);
    // A program that has ended keeps that cause when it is reset afterwards: nothing was broken
    // off.
    const bool same = (now.stop.cause == cause && (cause != "wait" || now.code == is.wait_code)) ||
                      (now.stop.cause == "ended" && cause == "reset");
    now.ran |= runs;
    if (!now.ran) return false;
    bool begins = false;
    if (!same) {
        end(now, now_ms, out);
        if (!cause.empty()) {
            now.stop = {now_ms, channel, std::string(cause), {}, {}, {}, is.line, -1};
            now.told = false;
            now.code = is.wait_code;
            begins = true;
        }
    }
    if (now.stop.cause.empty()) return false;
    if (now.stop.cause == "alarm" && now.stop.number.empty()) {
        const auto& [number, text] =
            alarms_[channel].second.empty() ? alarms_[0] : alarms_[channel];
        now.stop.number = number;
        now.stop.detail = text;
    } else if (now.stop.cause == "wait" && now.stop.detail.empty()) {
        now.stop.detail = wait_text(is);
    } else if (now.stop.cause == "program") {
        const auto reason = static_cast<StopReason>(is.stop_reason);
        now.stop.detail = reason == StopReason::M00        ? "M0"
                          : reason == StopReason::M01      ? "M1"
                          : reason == StopReason::Dialogue ? "?"
                                                           : "";
    }
    if (!now.told &&
        now_ms - now.stop.begin_ms >= (now.stop.cause == "wait" ? kLeastWait_ms : kLeast_ms)) {
        now.told = true;
        out.push_back(now.stop);
    }
    return begins;
}

void StopWatch::end(Now& now, std::int64_t now_ms, std::vector<Stop>& out) {
    if (now.told) {
        now.stop.seconds = static_cast<double>(now_ms - now.stop.begin_ms) / 1e3;
        out.push_back(now.stop);
    }
    if (now.stop.cause == "alarm" && now.stop.channel) alarms_[now.stop.channel] = {};
    now.stop = {};
    now.told = false;
}

std::vector<Stop> StopWatch::close(std::int64_t now_ms) {
    std::vector<Stop> out;
    for (Now& now : now_) {
        end(now, now_ms, out);
        now.ran = false;
    }
    return out;
}

}  // namespace polyturn::supervisor
