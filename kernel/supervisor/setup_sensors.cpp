#include "kernel/supervisor/setup_sensors.hpp"

#include <fmt/format.h>

#include "ipc/machine/named_inputs.hpp"

namespace polyturn::supervisor {

std::vector<Command> sensor_commands(const text::Setup& setup, const MachineConfig& machine) {
    std::vector<Command> out;
    for (const auto& [number, channel] : setup.channels)
        for (const text::SensorSetup& sensor : channel.sensors) {
            const AxisConfig* axis = find_axis(machine, number, sensor.axis);
            const auto input = input_by_name(sensor.input, number);
            if (!axis || !input) continue;
            Command command{};
            command.kind = static_cast<std::uint32_t>(CommandKind::Sensor);
            command.object = axis->number;
            command.flags = *input;
            command.channel = sensor.direction > 0 ? 1 : sensor.direction < 0 ? 2 : 0;
            command.value = axis->diameter ? sensor.at / 2.0 : sensor.at;
            out.push_back(command);
        }
    return out;
}

void check_sensors(const text::Setup& setup, const MachineConfig& machine, std::vector<Diagnosis>& diagnoses) {
    for (const auto& [number, channel] : setup.channels)
        for (const text::SensorSetup& sensor : channel.sensors) {
            const auto wrong = [&](std::string what) { diagnoses.push_back({Alarm::SetupEntry, {setup.file, 0, 0, 0}, {}, fmt::format("channel {}: sensor {}: {}", number, sensor.input, what)}); };
            if (!find_axis(machine, number, sensor.axis)) wrong("there is no axis " + sensor.axis);
            if (!input_by_name(sensor.input, number)) wrong(fmt::format("inputs are 0 to {}, SKIP, SKIP2 to SKIP4, XAE, YAE, ZAE", kFirstNamedInput - 1));
        }
}

}  // namespace polyturn::supervisor
