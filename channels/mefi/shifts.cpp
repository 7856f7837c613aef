// Group 5 of mefi: zero shifts G53 to G59, and G92, G93 that fill their table (spec mefi_cnc8x6 5,
// 6).
//
//   NBS ----- XNP1 -----> NBP1 (G54)         every row is counted from the machine's zero, none is added to another:
//   NBS -- XNP0 --> NBP0 (G53)               Core has one row in force at a time, which is just that
//
//   G53..G57  stay          G58, G59  hold in their block; then the last of G53..G57 holds again
//                           (end_one_block_shift)
//   G5x G92   the words are the row's values      G5x G93   the row becomes such that the tool now stands at the words
#include "channels/mefi/shifts.hpp"

#include <cmath>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/tools/offset_tables.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::fanuc {

bool g_shift(Execution& x, const GCode& row) {
    if (row.tenths >= 580) {
        x.machine.one_block.before = x.core.path.zero_row;
        x.machine.one_block.code = x.modal.in_force(GGroup::Zero);
    }
    x.core.select_zero(static_cast<std::int32_t>(*work_zero_row(row.name)));
    return true;
}

// A block says one thing: an address once, of each group one code, and G92 or G93. The
// specification has no alarms (8); what it cites, DIN, has it so, and of G54 X10 X20 one of the
// words would be lost in silence.
bool says_it_once(Execution& x) {
    const auto refuse = [&x](const Word& word, Alarm alarm, std::string detail) {
        blame(x, word);
        return x.core.fail(alarm, 0, std::move(detail));
    };
    for (unsigned i = 0; i < x.block.count; ++i) {
        const Word& word = x.block.words[i];
        if (word.address == 'M') continue;
        for (unsigned k = 0; k < i; ++k) {
            const Word& before = x.block.words[k];
            if (before.address != word.address || before.axis != word.axis) continue;
            if (word.address != 'G')
                return refuse(word, Alarm::AddressTwice, std::string(1, word.address));
            const GCode* a = x.vocabulary.table.find(
                static_cast<std::uint32_t>(std::nearbyint(before.value * 10.0)));
            const GCode* b = x.vocabulary.table.find(
                static_cast<std::uint32_t>(std::nearbyint(word.value * 10.0)));
            if (a != b && a->group == b->group)
                return refuse(word, Alarm::FagorIncompatible,
                              std::string(a->name) + " " + std::string(b->name));
        }
    }
    return true;
}

void end_one_block_shift(Execution& x) {
    if (!x.machine.one_block.code) return;
    x.core.select_zero(x.machine.one_block.before);
    x.modal.in_force(GGroup::Zero) = x.machine.one_block.code;
    x.machine.one_block = {};
}

// Without a G5x in the block the row in force is meant. Nothing moves; the value holds from the
// next block on and is not kept when the control is switched off.
bool g_shift_table(Execution& x, const GCode& row) {
    if (!x.words.axis_count)
        return x.core.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
    const bool from_position = row.tenths == 930;
    const std::int32_t zero = x.core.path.zero_row;
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        const auto i = static_cast<unsigned>(axis_of(x, word).place);
        double value = length_of(x, word, static_cast<int>(i));
        if (from_position) {
            const double before =
                x.core.view().store->zeros[static_cast<std::size_t>(zero) * kChannelAxes + i];
            value =
                before +
                x.core.view().to_shown(i, x.core.path.programmed[i] + x.core.path.turns_deg[i]) -
                value;
        }
        write_zero(x, zero, i, value);
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
