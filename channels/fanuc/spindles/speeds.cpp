#include "channels/fanuc/spindles/speeds.hpp"

#include <array>
#include <limits>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"

namespace polyturn::channels::fanuc {
namespace {

// P means another G code of the block (G70 P Q, G4 P, a drilling cycle that drills here): it is not
// the axis of G96 as well.
bool surface_shares_p(const Execution& x) {
    for (std::size_t group = 0; group < x.words.coded.size(); ++group)
        if (group != static_cast<std::size_t>(GGroup::Surface) && x.words.groups >> group & 1u &&
            x.vocabulary.taken_by(x.words.coded[group]) & letter_bit('P'))
            return true;
    const bool one_shot = x.words.has(GGroup::OneShot);
    return x.modal.drilling && !one_shot && (x.words.axis_count || x.block.has('R'));
}

}  // namespace

bool spindle_word(Execution& x) {
    Word word = x.block.word('S');
    // a whole number, as M (fanuc_lathe 6.1)
    if (word.from_expression && x.settings.policy.words.rounds_codes)
        word.value = whole_steps(word.value, 1.0);
    const bool one_shot = x.words.has(GGroup::OneShot);
    if (one_shot && x.words.row(GGroup::OneShot)->is(Trait::Preset)) {
        return x.core.spindle_limit(word.value) && x.core.commit_spindle();
    }
    double value = word.value;
    // feet a minute
    if (x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed && x.modal.input.inch)
        value *= 0.3048;
    if (!x.core.spindle_speed(value)) return false;
    if (x.settings.s_drains) x.run.wants_barrier = true;
    return true;
}

// S2=3200: the speed of a spindle by its name; M3, M4, M5 and M19 mean it until a plain S.
bool named_spindles(Execution& x) {
    for (unsigned i = 0; i < x.block.count; ++i) {
        const Word& word = x.block.words[i];
        if (word.axis < kNamedSpindle) continue;
        const auto& [name, spindle] =
            x.settings.spindle_names[static_cast<std::size_t>(word.axis - kNamedSpindle)];
        if (!x.core.named_spindle(spindle, word.value)) return false;
        if (x.settings.s_drains) x.run.wants_barrier = true;
    }
    return true;
}

// P of G96 names the axis whose place is the radius: by its number in nct, by its place in the
// channel elsewhere. P0 and G96 without P mean the parameter's axis (N0687, "default").
bool g_surface(Execution& x, const GCode& row) {
    if (row.tenths != 960) return x.core.surface_speed(false);
    bool own = x.block.has('P') && !surface_shares_p(x);
    for (unsigned k = 0; k < x.words.m_count; ++k) {  // nor where an M code takes it
        const double code = x.block.words[x.words.m[k]].value;
        own = own && code != 98 && code != 99 && code != 198 && code != x.settings.interrupt.on &&
              !x.core.view().machine.is_wait_code(code);
    }
    std::int64_t number = 0;
    if (own && !whole_number(x, 'P', number)) return false;
    int place = -1;
    for (unsigned i = 0; number != 0 && i < x.core.view().axis_count; ++i)
        if ((x.settings.policy.spindles.surface_axis_of_machine ? x.core.view().axes[i].machine_axis
                                                                : i) +
                1u ==
            static_cast<std::uint64_t>(number))
            place = static_cast<int>(i);
    if (number != 0 && (place < 0 || x.core.view().axes[static_cast<std::size_t>(place)].rotary))
        return x.core.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(number));
    return x.core.surface_axis_is(place) && x.core.surface_speed(true);
}

// G25, G26: supervision of the spindle's speed. Q R are percents; P is a time, seconds in nct and
// milliseconds elsewhere; the absolute limit is D in nct and I elsewhere. What is not programmed is
// the parameter's.
bool g_spindle_watch(Execution& x, const GCode& code) {
    if (code.tenths == 250) return x.core.spindle_watch(false);
    if (const char foreign = x.settings.policy.spindles.foreign_limit; x.block.has(foreign))
        return x.core.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    std::array<double, 4> values;
    const char letters[] = {'P', 'Q', 'R', x.settings.policy.spindles.watch_limit};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = x.block.has(letters[i]) ? x.block.value(letters[i])
                                            : std::numeric_limits<double>::quiet_NaN();
        if (values[i] < 0)
            return x.core.fail(Alarm::NegativeSign, letters[i], std::string(1, letters[i]));
    }
    if (!x.settings.policy.spindles.watch_seconds) values[0] *= 1e-3;
    return x.core.spindle_watch(true, values);
}

}  // namespace polyturn::channels::fanuc
