#include "ipc/model/machine/store/job_differences.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "ipc/model/files/read_file.hpp"

namespace polyturn {
namespace {
constexpr double kSameValue = 1e-6;  // mm, degrees: less is how a number is written

const ChannelStore* store_of(const MachineConfig& machine, const StoreOf& store, unsigned channel) {
    return channel >= 1 && channel <= kMaxChannels && machine.channel(channel).exists()
               ? store(channel)
               : nullptr;
}

}  // namespace

// NaN is never the same
bool JobZero::same() const { return std::fabs(wanted - entered) <= kSameValue; }
bool JobOffset::Value::same() const { return std::fabs(wanted - entered) <= kSameValue; }
bool JobOffset::same() const {
    return std::all_of(values.begin(), values.end(), [](const Value& one) { return one.same(); });
}

std::vector<JobZero> job_zeros(const text::Job& job, const text::Setup& setup,
                               const MachineConfig& machine, const StoreOf& store) {
    auto wanted = job.zeros;
    for (const auto& [channel, own] : setup.channels)
        for (const auto& [system, axes] : own.work)
            for (const auto& [name, value] : axes) wanted[channel][system][name] = value;
    std::vector<JobZero> out;
    for (const auto& [channel, systems] : wanted) {
        const ChannelStore* has = store_of(machine, store, channel);
        for (const auto& [system, axes] : systems)
            for (const auto& [name, value] : axes) {
                const auto row = work_zero_row(system);
                const AxisConfig* axis = has ? find_axis(machine, channel, name) : nullptr;
                out.push_back({channel, system, name, value,
                               row && axis ? has->zeros[*row * kChannelAxes + axis->slot]
                                           : std::numeric_limits<double>::quiet_NaN()});
            }
    }
    return out;
}

// What a setup enters into an offset: apply_setup.cpp.
std::vector<JobOffset> job_offsets(const text::Setup& setup, const MachineConfig& machine,
                                   const StoreOf& store) {
    std::vector<JobOffset> out;
    for (const auto& [channel, own] : setup.channels) {
        const ChannelStore* has = own.offsets.empty() ? nullptr : store_of(machine, store, channel);
        for (const auto& [number, offset] : own.offsets) {
            const OffsetCell* cell =
                has && number >= 1 && static_cast<std::size_t>(number) < kOffsets
                    ? &has->offsets[static_cast<std::size_t>(number)]
                    : nullptr;
            JobOffset one{channel, number, {}};
            const auto add = [&](std::string_view name, bool wear,
                                 const std::optional<double>& wanted, double entered) {
                if (wanted)
                    one.values.push_back(
                        {name, wear, *wanted,
                         cell ? entered : std::numeric_limits<double>::quiet_NaN()});
            };
            const OffsetCell none{};
            const OffsetCell& at = cell ? *cell : none;
            add("X", false, offset.geometry.x, at.geometry[0]);
            add("Y", false, offset.geometry.y, at.geometry[1]);
            add("Z", false, offset.geometry.z, at.geometry[2]);
            add("R", false, offset.geometry.r, at.geometry_r);
            add("T", false, offset.geometry.t ? offset.geometry.t : offset.wear.t, at.tip);
            add("X", true, offset.wear.x, at.wear[0]);
            add("Y", true, offset.wear.y, at.wear[1]);
            add("Z", true, offset.wear.z, at.wear[2]);
            add("R", true, offset.wear.r, at.wear_r);
            out.push_back(std::move(one));
        }
    }
    return out;
}

bool for_another_machine(const text::Job& job, const std::string& base) {
    if (job.machine.empty() || base.empty()) return false;
    const auto named = text::resolve_machine(job.machine);
    if (!named) return true;
    std::error_code none;
    const std::string running = base + ".params";
    if (std::filesystem::equivalent(named->params, running, none)) return false;
    // a copy is the same machine
    const auto wanted = text::read_text_file(named->params), here = text::read_text_file(running);
    return !wanted || !here || *wanted != *here;
}

}  // namespace polyturn
