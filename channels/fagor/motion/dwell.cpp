#include "channels/fagor/motion/dwell.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"

namespace polyturn::channels::fagor {

bool g_dwell(Execution& x, const GCode&) {
    const bool alone = x.line.block.count == (x.words.bound_number ? 2u : 1u);
    if (ends_reading(x)) {
        if (!alone) return x.fail(Alarm::FagorAlone, 'G', "G04");
        x.core.mark_emitted();
        x.core.asks_at(x.calls.here().file, x.line.at.offset);
        x.core.sink().barrier(x.core.at);
        x.run.wants_barrier = true;
        return true;
    }
    std::int64_t hundredths = 0;
    if (!whole(x, *x.words.bound_number, hundredths)) return false;
    if (hundredths > 99'999)
        return x.fail_word(*x.words.bound_number, Alarm::FagorValueRange, "K",
                           static_cast<double>(hundredths));
    // each G04 ends the block before it square, as if nothing followed (fagor_8037t part 1, 7.1)
    x.core.suspend_for(0);
    return x.core.dwell(static_cast<double>(hundredths) / 100.0, false);
}

// G04 without K, or with K0, interrupts the preparation of blocks; with K it is a dwell (7.1).
bool ends_reading(const Execution& x) {
    return !x.words.bound_number || x.words.bound_number->value == 0;
}

}  // namespace polyturn::channels::fagor
