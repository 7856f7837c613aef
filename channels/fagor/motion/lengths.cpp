#include "channels/fagor/motion/lengths.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/g_codes.hpp"

namespace polyturn::channels::fagor {

double distance(const Execution& x, char letter) { return x.words.number(letter) * x.modal.unit(); }

bool g_units(Execution& x, const GCode& row) {
    x.modal.inch = row.number == 70;
    return true;
}

bool g_x_format(Execution& x, const GCode& row) {
    x.modal.diameter = row.number == 151;
    show_diameter(x);
    return true;
}

bool g_distance(Execution& x, const GCode& row) {
    x.modal.absolute = row.number == 90;
    return true;
}

// Millimetres (X as a radius) or degrees of a programmed number.
double length(const Execution& x, double programmed, int place) {
    const MachineView& view = x.core.view();
    if (place < 0) return programmed * x.modal.unit();
    const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
    if (axis.rotary) return programmed;
    return programmed * x.modal.unit() * (axis.diameter ? 0.5 : 1.0);
}

double from_length(const Execution& x, double true_mm, int place) {
    const MachineView& view = x.core.view();
    if (place < 0) return true_mm / x.modal.unit();
    const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
    if (axis.rotary) return true_mm;
    return true_mm * (axis.diameter ? 2.0 : 1.0) / x.modal.unit();
}

double from_length_plain(const Execution& x, double mm) { return mm / x.modal.unit(); }

void show_diameter(Execution& x) {
    const int place = x.core.view().axis_by_role(PlaneRole::BasicX);
    if (place >= 0) x.core.view().axes[static_cast<std::size_t>(place)].diameter = x.modal.diameter;
}

}  // namespace polyturn::channels::fagor
