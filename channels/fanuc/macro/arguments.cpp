#include "channels/fanuc/macro/arguments.hpp"

#include <array>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/faults.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Argument specification I: letter -> variable; 0: cannot pass an argument.
constexpr std::array<std::uint8_t, 26> kArgument = {
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

// What an argument without a point counts in: the least increment of its address (fanuc_lathe
// 6.9.1), an angle's whatever the unit of lengths; D and H, numbers elsewhere, and what is no
// length are whole numbers.
double argument_step(const Execution& x, char letter) {
    constexpr std::uint32_t kCounting = letter_set("ABCEIJKQRUVWXYZ"), kAngles = letter_set("ABC");
    if (!(kCounting & letter_bit(letter))) return 1.0;
    const auto index = static_cast<std::size_t>(letter - 'A');
    const int place = x.vocabulary.absolute_axis[index] >= 0 ? x.vocabulary.absolute_axis[index]
                                                             : x.vocabulary.incremental_axis[index];
    const ChannelAxis& axis = x.core.view().axes[place < 0 ? 0 : static_cast<std::size_t>(place)];
    const bool angle = place < 0 ? (kAngles & letter_bit(letter)) != 0 : axis.rotary;
    return axis.increment * (x.modal.input.inch && !angle ? 0.1 : 1.0);
}

}  // namespace

// Words from `from_word` on become #1 ... #33. I, J, K may come in up to ten sets (specification
// II).
bool gather_arguments(Execution& x, LocalSet& arguments, std::size_t from_word) {
    arguments = empty_locals();
    std::size_t set = 0;  // of I J K, from 0
    char last_of_set = 0;
    const auto variable_of = [&](char letter) -> std::size_t {  // 0: none
        const std::size_t variable = kArgument[static_cast<std::size_t>(letter - 'A')];
        if (letter < 'I' || letter > 'K') return variable;
        if (last_of_set && letter <= last_of_set) ++set;
        last_of_set = letter;
        return set >= 10 ? 0 : variable + 3 * set;
    };
    // A word whose variable is empty gives an empty argument, and counts among the sets
    // (fanuc_lathe 6.2, 6.9.1).
    std::size_t empty = 0;
    const auto take_empties = [&](std::size_t words) {
        for (; empty < x.block.empty_count && x.block.empties[empty].before <= words; ++empty) {
            const auto [letter, before] = x.block.empties[empty];
            if (before < from_word || letter == 'N' || letter == 'O' || letter == 'P' ||
                letter == 'L')
                continue;
            if (const std::size_t variable = variable_of(letter)) arguments[variable] = kNull;
        }
    };
    for (std::size_t k = from_word; k < x.block.count; ++k) {
        take_empties(k);
        const Word& word = x.block.words[k];
        const char letter = word.address;
        if (letter == 'N' || letter == 'O' || letter == 'P' || letter == 'L') continue;
        const auto refuse = [&] {
            blame(x, word);
            return x.core.fail(Alarm::MacroArgument, 0, std::string(1, letter));
        };
        if (word.axis >= 0 || letter >= 'a') return refuse();
        const std::size_t variable = variable_of(letter);
        if (variable == 0) return refuse();
        double value = word.value;
        if (!word.has_point && !word.from_expression && !x.settings.point_means_nothing)
            value *= argument_step(x, letter);
        arguments[variable] = value;
    }
    take_empties(x.block.count);
    return true;
}

// P of a call, or <NAME>: the program of a file by its name has a number below 0 (call_program).
bool program_word(Execution& x, char letter, std::int64_t& program) {
    if (!x.block.name_length)
        return x.block.has('P') ? whole_number(x, 'P', program)
                                : x.core.fail(Alarm::SubprogramWordMissing, letter);
    if (x.block.has('P')) return x.core.fail(Alarm::AddressIllegal, 'P', "P");
    const std::string name(x.text.line.substr(x.block.name_from, x.block.name_length));
    const auto file = x.files.find_name(name);
    x.words.culprit.column = x.block.name_from;
    x.words.culprit.length = x.block.name_length + 2u;
    if (!file) return x.core.fail(Alarm::SubprogramMissing, 0, "<" + name + ">");
    x.words.culprit.column = x.words.culprit.length = 0;
    program = -1 - static_cast<std::int64_t>(*file);
    return true;
}

// L of a call: 1 to 9999 (fanuc_lathe 6.9.2).
bool call_count(Execution& x, std::int64_t& repeats) {
    repeats = 1;
    if (!x.block.has('L')) return true;
    if (!whole_number(x, 'L', repeats)) return false;
    if (repeats < 1) return x.core.fail(Alarm::ValueOutOfRange, 'L', "L");
    return repeats <= 9999 ? true : x.core.fail(Alarm::DigitsTooMany, 'L', "L");
}

bool macro_words(Execution& x, std::int64_t& program, std::int64_t& repeats, LocalSet& arguments) {
    if (!program_word(x, 'G', program) || !call_count(x, repeats)) return false;
    std::size_t from = 0;
    for (std::size_t k = 0; k < x.block.count; ++k)
        if (x.block.words[k].address == 'G' && x.block.words[k].value >= 65 &&
            x.block.words[k].value < 67)
            from = k + 1;
    return (from == 0 || call_stands_first(x, from - 1)) && gather_arguments(x, arguments, from);
}

// Arguments stand behind the call, which is word `call` of the block (fanuc_lathe 6.9.1): what
// precedes it would do nothing.
bool call_stands_first(Execution& x, std::size_t call) {
    for (std::size_t k = 0; k < call; ++k) {
        const Word& word = x.block.words[k];
        if (word.axis < 0 && (word.address == 'N' || word.address == 'O' || word.address == 'P' ||
                              word.address == 'L'))
            continue;
        blame(x, word);
        return x.core.fail(Alarm::MacroArgument, 0, std::string(text_of(x, word)));
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
