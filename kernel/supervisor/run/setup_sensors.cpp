#include "kernel/supervisor/run/setup_sensors.hpp"

#include <fmt/format.h>

#include <charconv>

#include "ipc/model/machine/named_inputs.hpp"

namespace polyturn::supervisor {
namespace {

// "S2": its number, where the machine has it; 0: no spindle.
unsigned spindle_number(std::string_view name, const MachineConfig& machine) {
    unsigned number = 0;
    if (name.size() < 2 || name[0] != 'S') return 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size()) return 0;
    return number >= 1 && number <= kMaxSpindles && machine.spindle(number).exists() ? number : 0;
}

}  // namespace

std::vector<Command> sensor_commands(const JobPlan& plan) {
    const MachineConfig& machine = *plan.machine;
    std::vector<Command> out;
    for (const auto& [number, channel] : plan.setup.channels)
        for (const text::SensorSetup& sensor : channel.sensors) {
            const AxisConfig* axis = find_axis(machine, number, sensor.axis);
            const auto input = input_by_name(sensor.input, number);
            const unsigned spindle = axis ? 0 : spindle_number(sensor.axis, machine);
            if ((!axis && !spindle) || !input) continue;
            Command command{};
            command.kind = static_cast<std::uint32_t>(CommandKind::Sensor);
            command.object = axis ? axis->number : static_cast<std::uint32_t>(kMaxAxes + spindle);
            command.flags = *input;
            command.channel = sensor.direction > 0 ? 1 : sensor.direction < 0 ? 2 : 0;
            command.value =
                axis && plan.shows_diameter(number, *axis) ? sensor.at / 2.0 : sensor.at;
            out.push_back(command);
        }
    return out;
}

void check_sensors(const text::Setup& setup, const MachineConfig& machine,
                   std::vector<Diagnosis>& diagnoses) {
    for (const auto& [number, channel] : setup.channels)
        for (const text::SensorSetup& sensor : channel.sensors) {
            const auto wrong = [&](std::string what) {
                diagnoses.push_back(
                    {Alarm::SetupEntry,
                     {setup.file, 0, 0, 0},
                     {},
                     fmt::format("channel {}: sensor {}: {}", number, sensor.input, what)});
            };
            if (!find_axis(machine, number, sensor.axis) && !spindle_number(sensor.axis, machine))
                wrong("there is no axis " + sensor.axis);
            if (!input_by_name(sensor.input, number))
                wrong(fmt::format("inputs are 0 to {}, SKIP, SKIP2 to SKIP4, XAE, YAE, ZAE",
                                  kFirstNamedInput - 1));
        }
}

}  // namespace polyturn::supervisor
