#include "channels/fagor/grammar/axis_places.hpp"

#include <string>

#include "channels/fagor/settings.hpp"

namespace polyturn::channels::fagor {

AxisPlaces::AxisPlaces(const MachineView& view) {
    of_letter_.fill(-1);
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const std::string& name = view.axes[i].name;
        if (name.size() == 1 && axis_number(name[0]))
            of_letter_[static_cast<std::size_t>(name[0] - 'A')] = static_cast<std::int8_t>(i);
    }
}

}  // namespace polyturn::channels::fagor
