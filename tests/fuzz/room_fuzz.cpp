// libs: polyturn_machine
// Whatever is read as a room, or applied as a setup to a machine, ends in values and in diagnoses.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/machine/store/apply_setup.hpp"

namespace {

const polyturn::MachineConfig& two_channels() {
    static const polyturn::MachineConfig machine = [] {
        using namespace polyturn::params;
        auto table = std::make_unique<Table>();
        set_defaults(*table);
        for (unsigned l = 1; l <= 2; ++l) put(*table, n0000_machine_group, 1, l);
        for (unsigned a = 1; a <= 4; ++a) {
            put(*table, n0002_axis_assign, 1 + (a - 1) / 2, a);
            put(*table, n0100_axis_name1, a % 2 ? 'X' : 'Z', a);
        }
        put(*table, n0607_spindle_config, 7, 1);
        return polyturn::derive_machine_config(*table);
    }();
    return machine;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<polyturn::Diagnosis> diagnoses;
    const polyturn::Room room = polyturn::parse_room(text, "fuzz.toml", two_channels(), diagnoses);
    for (const auto& [number, place] : room.axes)
        if (!two_channels().axis(number).exists() || !std::isfinite(place.direction.x))
            std::abort();
    const polyturn::text::Setup setup = polyturn::text::parse_setup(text, "fuzz.toml", diagnoses);
    static polyturn::ChannelStore store;
    polyturn::clear_channel_store(store);
    for (const auto& [number, channel] : setup.channels)
        if (number >= 1 && number <= 2)
            polyturn::apply_setup(setup, two_channels(), number, store, diagnoses);
    if (store.offsets[0].geometry[0] != 0.0) std::abort();
    for (const auto& diagnosis : diagnoses)
        if (diagnosis.text().empty() || diagnosis.remedy().empty()) std::abort();
    return 0;
}
