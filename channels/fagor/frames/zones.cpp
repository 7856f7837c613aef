#include "channels/fagor/frames/zones.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"

namespace polyturn::channels::fagor {

bool g_zone_limit(Execution& x, const GCode& row) {
    if (!x.words.has('K')) return x.fail(Alarm::FagorMotionWord, 'G', "K", row.number);
    std::int64_t zone = 0;
    if (!whole(x, *x.words.word('K'), zone)) return false;
    if (zone < 1 || zone > 4)
        return x.fail(Alarm::FagorValueRange, 'K', "K", static_cast<double>(zone));
    if (!x.words.has_axes())
        return x.fail(Alarm::CoordinateAxisNone, 'G', row.number == 20 ? "G20" : "G21");
    WorkZone& to = x.core.path.zones[static_cast<std::size_t>(zone - 1)];
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (!x.words.axis[i]) continue;
        const double value =
            x.words.axis[i]->value * (x.core.view().axes[i].rotary ? 1.0 : x.modal.unit());
        (row.number == 20 ? to.low : to.high)[i] = value;
        (row.number == 20 ? to.has_low : to.has_high) |= 1u << i;
    }
    return true;
}

bool g_zone(Execution& x, const GCode&) {
    for (const char letter : {'K', 'S'})
        if (!x.words.has(letter))
            return x.fail(Alarm::FagorMotionWord, 'G', std::string(1, letter), 22);
    std::int64_t zone = 0, state = 0;
    if (!whole(x, *x.words.word('K'), zone) || !whole(x, *x.words.word('S'), state)) return false;
    if (zone < 1 || zone > 4)
        return x.fail(Alarm::FagorValueRange, 'K', "K", static_cast<double>(zone));
    if (state > 2) return x.fail(Alarm::FagorValueRange, 'S', "S", static_cast<double>(state));
    x.core.path.zones[static_cast<std::size_t>(zone - 1)].guard =
        static_cast<WorkZone::Guard>(state);
    return true;
}

}  // namespace polyturn::channels::fagor
