#include "channels/fanuc/tools/data_input.hpp"

#include <fmt/format.h>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/life_groups.hpp"
#include "channels/fanuc/tools/offset_tables.hpp"
#include "channels/state/zero_rows.hpp"

namespace polyturn::channels::fanuc {
namespace {

// G10 P_ X_ Z_ R_ Q_ (U_ W_ C_): P0 work shift, P1.. wear, P10001.. geometry. With L10 geometry and
// L11 wear by number.
bool g10_offset(Execution& x) {
    std::int64_t p = 0;
    if (!x.block.has('P')) return x.core.fail(Alarm::CycleWordMissing, 'G', "P");
    if (!whole_number(x, 'P', p)) return false;
    OffsetTable table = OffsetTable::Wear;
    std::int64_t number = p;
    if (x.block.has('L'))
        table = x.block.value('L') == 10 ? OffsetTable::Geometry : OffsetTable::Wear;
    else if (p > 10000) {
        table = OffsetTable::Geometry;
        number = p - 10000;
    }
    const MachineView& view = x.core.view();
    const int limit = view.config().offset_count;
    if (number > limit || (number == 0 && (p != 0 || x.block.has('L'))))
        return x.core.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), limit);
    const auto cell = [&](OffsetField field) {
        return cell_of(x.core.view().store->offsets[static_cast<std::size_t>(number)], table,
                       field);
    };
    for (unsigned k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        if (word.axis >= 0) return x.core.fail(Alarm::NotBuilt, 0, "G10 with a long axis name");
        const auto letter = static_cast<std::size_t>(word.address - 'A');
        int place = x.vocabulary.absolute_axis[letter];
        bool incremental = !x.modal.input.absolute;
        // C is the increment of the nose radius here
        if (word.address == 'C' && place >= 0 && p != 0) place = -1;
        if (place < 0 && word.address != 'C') {
            place = x.vocabulary.incremental_axis[letter];
            incremental = true;
        }
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double value = length_of(x, word, place);  // as the table shows it
        if (p == 0 && !x.block.has('L')) {
            const double before =
                view.store->zeros[static_cast<std::size_t>(kZeroShiftRow) * kChannelAxes + i];
            write_zero(x, kZeroShiftRow, i, incremental ? before + value : value);
            continue;
        }
        OffsetField field = OffsetField::X;
        switch (view.axes[i].role) {
            case PlaneRole::BasicX:
                break;
            case PlaneRole::BasicY:
                field = OffsetField::Y;
                break;
            case PlaneRole::BasicZ:
                field = OffsetField::Z;
                break;
            default:
                return x.core.fail(Alarm::AddressIllegal, word.address,
                                   std::string(1, word.address));
        }
        const double shown = incremental ? cell(field) + value : value;
        if (!offset_value_good(x, table, shown))
            return x.core.fail(Alarm::OffsetValueIllegal, word.address, {}, shown);
        write_offset(x, table, static_cast<std::int32_t>(number), field, shown);
    }
    if (p == 0 && !x.block.has('L')) return true;
    const auto n = static_cast<std::int32_t>(number);
    for (const char letter : {'R', 'C'}) {
        if (!x.block.has(letter) || (letter == 'C' && !x.settings.policy.tools.radius_by_c))
            continue;
        const double value =
            radius_length_of(x, letter) + (letter == 'C' ? cell(OffsetField::R) : 0.0);
        if (!offset_value_good(x, table, value))
            return x.core.fail(Alarm::OffsetValueIllegal, letter, {}, value);
    }
    if (x.block.has('R')) write_offset(x, table, n, OffsetField::R, radius_length_of(x, 'R'));
    if (x.block.has('C'))
        write_offset(x, table, n, OffsetField::R, cell(OffsetField::R) + radius_length_of(x, 'C'));
    if (x.block.has('Q')) {
        std::int64_t tip = 0;
        if (!whole_number(x, 'Q', tip)) return false;
        if (tip > 9)
            return x.core.fail(Alarm::OffsetValueIllegal, 'Q', {}, static_cast<double>(tip));
        write_offset(x, table, n, OffsetField::T, static_cast<double>(tip));
    }
    return true;
}

// In a milling channel (the field's standard, the specification is silent): R is geometry (L10) and
// wear (L11) of the length that H calls, geometry (L12) and wear (L13) of the radius that D calls.
bool g10_milling_offset(Execution& x, int kind) {
    std::int64_t number = 0;
    for (const char letter : {'P', 'R'})
        if (!x.block.has(letter))
            return x.core.fail(Alarm::CycleWordMissing, 'G', std::string(1, letter));
    if (!whole_number(x, 'P', number)) return false;
    const int limit = x.core.view().config().offset_count;
    if (number < 1 || number > limit)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), limit);
    const OffsetTable table = kind == 10 || kind == 12 ? OffsetTable::Geometry : OffsetTable::Wear;
    const OffsetField field = kind < 12 ? OffsetField::Z : OffsetField::R;
    const double before =
        x.modal.input.absolute
            ? 0.0
            : cell_of(x.core.view().store->offsets[static_cast<std::size_t>(number)], table, field);
    const double value = before + radius_length_of(x, 'R');
    if (!offset_value_good(x, table, value))
        return x.core.fail(Alarm::OffsetValueIllegal, 'R', {}, value);
    write_offset(x, table, static_cast<std::int32_t>(number), field, value);
    return true;
}

// G10 L2 Pn, G10 L20 Pn: work zeros; P0 is the external shift. G10 L21 Pn: fixture offsets of the
// table (G54.2).
bool g10_zero(Execution& x) {
    std::int64_t p = 0;
    if (x.block.has('P') && !whole_number(x, 'P', p)) return false;
    const bool extended = x.block.value('L') == 20, fixture = x.block.value('L') == 21;
    const std::int64_t most = fixture    ? static_cast<std::int64_t>(kFixtureRows.size())
                              : extended ? 300
                                         : 6;
    if (p > most || ((extended || fixture) && p < 1))
        return x.core.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(p),
                           static_cast<double>(most));
    const std::int32_t row = fixture    ? kFixtureRows[static_cast<std::size_t>(p - 1)]
                             : extended ? kZeroG541Row + static_cast<std::int32_t>(p)
                                        : static_cast<std::int32_t>(p);
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        const auto [place, incremental] = axis_of(x, word);
        const auto i = static_cast<unsigned>(place);
        const double before =
            x.core.view().store->zeros[static_cast<std::size_t>(row) * kChannelAxes + i];
        const double value = length_of(x, word, place);
        write_zero(x, row, i, incremental ? before + value : value);
    }
    return true;
}

}  // namespace

bool g_data(Execution& x, const GCode&) {
    if (x.block.has('L')) {
        const auto kind = static_cast<int>(x.block.value('L'));
        if (kind == 50 || kind == 52) {
            x.modal.parameter_input = true;
            return true;
        }
        if (kind == 3) return begin_life_groups(x);
        if (kind == 2 || kind == 20 || kind == 21) return g10_zero(x);
        const bool milling = x.settings.policy.tools.offsets_of_mills &&
                             x.core.view().config().kind == ChannelKind::Mill;
        if (milling && kind >= 10 && kind <= 13 && !x.words.axis_count)
            return g10_milling_offset(x, kind);
        if (kind == 10 || kind == 11) return g10_offset(x);
        return x.core.fail(Alarm::NotBuilt, 'L', fmt::format("G10 L{}", kind));
    }
    return g10_offset(x);
}

}  // namespace polyturn::channels::fanuc
