// G74, G75, G76: words of two blocks (series 15: of one) into what channels/cycles does.
#include <cmath>

#include "channels/cycles/grooving.hpp"
#include "channels/cycles/thread_passes.hpp"
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

// P and Q as lengths: without a point they count the least increment, also where other words are
// whole millimetres.
double Interpreter::fine_length(char letter) const {
    if (!block_.has(letter)) return 0.0;
    const Word& word = block_.word(letter);
    if (word.has_point || word.from_expression) return length(word, -1);
    const double increment = core_.view().axes[0].increment * (inch_ ? 0.1 : 1.0);
    return word.value * increment * unit_;
}

bool Interpreter::g_grooving(const GCode& row) {
    if (!turning_cycles_available(row)) return false;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    const int z = core_.view().axis_by_role(PlaneRole::BasicZ),
              x = core_.view().axis_by_role(PlaneRole::BasicX);
    if (z < 0 || x < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    if (!axis_word_count_ && !settings_.series15 && first_of_two()) {
        keep_word(cycle_data_.peck_return, 'R');
        return true;
    }
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    AxisSet named = 0;
    if (!read_axis_words(target_, &named)) return false;
    if (named & ~(1u << x | 1u << z)) return core_.fail(Alarm::PlaneAxisIllegal, 'G', "X, Z");
    cycles::Grooving cycle;
    cycle.along_x = row.tenths == (settings_.system == kC ? 770 : 750);
    if (!(named >> (cycle.along_x ? x : z) & 1u))
        return core_.fail(Alarm::CycleWordMissing, 'G', cycle.along_x ? "X" : "Z");
    cycle.end = {target_[static_cast<std::size_t>(z)], target_[static_cast<std::size_t>(x)]};
    cycle.retract = std::fabs(
        cycle_data_.peck_return.value_or(params::get(table, params::n1605_retr_g74_g75, l) * unit));
    // P, I belong to X; Q, K to Z; the other words to neither format.
    const char along_x = settings_.series15 ? 'I' : 'P', along_z = settings_.series15 ? 'K' : 'Q',
               aside = settings_.series15 ? 'D' : 'R';
    for (const char foreign : {settings_.series15 ? 'P' : 'I', settings_.series15 ? 'Q' : 'K',
                               settings_.series15 ? 'R' : 'D'})
        if (block_.has(foreign))
            return core_.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    const double by_x = fine_length(along_x), by_z = fine_length(along_z);
    cycle.peck = cycle.along_x ? by_x : by_z;
    cycle.row = cycle.along_x ? by_z : by_x;
    cycle.peck_letter = cycle.along_x ? along_x : along_z;
    cycle.row_letter = cycle.along_x ? along_z : along_x;
    double count = 0.0;
    if (aside == 'D' && block_.has('D') && !series15_count('D', count)) return false;
    cycle.relief = aside == 'D' ? fine_length('D') : radius_length('R');
    core_.at.cycle = row.name;
    return cycles::cut_grooves(core_, cycle);
}

bool Interpreter::g_thread_passes(const GCode& row) {
    if (!turning_cycles_available(row)) return false;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    const int z = core_.view().axis_by_role(PlaneRole::BasicZ),
              x = core_.view().axis_by_role(PlaneRole::BasicX);
    if (z < 0 || x < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    CycleData& data = cycle_data_;
    if (!axis_word_count_ && !settings_.series15) {
        if (block_.has('P')) {  // nnrraa
            std::int64_t fields = 0;
            if (!whole('P', fields)) return false;
            if (fields > 999'999)
                return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(fields));
            data.thread_passes = static_cast<double>(fields / 10'000);
            data.thread_chamfer = static_cast<double>(fields / 100 % 100);
            data.tool_angle = static_cast<double>(fields % 100);
        } else if (settings_.nct) {
            data.thread_passes.reset();
            data.thread_chamfer.reset();
            data.tool_angle.reset();
        }
        if (block_.has('Q'))
            data.least_infeed = fine_length('Q');
        else if (settings_.nct)
            data.least_infeed.reset();
        keep_word(data.thread_allowance, 'R');
        return true;
    }
    AxisSet named = 0;
    if (!read_axis_words(target_, &named)) return false;
    if (named & ~(1u << x | 1u << z)) return core_.fail(Alarm::PlaneAxisIllegal, 'G', "X, Z");
    if (!(named >> z & 1u) || !(named >> x & 1u))
        return core_.fail(Alarm::CycleWordMissing, 'G', named >> x & 1u ? "Z" : "X");
    cycles::ThreadPasses cycle;
    cycle.end = {target_[static_cast<std::size_t>(z)], target_[static_cast<std::size_t>(x)]};
    cycle.finishing = static_cast<int>(std::lround(data.thread_passes.value_or(
        static_cast<double>(params::get(table, params::n1608_count_fin, l)))));
    cycle.tool_angle_deg = data.tool_angle.value_or(
        static_cast<double>(params::get(table, params::n1612_tool_tip_angle, l)));
    cycle.least = std::fabs(
        data.least_infeed.value_or(params::get(table, params::n1609_min_thrd_cut, l) * unit));
    cycle.allowance =
        data.thread_allowance.value_or(params::get(table, params::n1610_fin_allow, l) * unit);
    for (const char foreign : settings_.series15 ? std::string_view("R") : std::string_view("IKDA"))
        if (block_.has(foreign))
            return core_.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    if (settings_.series15) {  // P is the cutting method, always taken as 1; Q has no effect
        double count = 0.0;
        if (block_.has('D') && !series15_count('D', count)) return false;
        cycle.taper = radius_length('I');
        cycle.height = radius_length('K');
        cycle.first = fine_length('D');
        cycle.height_letter = 'K';
        cycle.first_letter = 'D';
        if (block_.has('A')) cycle.tool_angle_deg = block_.value('A');
    } else {
        cycle.taper = radius_length('R');
        cycle.height = fine_length('P');
        cycle.first = fine_length('Q');
        // R of this block is the taper: the allowance is in the block before.
        if (cycle.height > 0 && (cycle.allowance < 0 || cycle.allowance > cycle.height))
            return core_.fail(Alarm::CycleValueIllegal, 0, "R", cycle.allowance);
    }
    cycle.thread.lead = lead_ > 0                                         ? lead_
                        : core_.path.feed_mode == FeedMode::PerRevolution ? core_.path.feed
                                                                          : 0.0;
    const double tenths = data.thread_chamfer.value_or(
        static_cast<double>(params::get(table, params::n1606_thrdchmfr, l)));
    cycle.chamfer = tenths * 0.1 * cycle.thread.lead;
    const double angle = static_cast<double>(params::get(table, params::n1607_chmfr_ang, l));
    cycle.chamfer_angle_deg = angle > 0 ? angle : 45.0;
    core_.at.cycle = row.name;
    return cycles::cut_thread(core_, cycle);
}

}  // namespace polyturn::channels::fanuc
