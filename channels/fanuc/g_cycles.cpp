// Handlers of cycles: words into what channels/cycles does.
#include "channels/cycles/simple_cycles.hpp"
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

bool Interpreter::g_cycle_turning(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!read_axis_words(cycle.end)) return false;
    cycle.taper = block_.has('R') ? radius_length('R') : radius_length('I');
    core_.at.cycle = row.name;
    return cycles::turning(core_, cycle);
}

bool Interpreter::g_cycle_facing(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!read_axis_words(cycle.end)) return false;
    cycle.taper = block_.has('R') ? radius_length('R') : radius_length('K');
    core_.at.cycle = row.name;
    return cycles::facing(core_, cycle);
}

bool Interpreter::g_cycle_thread(const GCode& row) {
    if (!axis_word_count_) return true;
    cycles::SimpleCycle cycle;
    if (!read_axis_words(cycle.end)) return false;
    cycle.taper = block_.has('R') ? radius_length('R') : radius_length('I');
    cycle.thread.lead = lead_ > 0 ? lead_ : core_.path.feed_mode == FeedMode::PerRevolution ? core_.path.feed : 0.0;
    if (block_.has('Q') && !settings_.series15) cycle.thread.start_angle = block_.word('Q').has_point || settings_.nct ? block_.value('Q') : block_.value('Q') * 0.001;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    cycle.chamfer = static_cast<double>(params::get(table, params::n1606_thrdchmfr, l)) * 0.1 * cycle.thread.lead;
    const double angle = static_cast<double>(params::get(table, params::n1607_chmfr_ang, l));
    cycle.chamfer_angle = angle > 0 ? angle : 45.0;
    core_.at.cycle = row.name;
    return cycles::thread(core_, cycle);
}

}  // namespace polyturn::channels::fanuc
