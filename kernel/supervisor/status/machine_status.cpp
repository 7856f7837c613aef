#include "kernel/supervisor/status/machine_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <memory>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/diagnosis/languages.hpp"
#include "ipc/model/machine/active_tool.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/machine/machine_step.hpp"
#include "ipc/requests/start_words.hpp"
#include "ipc/model/languages/wait_name.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/run/scenario_player.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::supervisor {

namespace {

std::string_view state_text(std::uint32_t state) {
    static constexpr std::string_view kNames[] = {"absent", "reset",       "running",
                                                  "held",   "waiting",     "program_stop",
                                                  "ended",  "interrupted", "dead"};
    return state < std::size(kNames) ? kNames[state] : "?";
}
std::string_view mode_text(std::uint32_t mode) {
    static constexpr std::string_view kNames[] = {"auto", "mdi", "jog", "handwheel", "reference"};
    return mode < std::size(kNames) ? kNames[mode] : "?";
}
std::string_view machine_text(std::uint32_t state) {
    return state == 2 ? "on" : state == 1 ? "off" : "emergency_stop";
}
// "ready", or what is to be done next.
std::string step_line(const MachineStatus& status, bool for_people) {
    const MachineStepText& step = machine_step_text(status.step);
    const auto shown = [&](std::string_view text) { return for_people ? say(text) : text; };
    return std::string(shown(step.text)) +
           (step.next.empty() ? "" : ": " + std::string(shown(step.next)));
}
std::string_view restart_text(std::uint32_t restart) {
    static constexpr std::string_view kNames[] = {"none", "searching", "at_block"};
    return restart < std::size(kNames) ? kNames[restart] : "?";
}
std::string_view mdi_text(std::uint32_t state) {
    static constexpr std::string_view kNames[] = {"entered", "runs", "done", "broken_off"};
    return state < std::size(kNames) ? kNames[state] : "?";
}
// What else holds for a channel: driven backwards, by a handwheel, looking for the block of a
// restart.
std::string special_text(const ChannelStatus& channel) {
    std::string out;
    const auto add = [&](std::string_view english) {
        out += "   ";
        out += say(english);
    };
    if (channel.retrace < 0) add("drives backwards");
    if (channel.retrace > 0) add("drives forwards again");
    if ((channel.keys & kKeyRetrace) && channel.retrace >= 0) add("cycle start drives backwards");
    if (channel.by_hand) add("a block entered by hand runs");
    if (channel.mdi_waiting && (channel.mode == static_cast<std::uint32_t>(ChannelMode::Mdi) ||
                                channel.state == static_cast<std::uint32_t>(ChannelState::Held)))
        add("cycle start runs a block entered by hand");
    if (channel.keys & kKeyIgnoreWaits) add("passes its waits over, nobody waits for it");
    if (channel.wheel) add("driven by the handwheel");
    if (channel.keys & kKeySuperpose) add("handwheel superposed");
    if (channel.restart == static_cast<std::uint32_t>(RestartState::Searching))
        add("looks for the block of the restart");
    // it may not start: others are not there, or will not come
    const bool alone = (channel.start_missing & start_bit("restart")) != 0;
    if (channel.restart == static_cast<std::uint32_t>(RestartState::AtBlock))
        add(alone ? "at the block of the restart: others are not at theirs yet"
                  : "at the block of the restart: cycle start approaches");
    else if (alone)
        add("its restart was refused: restart again, or reset");
    return out;
}

// Everything that is shown, copied at one moment.
struct Picture {
    MachineStatus status;
    MachineConfig machine;
    double tick_s = 0.001;
    std::vector<std::pair<std::string, int>> processes;
    std::string program[kMaxChannels];
    std::array<MdiList, kMaxChannels> mdi{};
    std::array<std::int32_t, kMaxChannels> shown_tool{};  // what the PLC says is active; 0 nothing
};

Result<std::unique_ptr<Picture>> take_picture(const std::string& instance) {
    auto supervisor = PeerSegment<SupervisorSegment>::attach(instance);
    if (!supervisor) return supervisor.diagnosis();
    auto kernel = PeerSegment<KernelSegment>::attach(instance);
    if (!kernel) return kernel.diagnosis();
    auto store = PeerSegment<StoreSegment>::attach(instance);
    if (!store) return store.diagnosis();
    // What a killed controller left behind says nothing about now.
    if (!process_lives((*supervisor)->header.writer_pid) ||
        !process_lives((*kernel)->header.writer_pid))
        return Diagnosis{Alarm::SegmentMissing, {}, {}, instance};
    auto picture = std::make_unique<Picture>();
    auto table = std::make_unique<params::Table>();
    if (!(*kernel)->status.read(picture->status) || !(*store)->parameters.read(*table))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    choose_display_language(params::get_text(*table, params::pt_display_language));
    picture->machine = derive_machine_config(*table);
    // P3: constant since the segment was published (the order is stronger than needed)
    picture->tick_s =
        static_cast<double>((*kernel)->tick_ns.load(std::memory_order_acquire)) * 1e-9;
    if (const auto plc = std::make_unique<PlcOutputs>(); (*kernel)->plc_seen.read(*plc))
        for (unsigned number = 1; number <= kMaxChannels; ++number)
            picture->shown_tool[number - 1] = active_tool(*table, *plc, number);
    for (std::size_t slot = 0; slot < kProcesses; ++slot) {
        const ProcessEntry& entry = (*supervisor)->processes[slot];
        // P1: the number of the process was stored before
        if (entry.state.load(std::memory_order_acquire) ==
            static_cast<std::uint32_t>(ProcessState::Running))
            picture->processes.emplace_back(process_name(slot), entry.pid);
    }
    for (unsigned number = 1; number <= kMaxChannels; ++number) {
        if (!picture->machine.channel(number).exists()) continue;
        if (!(*kernel)->mdi[number - 1].read(picture->mdi[number - 1]))
            picture->mdi[number - 1] = {};
        auto channel = PeerSegment<ChannelSegment>::attach(instance, number);
        auto names = std::make_unique<ProgramNames>();
        if (!channel || !(*channel)->programs.read(*names) || names->count == 0) continue;
        // A program that has been selected and has not begun has one name; the number is of the one
        // before it.
        const ChannelStatus& own = picture->status.channels[number - 1];
        const std::uint32_t file =
            own.line && own.file < std::min(names->count, 32u) ? own.file : 0;
        picture->program[number - 1] =
            std::string(&names->name[file * 256], ::strnlen(&names->name[file * 256], 255));
    }
    return picture;
}

}  // namespace

std::vector<std::string> running_instances() {
    std::vector<std::string> out;
    std::error_code none;
    constexpr std::string_view kHead = "polyturn.", kTail = ".supervisor";
    for (const auto& entry : std::filesystem::directory_iterator("/dev/shm", none)) {
        const std::string name = entry.path().filename().string();
        if (name.size() <= kHead.size() + kTail.size() ||
            name.compare(0, kHead.size(), kHead) != 0 ||
            name.compare(name.size() - kTail.size(), kTail.size(), kTail) != 0)
            continue;
        const std::string instance =
            name.substr(kHead.size(), name.size() - kHead.size() - kTail.size());
        if (!valid_instance(instance)) continue;
        // opens nothing of a stranger
        const auto segment = PeerSegment<SupervisorSegment>::attach(instance);
        if (segment && process_lives((*segment)->header.writer_pid)) out.push_back(instance);
    }
    std::sort(out.begin(), out.end());
    return out;
}

Result<std::string> status_json(const std::string& instance) {
    const auto taken = take_picture(instance);
    if (!taken) return taken.diagnosis();
    const Picture& p = **taken;
    const auto number = [](double value) {
        std::string out;
        append_json_number(out, value);
        return out;
    };
    std::string axes = "[", spindles = "[", channels = "[", processes = "[";
    const auto comma = [](std::string& list) {
        if (list.size() > 1) list += ',';
    };
    for (std::size_t i = 0; i < p.machine.last_axis; ++i) {
        const AxisConfig& config = p.machine.axes[i];
        const AxisStatus& axis = p.status.axes[i];
        if (!config.exists()) continue;
        comma(axes);
        axes += fmt::format(
            "{{\"axis\":\"A{}\",\"name\":\"{}\",\"channel\":{},\"cmd\":{},\"act\":{},"
            "\"referenced\":{},\"moving\":{},\"fault\":{},\"overlay\":{},\"compensation\":{}}}",
            i + 1, config.name_text(), config.channel, number(axis.cmd), number(axis.act),
            (axis.flags & kReferenced) != 0, (axis.flags & kMoving) != 0,
            (axis.flags & kDriveFault) != 0, number(axis.overlay), number(axis.compensation));
    }
    for (std::size_t i = 0; i < p.machine.last_spindle; ++i) {
        if (!p.machine.spindles[i].exists()) continue;
        const SpindleStatus& spindle = p.status.spindles[i];
        comma(spindles);
        spindles += fmt::format(
            "{{\"spindle\":\"S{}\",\"command\":{},\"speed\":{},\"angle\":{},\"override\":{},"
            "\"owner\":{}}}",
            i + 1, number(spindle.command), number(spindle.speed), number(spindle.angle),
            number(spindle.override), spindle.owner);
    }
    for (std::size_t i = 0; i < p.machine.last_channel; ++i) {
        if (!p.machine.channels[i].exists()) continue;
        const ChannelStatus& channel = p.status.channels[i];
        comma(channels);
        channels += fmt::format(
            "{{\"ch\":{},\"state\":\"{}\",\"mode\":\"{}\",\"line\":{},\"feed_override\":{},"
            "\"rapid_override\":{},\"wait_code\":{},\"parts\":{},\"cycle\":{},"
            "\"cutting\":{},\"rapid\":{},\"waiting\":{},\"retrace\":{},\"wheel\":{},"
            "\"superposed\":{},\"restart\":\"{}\"",
            i + 1, state_text(channel.state), mode_text(channel.mode), channel.line,
            number(channel.feed_override), number(channel.rapid_override), channel.wait_code,
            channel.parts, number(channel.cycle_s), number(channel.cutting_s),
            number(channel.rapid_s), number(channel.waiting_s), channel.retrace, channel.wheel != 0,
            (channel.keys & kKeySuperpose) != 0, restart_text(channel.restart));
        channels += fmt::format(",\"restart_complete\":{}",
                                (channel.start_missing & start_bit("restart")) == 0);
        channels += fmt::format(",\"language\":\"{}\",\"ignores_waits\":{}",
                                language_name(static_cast<Dialect>(channel.speaks)),
                                (channel.keys & kKeyIgnoreWaits) != 0);
        // of tool management
        if (channel.tool)
            channels +=
                fmt::format(",\"tool\":{},\"tool_offset\":{}", channel.tool, channel.tool_offset);
        if (p.shown_tool[i] > 0) channels += fmt::format(",\"active_tool\":{}", p.shown_tool[i]);
        if (channel.touched)
            channels +=
                fmt::format(",\"touched\":\"A{}{}\",\"{}\":{}", std::abs(channel.touched),
                            channel.touched < 0 ? '-' : '+',
                            channel.touched_at > 2 ? "workpiece_setter" : "setter",
                            channel.touched_at > 2 ? channel.touched_at - 2 : channel.touched_at);
        if (!p.program[i].empty()) {
            channels += ",\"program\":";
            append_json_text(channels, p.program[i]);
        }
        if (const MdiList& list = p.mdi[i]; list.count) {
            channels += ",\"mdi\":[";
            for (std::uint32_t k = 0; k < std::min<std::uint32_t>(list.count, kMdiLines); ++k) {
                channels += k ? ",{\"block\":" : "{\"block\":";
                append_json_text(channels,
                                 {list.lines[k].text.data(),
                                  ::strnlen(list.lines[k].text.data(), list.lines[k].text.size())});
                channels += fmt::format(",\"state\":\"{}\"}}", mdi_text(list.lines[k].state));
            }
            channels += ']';
        }
        channels += '}';
    }
    for (const auto& [name, pid] : p.processes) {
        comma(processes);
        processes += fmt::format("{{\"name\":\"{}\",\"pid\":{}}}", name, pid);
    }
    std::string out = "{\"instance\":";
    append_json_text(out, instance);
    out += fmt::format(
        ",\"machine\":\"{}\",\"step\":\"{}\",\"step_text\":\"{}\",\"seconds\":{},\"alarms\":{},"
        "\"channels\":{}],\"axes\":{}],\"spindles\":{}],\"processes\":{}]}}",
        machine_text(p.status.machine_state), machine_step_text(p.status.step).name,
        step_line(p.status, false), number(static_cast<double>(p.status.tick) * p.tick_s),
        p.status.alarm_count, channels, axes, spindles, processes);
    return out;
}

Result<std::string> status_page(const std::string& instance) {
    const auto taken = take_picture(instance);
    if (!taken) return taken.diagnosis();
    const Picture& p = **taken;
    std::string out =
        fmt::format(fmt::runtime(say("{}: machine {}, {:.1f} s, {} alarms\n")), instance,
                    say(machine_text(p.status.machine_state)),
                    static_cast<double>(p.status.tick) * p.tick_s, p.status.alarm_count);
    out += fmt::format("  {}\n", step_line(p.status, true));
    for (std::size_t i = 0; i < p.machine.last_channel; ++i) {
        if (!p.machine.channels[i].exists()) continue;
        const ChannelStatus& channel = p.status.channels[i];
        out += fmt::format(
            "  L{:<2} {:<12} {:<10} {}{}{}{}\n", i + 1,
            say(channel.state == static_cast<std::uint32_t>(ChannelState::Waiting)
                    ? "waits"
                    : state_text(channel.state)),
            mode_text(channel.mode),
            p.program[i].empty() ? std::string(say("no program"))
                                 : std::filesystem::path(p.program[i]).filename().string(),
            channel.line ? fmt::format(":{}", channel.line) : std::string(),
            channel.wait_code ? fmt::format(fmt::runtime(say("   waits at {}")),
                                            channel.wait_code > 0
                                                ? wait_name(static_cast<Dialect>(channel.speaks),
                                                            channel.wait_code)
                                                : std::to_string(channel.wait_code))
                              : std::string(),
            special_text(channel));
    }
    for (std::size_t i = 0; i < p.machine.last_axis; ++i) {
        const AxisConfig& config = p.machine.axes[i];
        if (!config.exists()) continue;
        const AxisStatus& axis = p.status.axes[i];
        out += fmt::format("  A{:<2} {:<3} L{:<2} {:>12.4f} {}{}{}\n", i + 1, config.name_text(),
                           config.channel, config.diameter ? 2 * axis.act : axis.act,
                           axis.flags & kReferenced ? "" : say("not referenced "),
                           axis.flags & kMoving ? say("moves ") : "",
                           axis.flags & kDriveFault ? say("drive fault") : "");
    }
    for (std::size_t i = 0; i < p.machine.last_spindle; ++i)
        if (p.machine.spindles[i].exists())
            out += fmt::format("  S{:<2} {:>10.1f} 1/min\n", i + 1, p.status.spindles[i].speed);
    out += say("  processes:");
    for (const auto& [name, pid] : p.processes) out += fmt::format(" {} ({})", name, pid);
    return out + "\n";
}

}  // namespace polyturn::supervisor
