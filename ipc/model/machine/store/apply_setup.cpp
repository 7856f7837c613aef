#include "ipc/model/machine/store/apply_setup.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "ipc/requests/store_requests.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn {
namespace {

struct Entry {
    const text::Setup& setup;
    const MachineConfig& machine;
    unsigned channel;
    std::vector<Diagnosis>& diagnoses;

    void wrong(const std::string& what) const {
        diagnoses.push_back(Diagnosis{Alarm::SetupEntry,
                                      {setup.file, 0, 0, 0},
                                      {},
                                      "channel " + std::to_string(channel) + ": " + what});
    }
};

void put(double& to, const std::optional<double>& from) {
    if (from) to = *from;
}

void apply_offsets(const Entry& entry, const text::ChannelSetup& from, ChannelStore& store) {
    for (const auto& [number, offset] : from.offsets) {
        if (number < 1 || static_cast<std::size_t>(number) >= kOffsets) {
            entry.wrong("offset " + std::to_string(number) + ": numbers are 1 to " +
                        std::to_string(kOffsets - 1));
            continue;
        }
        OffsetCell& cell = store.offsets[static_cast<std::size_t>(number)];
        put(cell.geometry[0], offset.geometry.x);
        put(cell.geometry[1], offset.geometry.y);
        put(cell.geometry[2], offset.geometry.z);
        put(cell.geometry_r, offset.geometry.r);
        put(cell.wear[0], offset.wear.x);
        put(cell.wear[1], offset.wear.y);
        put(cell.wear[2], offset.wear.z);
        put(cell.wear_r, offset.wear.r);
        put(cell.tip, offset.geometry.t ? offset.geometry.t : offset.wear.t);
    }
}

void apply_zeros(const Entry& entry, const text::ChannelSetup& from, ChannelStore& store) {
    for (const auto& [name, values] : from.work) {
        const auto row = work_zero_row(name);
        if (!row) {
            entry.wrong("there is no zero offset " + name);
            continue;
        }
        for (const auto& [axis_name, value] : values) {
            const AxisConfig* axis = find_axis(entry.machine, entry.channel, axis_name);
            if (axis)
                store.zeros[*row * kChannelAxes + axis->slot] = value;
            else
                entry.wrong(name + ": there is no axis " + axis_name);
        }
    }
}

void apply_variables(const text::ChannelSetup& from, ChannelStore& store) {
    for (const text::SetupVariable& variable : from.variables)
        if (const auto index = kept_variable(variable.name); index && !variable.is_text)
            store.variables[*index] = variable.value;
}

}  // namespace

void clear_channel_store(ChannelStore& store) {
    std::memset(static_cast<void*>(&store), 0, sizeof store);
    store.variables.fill(std::numeric_limits<double>::quiet_NaN());
}

void apply_setup(const text::Setup& setup, const MachineConfig& machine, unsigned number,
                 ChannelStore& store, std::vector<Diagnosis>& diagnoses) {
    const Entry entry{setup, machine, number, diagnoses};
    const text::ChannelSetup& from = setup.channel(number);
    apply_offsets(entry, from, store);
    apply_zeros(entry, from, store);
    apply_variables(from, store);
}

}  // namespace polyturn
