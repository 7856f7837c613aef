#include "ipc/model/machine/drive_sources.hpp"

#include "ipc/capacities.hpp"

namespace polyturn {

DriveSources wanted_drives(const params::Table& table) {
    using namespace params;
    DriveSources wanted;
    const auto ask = [&](std::int64_t source) {
        wanted.library = wanted.library || source == 1;
        wanted.process = wanted.process || source == 2;
    };
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        const auto channel = get(table, n0002_axis_assign, a);
        if (channel >= 1 && channel <= static_cast<std::int64_t>(kMaxChannels))
            ask(get(table, pt_drive, a));
    }
    for (unsigned s = 1; s <= kMaxSpindles; ++s)
        if (bit(table, n0607_spindle_config, s, 0)) ask(get(table, pt_spindle_drive, s));
    return wanted;
}

}  // namespace polyturn
