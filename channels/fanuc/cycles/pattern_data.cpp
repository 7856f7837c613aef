// G65 H90 to H94: what builds the pattern menu and the pattern data screens (fanuc_lathe 11).
//
//   G65 H91 P2 Q066079 R076084        pattern 2 is called BOLT: two characters a word, three digits
//                                     each
//
// O9500 is the menu, O9501 to O9510 are the data pages. Each line is a message, and all of them are
// a page that the operator is asked where the program ends (channels/dialogue.hpp): the pattern
// chosen becomes #5900 and its data page follows; values go to their variables.
#include "channels/fanuc/cycles/pattern_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/variable_writes.hpp"
#include "channels/fanuc/program/calls.hpp"

namespace polyturn::channels::fanuc {

bool g_pattern_data(Execution& x, std::int64_t kind) {
    static constexpr char kAll[] = {'P', 'Q', 'R', 'I', 'J', 'K'};
    const bool numbered = kind == 91 || kind == 93;
    std::int64_t number = 0;
    if (numbered) {
        if (!x.block.has('P')) return x.core.fail(Alarm::CycleWordMissing, 'H', "P");
        if (!whole_number(x, 'P', number)) return false;
        const bool good = kind == 91 ? number >= 1 && number <= 10 : number >= 500 && number <= 531;
        if (!good)
            return x.core.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(number));
    }
    std::string text;
    for (const char letter : kAll) {
        if (numbered && letter == 'P') continue;
        if (!x.block.has(letter)) {
            text += "  ";
            continue;
        }
        std::int64_t codes = 0;
        if (!whole_number(x, letter, codes)) return false;
        for (const std::int64_t code : {codes / 1000, codes % 1000}) {
            if (code == 0) {
                text += ' ';
                continue;
            }
            if (code < 32 || code > 95 || code == '(' || code == ')')
                return x.core.fail(Alarm::PatternText, letter, std::to_string(codes));
            text += static_cast<char>(code);
        }
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    static constexpr std::string_view kWhat[] = {"menu", "pattern", "data", "variable", "comment"};
    std::string line = std::string(kWhat[kind - 90]);
    if (kind == 91) line += fmt::format(" {}", number);
    if (kind == 93) line += fmt::format(" #{}", number);
    x.core.mark_emitted();
    x.core.sink().message(line + ": " + text, x.core.at);
    // with compensation on nothing can be asked: the lines stay messages
    if (x.core.reads_ahead()) return true;
    static constexpr std::size_t kMostNotes = 8, kMostFields = 32;
    if (kind == 90 || kind == 92 || !x.macro.dialogue.open)
        x.macro.dialogue = {true, kind <= 91, false, {}};
    DialoguePage& page = x.macro.dialogue.page;
    switch (kind) {
        case 90:
        case 92:
            page.title = text;
            break;
        case 91:
            page.keys.resize(
                std::max<std::size_t>(page.keys.size(), static_cast<std::size_t>(number)));
            page.keys[static_cast<std::size_t>(number - 1)] = text;
            break;
        case 93: {
            if (page.fields.size() == kMostFields) break;
            double value = NAN;
            (void)x.macro.variables.read(number, value);
            page.fields.push_back({text, "#" + std::to_string(number), value});
            break;
        }
        default:
            if (page.notes.size() < kMostNotes) page.notes.push_back(text);
    }
    return true;
}

bool ends_program(const Execution& x) {
    for (unsigned k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        if (word.axis < 0 && word.address == 'M' &&
            (word.value == 99 || word.value == 2 || word.value == 30))
            return true;
    }
    return false;
}

// Where the program ends that has built a page: first the page is asked and the block is read again
// behind the barrier, then the answers are taken. `done`: the end may act. A key that the page does
// not have is no answer: it is asked again.
bool pattern_dialogue(Execution& x, bool& done) {
    if (x.core.reads_ahead()) return done = true;
    if (!x.macro.dialogue.asked) {
        if (!x.macro.dialogue.menu) x.macro.dialogue.page.keys = {"INPUT"};
        x.core.mark_emitted();
        x.core.sink().stop({StopReason::Dialogue, &x.macro.dialogue.page}, x.core.at);
        x.macro.dialogue.asked = x.run.reread = true;
        x.text.line_left = false;
        return true;
    }
    const DialogueAnswers answers = x.core.port().dialogue_answers();
    const std::size_t key = static_cast<std::size_t>(std::max(0, answers.key));
    if (!x.macro.dialogue.menu)
        for (const auto& [name, value] : answers.values) {
            const auto field = std::find_if(
                x.macro.dialogue.page.fields.begin(), x.macro.dialogue.page.fields.end(),
                [&, wanted = name](const auto& one) { return one.variable == wanted; });
            if (field == x.macro.dialogue.page.fields.end()) continue;
            field->value = value;
            if (!write_variable(x, std::strtoll(name.c_str() + 1, nullptr, 10), value, {}))
                return false;
        }
    if (key > 0 &&
        (key > x.macro.dialogue.page.keys.size() || x.macro.dialogue.page.keys[key - 1].empty())) {
        x.macro.dialogue.asked = false;
        return pattern_dialogue(x, done);
    }
    const bool menu = x.macro.dialogue.menu;
    x.macro.dialogue = {};
    if (!menu || key == 0) return done = true;
    if (!write_variable(x, 5900, static_cast<double>(key), {})) return false;
    done = !go_on_with(x, 9500 + static_cast<std::int64_t>(key));
    return true;
}

}  // namespace polyturn::channels::fanuc
