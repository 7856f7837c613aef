// G65 H90 to H94: what builds the pattern menu and the pattern data screens (fanuc_lathe 11).
//
//   G65 H91 P2 Q066079 R076084        pattern 2 is called BOLT: two characters a word, three digits
//                                     each
//
// O9500 is the menu, O9501 to O9510 are the data pages. Each line is a message, and all of them are
// a page that the operator is asked where the program ends (channels/dialogue.hpp): the pattern
// chosen becomes #5900 and its data page follows; values go to their variables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

bool Interpreter::g_pattern_data(std::int64_t kind) {
    static constexpr char kAll[] = {'P', 'Q', 'R', 'I', 'J', 'K'};
    const bool numbered = kind == 91 || kind == 93;
    std::int64_t number = 0;
    if (numbered) {
        if (!block_.has('P')) return core_.fail(Alarm::CycleWordMissing, 'H', "P");
        if (!whole('P', number)) return false;
        const bool good = kind == 91 ? number >= 1 && number <= 10 : number >= 500 && number <= 531;
        if (!good)
            return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(number));
    }
    std::string text;
    for (const char letter : kAll) {
        if (numbered && letter == 'P') continue;
        if (!block_.has(letter)) {
            text += "  ";
            continue;
        }
        std::int64_t codes = 0;
        if (!whole(letter, codes)) return false;
        for (const std::int64_t code : {codes / 1000, codes % 1000}) {
            if (code == 0) {
                text += ' ';
                continue;
            }
            if (code < 32 || code > 95 || code == '(' || code == ')')
                return core_.fail(Alarm::PatternText, letter, std::to_string(codes));
            text += static_cast<char>(code);
        }
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    static constexpr std::string_view kWhat[] = {"menu", "pattern", "data", "variable", "comment"};
    std::string line = std::string(kWhat[kind - 90]);
    if (kind == 91) line += fmt::format(" {}", number);
    if (kind == 93) line += fmt::format(" #{}", number);
    core_.mark_emitted();
    core_.sink().message(line + ": " + text, core_.at);
    // with compensation on nothing can be asked: the lines stay messages
    if (core_.reads_ahead()) return true;
    static constexpr std::size_t kMostNotes = 8, kMostFields = 32;
    if (kind == 90 || kind == 92 || !dialogue_.open) dialogue_ = {true, kind <= 91, false, {}};
    DialoguePage& page = dialogue_.page;
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
            (void)variables_.read(number, value);
            page.fields.push_back({text, "#" + std::to_string(number), value});
            break;
        }
        default:
            if (page.notes.size() < kMostNotes) page.notes.push_back(text);
    }
    return true;
}

bool Interpreter::ends_program() const {
    for (unsigned k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        if (word.axis < 0 && word.address == 'M' &&
            (word.value == 99 || word.value == 2 || word.value == 30))
            return true;
    }
    return false;
}

// Where the program ends that has built a page: first the page is asked and the block is read again
// behind the barrier, then the answers are taken. `done`: the end may act. A key that the page does
// not have is no answer: it is asked again.
bool Interpreter::pattern_dialogue(bool& done) {
    if (core_.reads_ahead()) return done = true;
    if (!dialogue_.asked) {
        if (!dialogue_.menu) dialogue_.page.keys = {"INPUT"};
        core_.mark_emitted();
        core_.sink().stop({StopReason::Dialogue, &dialogue_.page}, core_.at);
        dialogue_.asked = reread_ = true;
        line_left_ = false;
        return true;
    }
    const DialogueAnswers answers = core_.port().dialogue_answers();
    const std::size_t key = static_cast<std::size_t>(std::max(0, answers.key));
    if (!dialogue_.menu)
        for (const auto& [name, value] : answers.values) {
            const auto field = std::find_if(
                dialogue_.page.fields.begin(), dialogue_.page.fields.end(),
                [&, wanted = name](const auto& one) { return one.variable == wanted; });
            if (field == dialogue_.page.fields.end()) continue;
            field->value = value;
            if (!written(std::strtoll(name.c_str() + 1, nullptr, 10), value, {})) return false;
        }
    if (key > 0 && (key > dialogue_.page.keys.size() || dialogue_.page.keys[key - 1].empty())) {
        dialogue_.asked = false;
        return pattern_dialogue(done);
    }
    const bool menu = dialogue_.menu;
    dialogue_ = {};
    if (!menu || key == 0) return done = true;
    if (!written(5900, static_cast<double>(key), {})) return false;
    done = !go_on_with(9500 + static_cast<std::int64_t>(key));
    return true;
}

// Another program in the place of this one: it ends where this one would have ended. False: there
// is none.
bool Interpreter::go_on_with(std::int64_t number) {
    auto file = files_->find_number(number);
    if (!file && find_program_in(frames_.back().file, number)) file = frames_.back().file;
    if (!file) return false;
    CallLevel& frame = frames_.back();
    loops_.resize(frame.loops);
    frame.file = *file;
    frame.program = number;
    frame.begin = find_program_in(*file, number).value_or(TextPosition{});
    source_ = &files_->source(*file);
    source_->seek(frame.begin);
    look_whether_hidden();
    blocks_begun_ = tape_begun_ = line_left_ = false;
    jumped_ = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
