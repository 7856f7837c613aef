// Macro calls: G65, G66, G67, and the G, M, T codes and letters that call programs.
#include "channels/fanuc/macro/calls.hpp"

#include <algorithm>
#include <cmath>

#include "channels/fanuc/cycles/pattern_data.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/arguments.hpp"
#include "channels/fanuc/macro/variable_writes.hpp"
#include "channels/fanuc/program/calls.hpp"
#include "channels/fanuc/program/faults.hpp"

namespace polyturn::channels::fanuc {

bool g_macro_call(Execution& x, const GCode&) {
    if (x.block.has('H') && x.settings.policy.macro.pattern_data) {
        std::int64_t kind = 0;
        if (!x.block.word('H').has_point && x.block.value('H') >= 90 && x.block.value('H') <= 94)
            return whole_number(x, 'H', kind) && g_pattern_data(x, kind);
    }
    std::int64_t program = 0, repeats = 1;
    LocalSet arguments;
    if (!macro_words(x, program, repeats, arguments)) return false;
    x.run.called = true;
    return call_program(x, program, repeats, &arguments, false, false, 'P');
}

bool g_macro_modal(Execution& x, const GCode& row) {
    ModalCall call;
    if (!macro_words(x, call.program, call.repeats, call.arguments)) return false;
    if (x.calls.modal.size() >= x.settings.macro_levels)
        return x.core.fail(Alarm::MacroTooDeep, 'G', {}, x.settings.macro_levels);
    call.every_block = row.tenths == 661;
    x.calls.modal.push_back(call);
    return true;
}

bool g_macro_modal_off(Execution& x, const GCode&) {
    if (!x.calls.modal.empty()) x.calls.modal.pop_back();
    return true;
}

// Between G66.1 and G67 a block does nothing itself: its words are arguments, as behind G65 (nct
// part 2 18.2, "called for every block"; what becomes of the words is the field's standard). The
// end of a program and a block that calls a subprogram are none.
bool gives_arguments(const Execution& x) {
    if (x.calls.modal.empty() || !x.calls.modal.back().every_block || !x.calls.modal.back().armed ||
        x.b_axis.registering || x.modal.life.mode)
        return false;
    if (x.words.call.program >= 0 || !(x.block.letters & ~letter_set("NO"))) return false;
    for (std::size_t k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        if (word.axis >= 0) continue;
        if (word.address == 'G' && (word.value == 67 || word.value == 65 || word.value == 66 ||
                                    std::fabs(word.value - 66.1) < 1e-6))
            return false;
        if (word.address == 'M' && (word.value == 2 || word.value == 30 || word.value == 98 ||
                                    word.value == 99 || word.value == 198))
            return false;
    }
    return true;
}

// A stop or a waiting code that were an argument only would let the machine run on where its
// program says that it is stopped, or past the other channel. Nothing in the specification takes it
// away: it acts as ever, and the macro is called behind it with M as its argument.
const Word* stops_or_waits(const Execution& x) {
    for (std::size_t k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        if (word.axis >= 0 || word.address != 'M') continue;
        const double code = word.from_expression ? whole_steps(word.value, 1.0) : word.value;
        if (code == 0 || code == 1 || x.core.view().machine.is_wait_code(code)) return &word;
    }
    return nullptr;
}

// Whether another word of such a block would move or switch, or be an argument only, is not
// specified: it is alone in its block (P: the channels).
bool stands_alone(Execution& x, const Word& stop) {
    for (std::size_t k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        if (&word == &stop ||
            (word.axis < 0 && (word.address == 'N' || word.address == 'O' || word.address == 'P')))
            continue;
        blame(x, word);
        return x.core.fail(Alarm::CodesContradict, 0,
                           std::string(text_of(x, stop)) + " and " + std::string(text_of(x, word)));
    }
    return true;
}

// G, L and P are no arguments, as behind G65.
bool per_block_call(Execution& x) {
    const ModalCall modal = x.calls.modal.back();
    for (std::size_t k = 0; k < x.block.count; ++k)
        if (x.block.words[k].axis < 0 && x.block.words[k].address == 'G')
            x.block.words[k].address = 'N';
    LocalSet arguments = empty_locals();
    x.run.called = true;
    return gather_arguments(x, arguments, 0) &&
           call_program(x, modal.program, modal.repeats, &arguments, false, true, 0);
}

// Codes that call programs instead of acting. `called` says whether the block was used up by a
// call.
bool code_calls(Execution& x, bool& called) {
    x.words.call.program = x.words.call.local = -1;
    const bool inside = std::any_of(x.calls.frames.begin() + 1, x.calls.frames.end(),
                                    [](const CallLevel& f) { return f.by_code; });
    if (inside && !x.settings.nested_calls) return true;
    for (std::size_t k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        const char word_letter = word.address;
        if (word.axis >= 0 || word_letter >= 'a') continue;
        // A subprogram is called when the rest of the block has acted, as by M98; the word itself
        // does nothing else.
        const auto later = [&](std::int32_t program, std::int64_t repeats,
                               bool repeats_word = false) {
            x.words.call.program = program;
            x.words.call.repeats = repeats;
            x.words.call.column = word.column;
            x.words.call.length = word.length;
            x.block.words[k].address = 'N';
            if (repeats_word) x.block.letters &= ~letter_bit('L');  // it was the number of calls
            bool another = false;
            for (std::size_t j = 0; j < x.block.count; ++j)
                another = another || x.block.words[j].address == word_letter;
            if (!another) x.block.letters &= ~letter_bit(word_letter);
            return true;
        };
        const auto use = [&](const CodeCall& call, std::int32_t program) {
            LocalSet arguments = empty_locals();
            std::int64_t repeats = 1;
            if (!call_count(x, repeats)) return false;
            if (!call.macro) return later(program, repeats, x.block.has('L'));
            called = x.run.called = true;
            // Every other word of the block is an argument (nct part 2 18.2, 18.3); behind a G code
            // of fanuc as behind G65 (6.9.4).
            if (word.address == 'M' || x.settings.policy.macro.arguments_anywhere) {
                const Word code = word;
                x.block.words[k].address = 'N';
                const bool good = gather_arguments(x, arguments, 0);
                x.block.words[k] = code;
                if (!good) return false;
            } else if (!call_stands_first(x, k) || !gather_arguments(x, arguments, k + 1)) {
                return false;
            }
            if (call.modal) {
                ModalCall modal;
                modal.program = program;
                modal.repeats = repeats;
                modal.every_block = call.modal == 2;
                modal.arguments = arguments;
                if (x.calls.modal.size() >= x.settings.macro_levels)
                    return x.core.fail(Alarm::MacroTooDeep, word.address, {},
                                       x.settings.macro_levels);
                x.calls.modal.push_back(modal);
                return true;
            }
            return call_program(x, program, repeats, &arguments, true, false, word.address);
        };
        if (word.address == 'G') {
            const auto tenths = static_cast<std::int32_t>(std::lround(word.value * 10));
            for (const CodeCall& call : x.settings.g_calls)
                if (call.code == tenths) return use(call, call.program);
        } else if (word.address == 'M') {
            for (const CodeCall& call : x.settings.m_calls)
                if (call.code == static_cast<std::int32_t>(word.value)) {
                    // must be the first word
                    if (call.macro && x.settings.policy.macro.codes_lead_calls &&
                        k > (x.block.words[0].address == 'N' ? 1u : 0u))
                        continue;
                    return use(call, call.program);
                }
        } else {
            for (const Settings::LetterCall& call : x.settings.letter_calls)
                if (call.letter == word.address) {
                    if (x.macro.written.serial != x.core.at.serial) {
                        x.macro.written.serial = x.core.at.serial;
                        x.macro.written.letters = 0;
                    }
                    if (!(x.macro.written.letters & letter_bit(word.address)) &&
                        !write_variable(x, call.variable, word.value, {}))
                        return false;
                    x.macro.written.letters |= letter_bit(word.address);
                    return later(call.program, 1);
                }
        }
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
