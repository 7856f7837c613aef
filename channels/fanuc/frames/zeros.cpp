#include "channels/fanuc/frames/zeros.hpp"

#include <array>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/state/tip_control.hpp"
#include "channels/state/zero_rows.hpp"
#include "ipc/kinematics/five_axis.hpp"

namespace polyturn::channels::fanuc {

bool g_zero(Execution& x, const GCode& row) {
    x.core.select_zero(kZeroG54Row + (row.tenths - 540) / 10);
    return true;
}

bool g_zero_extended(Execution& x, const GCode&) {
    std::int64_t number = 1;
    if (x.block.has('P') && !whole_number(x, 'P', number)) return false;
    if (number < 1 || number > 300)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), 300);
    x.core.select_zero(kZeroG541Row + static_cast<std::int32_t>(number));
    return true;
}

// G54.2 Pn: the n-th fixture offset, which turns with the table (N3200 2 or 3); P0: none. Nothing
// moves.
bool g_fixture(Execution& x, const GCode&) {
    std::int64_t number = 0;
    if (!x.block.has('P')) return x.core.fail(Alarm::CycleWordMissing, 'G', "P");
    if (!whole_number(x, 'P', number)) return false;
    if (number > static_cast<std::int64_t>(kFixtureRows.size()))
        return x.core.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number),
                           static_cast<double>(kFixtureRows.size()));
    if (x.core.reads_ahead()) return x.core.fail(Alarm::TransformPlace, 'G', "G41 G42");
    if (number == 0) {
        x.core.fixture_off();
        return true;
    }
    if (x.core.transformed()) return x.core.fail(Alarm::TransformPlace, 'G', "G54.2");
    Transformation described;
    if (!describe_head(x.core, false, described)) return false;
    FixtureOffset fixture;
    fixture.table = described.kinematics;
    const auto turns_part = [&](std::size_t head, std::size_t direction) {
        return fixture.table.value[head] == 0 && five_axis::exists(fixture.table, direction);
    };
    if (!turns_part(five_axis::kFirstIsHead, five_axis::kFirstDirection) &&
        !turns_part(five_axis::kSecondIsHead, five_axis::kSecondDirection))
        return x.core.fail(Alarm::FiveAxisUndefined, 'G', "N3200: a head turns no workpiece");
    const MachineView& view = x.core.view();
    const double* const row =
        view.store->zeros.data() +
        static_cast<std::size_t>(kFixtureRows[static_cast<std::size_t>(number - 1)]) * kChannelAxes;
    constexpr std::array kRoles{PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        // describe_head has found all three
        const auto place = static_cast<unsigned>(view.axis_by_role(kRoles[k]));
        fixture.measured[k] = view.from_shown(place, row[place]);
    }
    for (std::size_t r = 0; r < 2; ++r) {
        const std::uint8_t place = fixture.table.axis[3 + r];
        fixture.at_deg[r] = place == kNoPlace ? fixture.table.centre[3 + r] : row[place];
    }
    fixture.rotary_alone = params::bit(view.table(), params::n3212_5d_control, view.channel, 7);
    x.core.set_fixture(fixture);
    return true;
}

// G50 (system A), G92: the present point gets the programmed coordinates, or the spindle its
// highest speed.
bool g_preset(Execution& x, const GCode&) {
    if (!x.words.axis_count) {
        if (!x.block.has('S')) return x.core.fail(Alarm::CycleWordMissing, 'G', "S");
        return true;  // S was taken as the limit already
    }
    // no motion: the offset called here belongs to the point (fanuc_lathe 1.4)
    if (x.block.has('T')) x.core.take_wanted();
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        const auto [place, incremental] = axis_of(x, word);
        const auto i = static_cast<unsigned>(place);
        const double value =
            length_of(x, word, place) * (x.core.view().axes[i].diameter ? 0.5 : 1.0);
        if (incremental)
            x.core.preset_by(i, value);
        else
            x.core.preset(i, value);
    }
    return true;
}

// G50.3, G92.1: the named axes count from their work zero again, as if G50 and G52 had not been.
bool g_preset_off(Execution& x, const GCode& row) {
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const auto place = static_cast<unsigned>(axis_of(x, x.block.words[x.words.axes[k]]).place);
        x.core.preset_by(place, x.core.path.preset[place]);
        x.core.local_zero(place, 0.0);
    }
    return x.words.axis_count ? true
                              : x.core.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
}

bool g_local_zero(Execution& x, const GCode&) {
    AxisSet named = 0;
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        int place = word.axis >= 0
                        ? word.axis
                        : x.vocabulary.absolute_axis[static_cast<std::size_t>(word.address - 'A')];
        if (place < 0)
            return x.core.fail(Alarm::AddressIllegal, word.address, std::string(1, word.address));
        const auto i = static_cast<unsigned>(place);
        named |= 1u << i;
        x.core.local_zero(i,
                          length_of(x, word, place) * (x.core.view().axes[i].diameter ? 0.5 : 1.0));
    }
    return named ? true : x.core.fail(Alarm::CoordinateAxisNone, 'G', "G52");
}

}  // namespace polyturn::channels::fanuc
