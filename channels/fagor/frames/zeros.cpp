#include "channels/fagor/frames/zeros.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/tools/spindle.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::fagor {

bool g_zero(Execution& x, const GCode& row) {
    const auto number = row.number;
    // added to the absolute one of the table; a preset is the other of two ways and ends (4.4)
    if (number >= 58) {
        if (x.modal.zero == 92) {
            x.core.clear_preset();
            x.modal.zero = 0;
        }
        x.modal.zero_added = number;
        const auto& zeros = x.core.view().store->zeros;
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            x.core.local_zero(i, zeros[static_cast<std::size_t>(number - 53) * kChannelAxes + i]);
        return true;
    }
    x.core.clear_preset();
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) x.core.local_zero(i, 0.0);
    x.modal.zero = number;
    x.modal.zero_added = 0;
    x.core.select_zero(number - 53);
    return true;
}

bool g_zero_table(Execution& x, const GCode&) {
    if (!x.words.bound_number) return x.fail(Alarm::FagorMotionWord, 'G', "N", 159);
    std::int64_t n = 0;
    if (!whole(x, *x.words.bound_number, n)) return false;
    const auto row =
        n >= 1 && n <= 20 ? settable_zero_row(static_cast<std::size_t>(n)) : std::nullopt;
    if (!row)
        return x.fail_word(*x.words.bound_number, Alarm::FagorValueRange, "N",
                           static_cast<double>(n));
    x.core.clear_preset();
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) x.core.local_zero(i, 0.0);
    x.modal.zero = 159;
    x.modal.zero_number = static_cast<std::uint16_t>(n);
    x.modal.zero_added = 0;
    x.core.select_zero(static_cast<std::int32_t>(*row));
    return true;
}

// G92: the present point gets these coordinates; with S the highest spindle speed.
bool g_preset(Execution& x, const GCode&) {
    if (x.words.has('S')) {
        if (x.words.has_axes()) return x.fail(Alarm::FagorAlone, 'S', "G92 S");
        x.modal.speed_limit = x.words.number('S');
        return x.words.number('S') >= 0 ? limit_surface_speed(x, true) && x.core.commit_spindle()
                                        : x.core.spindle_limit(x.words.number('S'));
    }
    if (!x.words.has_axes()) return x.fail(Alarm::CoordinateAxisNone, 'G', "G92");
    x.core.hold_zeros_as_preset();
    x.modal.zero = 92;
    x.modal.zero_added = 0;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (x.words.axis[i])
            x.core.preset(i, length(x, x.words.axis[i]->value, static_cast<int>(i)) +
                                 (x.core.path.framed ? 0.0 : x.core.path.vector[i]));
    return true;
}

void refresh_zero(Execution& x) {
    x.core.load_zeros();
    x.core.refresh_surface_zero();
}

}  // namespace polyturn::channels::fagor
