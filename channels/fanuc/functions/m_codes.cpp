#include "channels/fanuc/functions/m_codes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "channels/fanuc/b_axis/b_axis.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/functions/waits.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/arguments.hpp"
#include "channels/fanuc/program/calls.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/program/interrupts.hpp"
#include "channels/fanuc/program/reading.hpp"
#include "channels/fanuc/program/remote_data.hpp"
#include "channels/fanuc/program/search.hpp"
#include "channels/fanuc/spindles/spindle_codes.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool in_ranges(const std::vector<std::pair<double, double>>& ranges, double code) {
    for (const auto& [low, high] : ranges)
        if (code >= low && code <= high) return true;
    return false;
}

// M codes that act behind the block's motion: what ends something must not end it before the cut.
bool acts_late(double code, const MachineConfig& machine) {
    return code == 0 || code == 1 || code == 2 || code == 5 || code == 9 || code == 30 ||
           code == 98 || code == 99 || code == 198 || machine.is_wait_code(code);
}

bool is_draining(const Execution& x, double code) { return in_ranges(x.settings.draining_m, code); }

bool function_code(Execution& x, const Word& word, bool late) {
    const double code = word.value;
    if (code < 0 || code != std::floor(code)) {
        blame(x, word);
        return x.core.fail(code < 0 ? Alarm::NegativeSign : Alarm::PointForbidden, 'M', "M");
    }
    if (code == x.settings.interrupt.on || code == x.settings.interrupt.off)
        return interrupt_code(x, word);
    if (late && code == 5 && !(x.core.spindle_turn(SpindleTurn::Stop) && x.core.commit_spindle()))
        return false;
    note_loop(x, code);
    if (code == 19 && !(can_orient(x, spindle_of_codes(x)) &&
                        turn_spindle(x, spindle_of_codes(x), 0.0, false, false)))
        return false;
    if (const Settings::Indexing* turns = indexing_of(x, code);
        turns &&
        !turn_spindle(x, turns->spindle, (code - turns->first + 1) * turns->angle, true, true))
        return false;
    const bool drains = is_draining(x, code) || (code == 5 && x.core.frees_axis());
    char text[24];
    const auto end = fmt::format_to_n(text, sizeof text, "M{}", static_cast<std::int64_t>(code));
    const bool b_axis = x.settings.policy.program.b_axis;
    // with the code, not behind it
    const bool at_once =
        b_axis && params::bit(x.core.view().table(), params::f8240, x.core.view().channel, 7);
    if (at_once && !b_start(x, code)) return false;
    x.core.aux('M', code, {text, end.size}, drains);
    x.modal.last.m = static_cast<std::int64_t>(code);
    if (drains) x.run.wants_barrier = true;
    if (x.settings.part_code != 0 && code == x.settings.part_code)
        x.core.sink().part(++x.modal.parts, x.core.at);
    return !b_axis || at_once || b_start(x, code);
}

// Of several waiting codes none is waited for.
bool one_wait_code(Execution& x) {
    bool waits = false;
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const Word& word = x.block.words[x.words.m[k]];
        if (!x.core.view().machine.is_wait_code(word.value)) continue;
        if (std::exchange(waits, true)) {
            blame(x, word);
            return x.core.fail(Alarm::ClampTooLong, 0, {}, word.value);
        }
    }
    return true;
}

// M98, and M198: the program comes from outside (PT_EXTERNAL).
bool sub_call(Execution& x, bool external) {
    std::int64_t number = 0, repeats = 1;
    if (!program_word(x, 'M', number)) return false;
    if (external && number < 0) return x.core.fail(Alarm::SubprogramWordMissing, 'M');
    if (x.settings.policy.program.counts_before_number && number >= 0) {
        if (x.settings.series15) {
            number %= 10000;
        } else if (number > 9999) {  // the count precedes the four digits of the number
            repeats = number / 10000;
            number %= 10000;
        }
    }
    if (x.block.has('L') && !call_count(x, repeats)) return false;
    x.run.called = true;
    if (external) return external_call(x, number, repeats);
    if (!call_program(x, number, repeats, nullptr, false, false, 'P')) return false;
    std::int64_t from = 0;  // Q: the block with which the subprogram begins
    return !x.block.has('Q') || (whole_number(x, 'Q', from) && jump_to_block(x, from));
}

}  // namespace

bool functions_before_motion(Execution& x) {
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const double code = x.block.words[x.words.m[k]].value;
        for (unsigned other = 0; other < k && !x.settings.m_groups.empty(); ++other) {
            const double before = x.block.words[x.words.m[other]].value;
            for (const auto& [low, high] : x.settings.m_groups)
                if (code >= low && code <= high && before >= low && before <= high &&
                    code != before)
                    return x.core.fail(Alarm::MCodesContradict, 'M',
                                       fmt::format("M{:.0f} and M{:.0f}", before, code));
        }
        if (code == 3 || code == 4) {
            note_loop(x, code);
            if (!x.core.spindle_turn(code == 3 ? SpindleTurn::Cw : SpindleTurn::Ccw)) return false;
        }
    }
    if (!x.core.commit_spindle()) return false;
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const Word& word = x.block.words[x.words.m[k]];
        if (acts_late(word.value, x.core.view().machine)) continue;
        if (!function_code(x, word, false)) return false;
    }
    // G1: with F in degrees a minute.
    const double rpm = x.modal.motion->tenths == 10 && x.core.path.feed_mode == FeedMode::PerMinute
                           ? x.core.path.feed / x.modal.input.unit / 360.0
                           : 0.0;
    for (const auto& [name, spindle] : x.settings.spindle_addresses) {
        if (name.size() != 1 || !x.block.has(name[0]) ||
            (x.vocabulary.axis_letters & letter_bit(name[0])))
            continue;
        if (!turn_spindle(x, spindle, x.block.value(name[0]), !x.modal.input.absolute, true, rpm))
            return false;
    }
    for (unsigned i = 0; x.words.spindles && i < x.block.count; ++i)
        if (const Word& word = x.block.words[i];
            word.axis >= kSpindleWord && word.axis < kNamedSpindle &&
            !turn_spindle(
                x,
                x.settings.spindle_addresses[static_cast<std::size_t>(word.axis - kSpindleWord)]
                    .spindle,
                word.value, !x.modal.input.absolute, true, rpm))
            return false;
    for (std::size_t n = 0; n < x.settings.aux_letters.size(); ++n) {
        const char letter = x.settings.aux_letters[n];
        if (!letter || !x.block.has(letter) || (x.vocabulary.axis_letters & letter_bit(letter)))
            continue;
        const double value = x.block.value(letter);
        x.core.aux(letter, value, fmt::format("{}{}", letter, value), x.settings.aux_drains[n]);
        if (x.settings.aux_drains[n]) x.run.wants_barrier = true;
    }
    return true;
}

bool functions_behind_motion(Execution& x) {
    if (x.words.m_count > 1 && !one_wait_code(x)) return false;
    bool waits = false;
    const Word* last = nullptr;  // what ends or leaves the block: M0 M1 M2 M30 M98 M99
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const Word& word = x.block.words[x.words.m[k]];
        const double code = word.value;
        if (!acts_late(code, x.core.view().machine)) continue;
        if (x.core.view().machine.is_wait_code(code)) {
            waits = true;
            if (!wait_code(x, word)) return false;
        } else if (code == 5 || code == 9) {
            if (!function_code(x, word, true)) return false;
        } else {
            if (last && last->value != code)
                return x.core.fail(Alarm::CodesContradict, 'M',
                                   fmt::format("M{:.0f} and M{:.0f}", last->value, code));
            last = &word;
        }
    }
    if (x.block.has_list && !waits) return x.core.fail(Alarm::PointListForbidden, 'P');
    if (!last) return true;
    const auto code = static_cast<int>(last->value);
    switch (code) {
        case 0:
        case 1:
            if (code == 1 && !x.core.port().optional_stop()) {
                x.core.sink().stop({StopReason::M01, nullptr, false}, x.core.at);
                return true;
            }
            x.core.mark_emitted();
            x.core.sink().stop({code == 0 ? StopReason::M00 : StopReason::M01}, x.core.at);
            x.run.wants_barrier = true;
            return true;
        case 2:
        case 30:
            if (x.settings.part_code == 0) x.core.sink().part(++x.modal.parts, x.core.at);
            end_program(x, code == 2 ? StopReason::M02 : StopReason::M30);
            return true;
        case 98:
            return sub_call(x, false);
        case 198:
            return sub_call(x, true);
        default:
            break;
    }
    // M99
    std::int64_t target = 0;
    const bool has_target = x.block.has('P');
    if (has_target && !whole_number(x, 'P', target)) return false;
    x.run.called = true;
    return return_from_program(x, has_target, target);
}

}  // namespace polyturn::channels::fanuc
