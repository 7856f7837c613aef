#include "kernel/supervisor/run/start_position.hpp"

#include <algorithm>
#include <filesystem>

#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::supervisor {

namespace {

// The zero offsets that act when a program starts, as the language's power-on state has them: `pos`
// is counted from there.
double active_zero(const text::ChannelSetup& channel, Dialect dialect, const std::string& axis) {
    double sum = 0.0;
    for (const auto& [system, values] : channel.work) {
        const auto row = work_zero_row(system);
        const auto value = values.find(axis);
        if (!row || value == values.end()) continue;
        // external, G54, work shift
        const bool acts = dialect == Dialect::Fanuc || dialect == Dialect::Nct
                              ? *row == 0 || *row == 1 || *row == 7
                          : dialect == Dialect::Sinumerik ? *row == *work_zero_row("G500")
                          : dialect == Dialect::Mefi      ? *row == *work_zero_row("G53")
                                                     // Fagor: machine zero until a program selects
                                                     // one
                                                     : false;
        if (acts) sum += value->second;
    }
    return sum;
}

}  // namespace

void set_machine_files(const std::string& params_file, RunOptions& options) {
    const std::string base =
        std::filesystem::absolute(std::filesystem::path(params_file).replace_extension()).string();
    if (base.size() < options.machine_folder.size())
        std::copy(base.begin(), base.end(), options.machine_folder.begin());
}

void set_start_positions(const JobPlan& plan, RunOptions& options) {
    const auto put = [&](unsigned channel, const std::string& name, double shown) {
        const AxisConfig* axis = find_axis(*plan.machine, channel, name);
        if (!axis) return;
        options.start_known[axis->number - 1u] = 1;
        options.start_position[axis->number - 1u] =
            plan.shows_diameter(channel, *axis) ? shown / 2.0 : shown;
    };
    for (const auto& [number, channel] : plan.setup.channels) {
        for (const auto& [axis, value] : channel.machine) put(number, axis, value);
        for (const auto& [axis, value] : channel.pos)
            put(number, axis, value + active_zero(channel, plan.dialect(number), axis));
    }
}

}  // namespace polyturn::supervisor
