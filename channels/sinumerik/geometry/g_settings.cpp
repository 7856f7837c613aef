// G commands that set modes: units, plane, dimensions, feed types, diameters, exact stop, settable
// zeros. And F, FB, FZ.
#include "channels/sinumerik/geometry/g_settings.hpp"

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
bool g_units(Execution&, const GCode&) { return true; }
bool g_distance(Execution&, const GCode&) { return true; }
bool g_diameter(Execution&, const GCode&) { return true; }

bool g_plane(Execution& x, const GCode& code) {
    const auto plane = static_cast<Plane>(code.number - 1);
    if (x.core.path.plane == plane) return true;
    if (x.core.compensating()) return fail(x, Alarm::CompPlaneChanged);
    x.core.path.plane = plane;
    apply_tool(x);  // lengths lie along other axes now
    return true;
}

bool g_exact_stop(Execution& x, const GCode& code) {
    x.core.path.exact_stop_mode = code.number == 1;
    return true;
}

bool g_exact_once(Execution& x, const GCode&) {
    x.core.force_exact_stop();
    return true;
}

bool g_zero(Execution& x, const GCode& code) {
    const int n = code.number - 1;  // $P_UIFR[n]
    if (n >= x.settings.frames) return fail(x, Alarm::GCodeUnknown, std::string(code.name));
    const auto row =
        n == 0 ? work_zero_row("G500") : settable_zero_row(static_cast<std::size_t>(n));
    if (!row) return fail(x, Alarm::GCodeUnknown, std::string(code.name));
    choose_settable(x, n, static_cast<std::int32_t>(*row));
    return true;
}

bool a_axis_diameter(Execution& x, const Word& word) {
    const auto i = static_cast<std::size_t>(word.axis);
    const std::string_view name = word.address->name;
    const bool released = (params::get(x.core.view().table(), params::md30460,
                                       x.core.view().axes[i].machine_axis + 1u) &
                           4) != 0;
    if (x.core.view().axes[i].rotary || !released)
        return fail_word(x, Alarm::AxisKindWrong, word, axis_name(x, word.axis));
    x.modal.axis_diameter[i] = name == "DIAMONA"     ? 2
                               : name == "DIAM90A"   ? 3
                               : name == "DIAMOFA"   ? 1
                               : name == "DIACYCOFA" ? 4
                                                     : kAsChannel;
    x.core.at.display_swapped = display_swapped(x);
    return true;
}
bool p_diamchan(Execution& x, Call&) {  // all released axes as DIAMCHANA (9.3.7)
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        const bool released = (params::get(x.core.view().table(), params::md30460,
                                           x.core.view().axes[i].machine_axis + 1u) &
                               4) != 0;
        x.modal.axis_diameter[i] = released && !x.core.view().axes[i].rotary ? kAsChannel : 0;
    }
    x.core.at.display_swapped = display_swapped(x);
    return true;
}
}  // namespace polyturn::channels::sinumerik
