// Handlers of cycles: words into what channels/cycles does.
#include "channels/cycles/simple_cycles.hpp"
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

// End point and taper are modal for the three cycles together: a further block names only what
// changes. They are dropped when another code of the group or a one-shot code (but G4) comes, see
// act().
bool Interpreter::cycle_words(cycles::SimpleCycle& cycle, char taper_letter) {
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        cycle.end[i] = cycle_set_ >> i & 1u ? cycle_end_[i] : core_.path.programmed[i];
    AxisSet named = 0;
    for (unsigned k = 0; k < axis_word_count_; ++k)
        if (!axis_word(block_.words[axis_words_[k]], cycle.end, named)) return false;
    if (block_.has(taper_letter) && !settings_.series15 && !settings_.nct)
        return core_.fail(Alarm::AddressIllegal, taper_letter, std::string(1, taper_letter));
    if (block_.has('R'))
        cycle_taper_ = radius_length('R');
    else if (block_.has(taper_letter))
        cycle_taper_ = radius_length(taper_letter);
    cycle.taper = cycle_taper_;
    cycle_end_ = cycle.end;
    cycle_set_ |= named;
    return true;
}

bool Interpreter::g_cycle_turning(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(cycle, 'I')) return false;
    core_.at.cycle = row.name;
    return cycles::turning(core_, cycle);
}

bool Interpreter::g_cycle_facing(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(cycle, 'K')) return false;
    core_.at.cycle = row.name;
    return cycles::facing(core_, cycle);
}

bool Interpreter::g_cycle_thread(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!cycle_words(cycle, 'I')) return false;
    cycle.thread.lead = lead_ > 0                                         ? lead_
                        : core_.path.feed_mode == FeedMode::PerRevolution ? core_.path.feed
                                                                          : 0.0;
    if (block_.has('Q') && !settings_.series15)
        cycle.thread.start_angle = block_.word('Q').has_point || settings_.nct
                                       ? block_.value('Q')
                                       : block_.value('Q') * 0.001;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    cycle.chamfer = static_cast<double>(params::get(table, params::n1606_thrdchmfr, l)) * 0.1 *
                    cycle.thread.lead;
    const double angle = static_cast<double>(params::get(table, params::n1607_chmfr_ang, l));
    cycle.chamfer_angle = angle > 0 ? angle : 45.0;
    core_.at.cycle = row.name;
    return cycles::thread(core_, cycle);
}

}  // namespace polyturn::channels::fanuc
