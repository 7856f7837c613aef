#include "channels/fanuc/cycles/g_repetitive.hpp"

#include <cmath>

#include "channels/cycles/contour.hpp"
#include "channels/cycles/stock_removal.hpp"
#include "channels/fanuc/cycles/contour_reading.hpp"
#include "channels/fanuc/cycles/cycle_words.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/search.hpp"

namespace polyturn::channels::fanuc {

bool g_stock_removal(Execution& x, const GCode& row) {
    if (!turning_cycles_available(x, row)) return false;
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const bool facing = row.tenths == (x.settings.system == kC ? 740 : 720);
    const char depth_letter = facing ? 'W' : 'U';
    if (first_of_two(x) && !x.settings.series15) {
        // Here already: in the second block the letter is the allowance's.
        if (x.block.has(depth_letter) && x.block.value(depth_letter) == 0)
            return x.core.fail(Alarm::CycleValueIllegal, depth_letter,
                               std::string(1, depth_letter));
        keep_length(x, x.modal.cycles.data.depth, depth_letter);
        keep_length(x, x.modal.cycles.data.escape, 'R');
        return true;
    }
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    cycles::StockRemoval cycle;
    cycle.facing = facing;
    cycle.depth = std::fabs(x.modal.cycles.data.depth.value_or(
        params::get(table, params::n1600_depth_of_cut, l) * unit));
    cycle.depth_letter = depth_letter;
    if (x.block.has('D')) {
        double count = 0.0;
        if (!x.settings.series15) return x.core.fail(Alarm::AddressIllegal, 'D', "D");
        if (!series15_count(x, 'D', count)) return false;
        cycle.depth = std::fabs(radius_length_of(x, 'D'));
        cycle.depth_letter = 'D';
    }  // I, K have no effect in the series 15 format (fanuc_lathe 8.4), and no meaning elsewhere: they are left out
    cycle.escape = std::fabs(
        x.modal.cycles.data.escape.value_or(params::get(table, params::n1601_escape, l) * unit));
    cycle.allowance = {shift_word(x, 'W', PlaneRole::BasicZ),
                       shift_word(x, 'U', PlaneRole::BasicX)};
    cycle.roughing_tolerance =
        params::get(table, params::n1613_tolerance_along_roughing_axis, l) * unit;
    cycle.cutting_tolerance =
        params::get(table, params::n1614_tolerance_along_cutting_axis, l) * unit;
    cycle.first_pocket_first = !x.settings.policy.cycles.first_pocket_by_n1611 ||
                               params::bit(table, params::n1611_turning_cyc_config, l, 2);
    // parts of an arc: its radius at the start counts
    cycle.arc_tolerance = 2 * x.settings.arc_tolerance + 0.001;
    cycles::Contour contour;
    ContourText text;
    if (!read_contour(x, contour, text)) return false;
    cycle.pockets = contour.first_names_z && contour.first_names_x;
    x.core.at.cycle = row.name;
    if (!cycles::remove_stock(x.core, contour, cycle)) return false;
    after_contour(x, text);
    return true;
}

bool g_pattern(Execution& x, const GCode& row) {
    if (!turning_cycles_available(x, row)) return false;
    const params::Table& table = x.core.view().table();
    const unsigned l = x.core.view().channel;
    if (first_of_two(x) && !x.settings.series15) {
        keep_length(x, x.modal.cycles.data.relief_x, 'U');
        keep_length(x, x.modal.cycles.data.relief_z, 'W');
        if (x.block.has('R')) {
            // Fanuc counts divisions in whole numbers or, on older controls, in thousandths with a
            // point.
            const Word& word = x.block.word('R');
            if (word.value < 1 && !(word.value > 0 && word.has_point &&
                                    x.settings.policy.cycles.divisions_with_point))
                return x.core.fail(Alarm::CycleValueIllegal, 'R', "R", word.value);
            x.modal.cycles.data.divisions = word.value < 1 ? word.value * 1000.0 : word.value;
        } else if (x.settings.policy.cycles.first_block_once) {
            x.modal.cycles.data.divisions.reset();
        }
        return true;
    }
    // relief and divisions of the series 15 format (fanuc_lathe 8.4): without them other passes are
    // cut
    for (const char foreign : {'I', 'K', 'D'})
        if (!x.settings.series15 && x.block.has(foreign))
            return x.core.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    cycles::Pattern cycle;
    cycle.relief = {x.modal.cycles.data.relief_z.value_or(
                        params::get(table, params::n1602_relief_ax1, l) * unit),
                    x.modal.cycles.data.relief_x.value_or(
                        params::get(table, params::n1603_relief_ax2, l) * unit)};
    double passes = x.modal.cycles.data.divisions.value_or(
        static_cast<double>(params::get(table, params::n1604_numb_of_div, l)));
    if (x.settings.series15) {
        if (x.block.has('I')) cycle.relief.x = radius_length_of(x, 'I');
        if (x.block.has('K')) cycle.relief.z = radius_length_of(x, 'K');
        if (x.block.has('D') && !series15_count(x, 'D', passes)) return false;
    }
    if (!(passes >= 1 && passes <= cycles::kMostPasses))
        return x.core.fail(Alarm::CycleValueIllegal, x.settings.series15 ? 'D' : 'R',
                           x.settings.series15 ? "D" : "R", passes);
    cycle.passes = static_cast<int>(std::lround(passes));
    // Fanuc: the last pass has no relief left; nct divides by the number itself and leaves the same
    // (nct part 2 17.3).
    cycle.divisor = x.settings.policy.cycles.divides_by_passes || cycle.passes == 1
                        ? cycle.passes
                        : cycle.passes - 1;
    cycle.allowance = {shift_word(x, 'W', PlaneRole::BasicZ),
                       shift_word(x, 'U', PlaneRole::BasicX)};
    cycle.arc_tolerance = 2 * x.settings.arc_tolerance + 0.001;
    cycles::Contour contour;
    ContourText text;
    if (!read_contour(x, contour, text)) return false;
    x.core.at.cycle = row.name;
    if (!cycles::repeat_pattern(x.core, contour, cycle)) return false;
    after_contour(x, text);
    return true;
}

// G70: the blocks P to Q as they stand, then back to where it was called.
bool g_finishing(Execution& x, const GCode& row) {
    if (!turning_cycles_available(x, row)) return false;
    if (x.modal.cycles.finishing.active) return x.core.fail(Alarm::ContourCodeIllegal, 'G');
    cycles::Contour contour;  // read once before the tool moves: a mistake in it stops here
    ContourText text;
    if (!read_contour(x, contour, text)) return false;
    x.modal.cycles.finishing = {true,
                                row.name,
                                text.last,
                                x.text.source->next_position(),
                                x.calls.frames.size(),
                                x.core.path.programmed};
    go_on_at(x, text.first);
    return true;
}

// The return is the cycle's own and no part of the contour: as in G90 the nose leaves the contour
// at its last normal, and compensation begins again with the next block. As an element of the
// contour it would be an inner corner that most last blocks are too short for.
bool end_finishing(Execution& x) {
    x.core.at.cycle = x.modal.cycles.finishing.name;
    x.core.begin_cycle(Core::CycleMoves::Plain);
    const bool driven = x.core.rapid(x.modal.cycles.finishing.start);
    x.core.end_cycle();
    if (!driven) return false;
    x.modal.cycles.finishing.active = false;
    go_on_at(x, x.modal.cycles.finishing.resume);
    return true;
}

}  // namespace polyturn::channels::fanuc
