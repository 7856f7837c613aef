// G74, G75, G76: words of two blocks (series 15: of one) into what channels/cycles does.
#include "channels/fanuc/cycles/g_grooving_threading.hpp"

#include <cmath>

#include "channels/cycles/grooving.hpp"
#include "channels/cycles/thread_passes.hpp"
#include "channels/fanuc/cycles/cycle_words.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/targets.hpp"

namespace polyturn::channels::fanuc {

bool g_grooving(Execution& x, const GCode& row) {
    if (!turning_cycles_available(x, row)) return false;
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const int z_place = x.core.view().axis_by_role(PlaneRole::BasicZ),
              x_place = x.core.view().axis_by_role(PlaneRole::BasicX);
    if (z_place < 0 || x_place < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    if (!x.words.axis_count && !x.settings.series15 && first_of_two(x)) {
        keep_length(x, x.modal.cycles.data.peck_return, 'R');
        return true;
    }
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named)) return false;
    if (named & ~(1u << x_place | 1u << z_place))
        return x.core.fail(Alarm::PlaneAxisIllegal, 'G', "X, Z");
    cycles::Grooving cycle;
    cycle.along_x = row.tenths == (x.settings.system == kC ? 770 : 750);
    if (!(named >> (cycle.along_x ? x_place : z_place) & 1u))
        return x.core.fail(Alarm::CycleWordMissing, 'G', cycle.along_x ? "X" : "Z");
    cycle.end = {x.words.target[static_cast<std::size_t>(z_place)],
                 x.words.target[static_cast<std::size_t>(x_place)]};
    cycle.retract = std::fabs(x.modal.cycles.data.peck_return.value_or(
        params::get(table, params::n1605_retr_g74_g75, l) * unit));
    // P, I belong to X; Q, K to Z; the other words to neither format.
    const char along_x = x.settings.series15 ? 'I' : 'P', along_z = x.settings.series15 ? 'K' : 'Q',
               aside = x.settings.series15 ? 'D' : 'R';
    for (const char foreign : {x.settings.series15 ? 'P' : 'I', x.settings.series15 ? 'Q' : 'K',
                               x.settings.series15 ? 'R' : 'D'})
        if (x.block.has(foreign))
            return x.core.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    const double by_x = fine_length_of(x, along_x), by_z = fine_length_of(x, along_z);
    cycle.peck = cycle.along_x ? by_x : by_z;
    cycle.row = cycle.along_x ? by_z : by_x;
    cycle.peck_letter = cycle.along_x ? along_x : along_z;
    cycle.row_letter = cycle.along_x ? along_z : along_x;
    double count = 0.0;
    if (aside == 'D' && x.block.has('D') && !series15_count(x, 'D', count)) return false;
    cycle.relief = aside == 'D' ? fine_length_of(x, 'D') : radius_length_of(x, 'R');
    x.core.at.cycle = row.name;
    return cycles::cut_grooves(x.core, cycle);
}

bool g_thread_passes(Execution& x, const GCode& row) {
    if (!turning_cycles_available(x, row)) return false;
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    const int z_place = x.core.view().axis_by_role(PlaneRole::BasicZ),
              x_place = x.core.view().axis_by_role(PlaneRole::BasicX);
    if (z_place < 0 || x_place < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    CycleData& data = x.modal.cycles.data;
    if (!x.words.axis_count && !x.settings.series15) {
        if (x.block.has('P')) {  // nnrraa
            std::int64_t fields = 0;
            if (!whole_number(x, 'P', fields)) return false;
            if (fields > 999'999)
                return x.core.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(fields));
            data.thread_passes = static_cast<double>(fields / 10'000);
            data.thread_chamfer = static_cast<double>(fields / 100 % 100);
            data.tool_angle = static_cast<double>(fields % 100);
        } else if (x.settings.policy.cycles.first_block_once) {
            data.thread_passes.reset();
            data.thread_chamfer.reset();
            data.tool_angle.reset();
        }
        if (x.block.has('Q'))
            data.least_infeed = fine_length_of(x, 'Q');
        else if (x.settings.policy.cycles.first_block_once)
            data.least_infeed.reset();
        keep_length(x, data.thread_allowance, 'R');
        return true;
    }
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named)) return false;
    if (named & ~(1u << x_place | 1u << z_place))
        return x.core.fail(Alarm::PlaneAxisIllegal, 'G', "X, Z");
    if (!(named >> z_place & 1u) || !(named >> x_place & 1u))
        return x.core.fail(Alarm::CycleWordMissing, 'G', named >> x_place & 1u ? "Z" : "X");
    cycles::ThreadPasses cycle;
    cycle.end = {x.words.target[static_cast<std::size_t>(z_place)],
                 x.words.target[static_cast<std::size_t>(x_place)]};
    cycle.finishing = static_cast<int>(std::lround(data.thread_passes.value_or(
        static_cast<double>(params::get(table, params::n1608_count_fin, l)))));
    cycle.tool_angle_deg = data.tool_angle.value_or(
        static_cast<double>(params::get(table, params::n1612_tool_tip_angle, l)));
    cycle.least = std::fabs(
        data.least_infeed.value_or(params::get(table, params::n1609_min_thrd_cut, l) * unit));
    cycle.allowance =
        data.thread_allowance.value_or(params::get(table, params::n1610_fin_allow, l) * unit);
    for (const char foreign :
         x.settings.series15 ? std::string_view("R") : std::string_view("IKDA"))
        if (x.block.has(foreign))
            return x.core.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    if (x.settings.series15) {  // P is the cutting method, always taken as 1; Q has no effect
        double count = 0.0;
        if (x.block.has('D') && !series15_count(x, 'D', count)) return false;
        cycle.taper = radius_length_of(x, 'I');
        cycle.height = radius_length_of(x, 'K');
        cycle.first = fine_length_of(x, 'D');
        cycle.height_letter = 'K';
        cycle.first_letter = 'D';
        if (x.block.has('A')) cycle.tool_angle_deg = x.block.value('A');
    } else {
        cycle.taper = radius_length_of(x, 'R');
        cycle.height = fine_length_of(x, 'P');
        cycle.first = fine_length_of(x, 'Q');
        // R of this block is the taper: the allowance is in the block before.
        if (cycle.height > 0 && (cycle.allowance < 0 || cycle.allowance > cycle.height))
            return x.core.fail(Alarm::CycleValueIllegal, 0, "R", cycle.allowance);
    }
    cycle.thread.lead = x.modal.lead > 0                                   ? x.modal.lead
                        : x.core.path.feed_mode == FeedMode::PerRevolution ? x.core.path.feed
                                                                           : 0.0;
    const double tenths = data.thread_chamfer.value_or(
        static_cast<double>(params::get(table, params::n1606_thrdchmfr, l)));
    cycle.chamfer = tenths * 0.1 * cycle.thread.lead;
    const double angle = static_cast<double>(params::get(table, params::n1607_chmfr_ang, l));
    cycle.chamfer_angle_deg = angle > 0 ? angle : 45.0;
    x.core.at.cycle = row.name;
    return cycles::cut_thread(x.core, cycle);
}

}  // namespace polyturn::channels::fanuc
