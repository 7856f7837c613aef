#include "ipc/machine/job_differences.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include "ipc/machine/work_zeros.hpp"
#include "ipc/text/machine_path.hpp"
#include "ipc/text/read_file.hpp"

namespace polyturn {
namespace {
constexpr double kSameZero = 1e-6;   // mm, degrees: less is how a number is written
}

bool JobZero::same() const { return std::fabs(wanted - entered) <= kSameZero; }   // NaN is never the same

std::vector<JobZero> job_zeros(const text::Job& job, const MachineConfig& machine, const std::function<const ChannelStore*(unsigned)>& store) {
    std::vector<JobZero> out;
    for (const auto& [channel, systems] : job.zeros) {
        const ChannelStore* has = channel >= 1 && channel <= kMaxChannels && machine.channel(channel).exists() ? store(channel) : nullptr;
        for (const auto& [system, axes] : systems)
            for (const auto& [name, wanted] : axes) {
                const auto row = work_zero_row(system);
                const AxisConfig* axis = has ? find_axis(machine, channel, name) : nullptr;
                out.push_back({channel, system, name, wanted, row && axis ? has->zeros[*row * kChannelAxes + axis->slot] : std::numeric_limits<double>::quiet_NaN()});
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
    const auto wanted = text::read_text_file(named->params), here = text::read_text_file(running);   // a copy is the same machine
    return !wanted || !here || *wanted != *here;
}

}  // namespace polyturn
