// Handlers of cycles: words into what channels/cycles does.
#include "channels/fanuc/cycles/g_cycles.hpp"

#include "channels/cycles/simple_cycles.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/targets.hpp"

namespace polyturn::channels::fanuc {
namespace {

// End point and taper are modal for the three cycles together: a further block names only what
// changes. They are dropped when another code of the group or a one-shot code (but G4) comes, see
// act().
bool cycle_words(Execution& x, cycles::SimpleCycle& cycle, char taper_letter) {
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        cycle.end[i] = x.modal.cycles.simple.set >> i & 1u ? x.modal.cycles.simple.end[i]
                                                           : x.core.path.programmed[i];
    AxisSet named = 0;
    for (unsigned k = 0; k < x.words.axis_count; ++k)
        if (!axis_word(x, x.block.words[x.words.axes[k]], cycle.end, named)) return false;
    if (x.block.has(taper_letter) && !x.settings.series15 &&
        !x.settings.policy.cycles.taper_by_centre)
        return x.core.fail(Alarm::AddressIllegal, taper_letter, std::string(1, taper_letter));
    if (x.block.has('R'))
        x.modal.cycles.simple.taper = radius_length_of(x, 'R');
    else if (x.block.has(taper_letter))
        x.modal.cycles.simple.taper = radius_length_of(x, taper_letter);
    cycle.taper = x.modal.cycles.simple.taper;
    x.modal.cycles.simple.end = cycle.end;
    x.modal.cycles.simple.set |= named;
    return true;
}

}  // namespace

bool g_cycle_turning(Execution& x, const GCode& row) {
    if (!x.words.axis_count) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(x, cycle, 'I')) return false;
    x.core.at.cycle = row.name;
    return cycles::turning(x.core, cycle);
}

bool g_cycle_facing(Execution& x, const GCode& row) {
    if (!x.words.axis_count) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(x, cycle, 'K')) return false;
    x.core.at.cycle = row.name;
    return cycles::facing(x.core, cycle);
}

bool g_cycle_thread(Execution& x, const GCode& row) {
    if (!x.words.axis_count) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(x, cycle, 'I')) return false;
    cycle.thread.lead = x.modal.lead > 0                                   ? x.modal.lead
                        : x.core.path.feed_mode == FeedMode::PerRevolution ? x.core.path.feed
                                                                           : 0.0;
    if (x.block.has('Q') && !x.settings.series15)
        cycle.thread.start_angle =
            x.block.word('Q').has_point || x.settings.policy.words.whole_start_angle
                ? x.block.value('Q')
                : x.block.value('Q') * 0.001;
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    cycle.chamfer = static_cast<double>(params::get(table, params::n1606_thrdchmfr, l)) * 0.1 *
                    cycle.thread.lead;
    const double angle = static_cast<double>(params::get(table, params::n1607_chmfr_ang, l));
    cycle.chamfer_angle = angle > 0 ? angle : 45.0;
    x.core.at.cycle = row.name;
    return cycles::thread(x.core, cycle);
}

}  // namespace polyturn::channels::fanuc
