// Group 5 of mefi: zero shifts G53 to G59, and G92, G93 that fill their table (spec mefi_cnc8x6 5,
// 6).
//
//   NBS ----- XNP1 -----> NBP1 (G54)         every row is counted from the machine's zero, none is added to another:
//   NBS -- XNP0 --> NBP0 (G53)               Core has one row in force at a time, which is just that
//
//   G53..G57  stay          G58, G59  hold in their block; then the last of G53..G57 holds again
//                           (end_one_block_shift)
//   G5x G92   the words are the row's values      G5x G93   the row becomes such that the tool now stands at the words
#include <cmath>
#include <string>

#include "channels/fanuc/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"

namespace polyturn::channels::fanuc {

bool Interpreter::g_shift(const GCode& row) {
    if (row.tenths >= 580) {
        one_block_.before = core_.path.zero_row;
        one_block_.code = active_[static_cast<std::size_t>(GGroup::Zero)];
    }
    core_.select_zero(static_cast<std::int32_t>(*work_zero_row(row.name)));
    return true;
}

// A block says one thing: an address once, of each group one code, and G92 or G93. The
// specification has no alarms (8); what it cites, DIN, has it so, and of G54 X10 X20 one of the
// words would be lost in silence.
bool Interpreter::says_it_once() {
    const auto refuse = [this](const Word& word, Alarm alarm, std::string detail) {
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(alarm, 0, std::move(detail));
    };
    for (unsigned i = 0; i < block_.count; ++i) {
        const Word& word = block_.words[i];
        if (word.address == 'M') continue;
        for (unsigned k = 0; k < i; ++k) {
            const Word& before = block_.words[k];
            if (before.address != word.address || before.axis != word.axis) continue;
            if (word.address != 'G')
                return refuse(word, Alarm::AddressTwice, std::string(1, word.address));
            const GCode* a =
                table_.find(static_cast<std::uint32_t>(std::nearbyint(before.value * 10.0)));
            const GCode* b =
                table_.find(static_cast<std::uint32_t>(std::nearbyint(word.value * 10.0)));
            if (a != b && a->group == b->group)
                return refuse(word, Alarm::FagorIncompatible,
                              std::string(a->name) + " " + std::string(b->name));
        }
    }
    return true;
}

void Interpreter::end_one_block_shift() {
    if (!one_block_.code) return;
    core_.select_zero(one_block_.before);
    active_[static_cast<std::size_t>(GGroup::Zero)] = one_block_.code;
    one_block_ = {};
}

// Without a G5x in the block the row in force is meant. Nothing moves; the value holds from the
// next block on and is not kept when the control is switched off.
bool Interpreter::g_shift_table(const GCode& row) {
    if (!axis_word_count_) return core_.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
    const bool from_position = row.tenths == 930;
    const std::int32_t zero = core_.path.zero_row;
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        const auto i = static_cast<unsigned>(axis_of(word).place);
        double value = length(word, static_cast<int>(i));
        if (from_position) {
            const double before =
                core_.view().store->zeros[static_cast<std::size_t>(zero) * kChannelAxes + i];
            value = before +
                    core_.view().to_shown(i, core_.path.programmed[i] + core_.path.turns_deg[i]) -
                    value;
        }
        write_zero(zero, i, value);
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
