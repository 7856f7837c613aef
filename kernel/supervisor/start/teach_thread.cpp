#include "kernel/supervisor/start/teach_thread.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "ipc/image/segments.hpp"
#include "ipc/memory/segment.hpp"

namespace polyturn::supervisor {
namespace {

constexpr std::string_view kWord = "teach_thread";

Diagnosis refused(std::string why) { return {Alarm::PressArgument, {}, {}, std::move(why)}; }

}  // namespace

bool is_teach_thread(std::string_view words) { return words.starts_with(kWord); }

Result<std::vector<std::string>> teach_thread(std::string_view words, const MachineStatus& status,
                                              const MachineConfig& machine,
                                              const params::Table& table) {
    std::string_view rest = words.substr(kWord.size());
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    const bool off = rest.ends_with("=off");
    if (off) rest.remove_suffix(4);
    unsigned channel = 0;
    if (rest.empty() || rest.front() != 'L' ||
        std::from_chars(rest.data() + 1, rest.data() + rest.size(), channel).ptr !=
            rest.data() + rest.size() ||
        channel < 1 || channel > kMaxChannels || !machine.channel(channel).exists())
        return refused(fmt::format("'{}': teach_thread L1, or teach_thread L1=off", words));
    if (off) return std::vector<std::string>{fmt::format("PT_THREAD_PICKUP L{}=0", channel)};
    unsigned axis = 0;
    for (unsigned a = 1; a <= kMaxAxes && !axis; ++a)
        if (params::get(table, params::n0002_axis_assign, a) == channel &&
            params::get(table, params::n0103_axis_to_plane, a) == 3)
            axis = a;
    if (!axis) return refused(fmt::format("L{} has no Z", channel));
    auto spindle =
        static_cast<unsigned>(params::get(table, params::n0604_default_spindle, channel));
    for (unsigned s = 1; s <= kMaxSpindles; ++s)
        if (status.spindles[s - 1].owner == channel) {
            spindle = s;
            break;
        }
    if (spindle < 1 || spindle > kMaxSpindles)
        return refused(fmt::format("L{} has no spindle (N0604)", channel));
    const AxisStatus& z = status.axes[axis - 1];
    const double unit = machine.channel(channel).inch ? 25.4 : 1.0;
    return std::vector<std::string>{
        fmt::format("PT_THREAD_ANGLE L{}={:.6f}", channel, status.spindles[spindle - 1].angle),
        fmt::format("PT_THREAD_AT L{}={:.6f}", channel, z.act / unit),
        fmt::format("PT_THREAD_PICKUP L{}=1", channel)};
}

Result<std::vector<std::string>> teach_thread(std::string_view words, const std::string& instance) {
    auto kernel = PeerSegment<KernelSegment>::attach(instance);
    if (!kernel) return kernel.diagnosis();
    auto store = PeerSegment<StoreSegment>::attach(instance);
    if (!store) return store.diagnosis();
    auto status = std::make_unique<MachineStatus>();
    auto table = std::make_unique<params::Table>();
    if (!(*kernel)->status.read(*status) || !(*store)->parameters.read(*table))
        return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
    return teach_thread(words, *status, derive_machine_config(*table), *table);
}

}  // namespace polyturn::supervisor
