// Macro calls: G65, G66, G67, and the G, M, T codes and letters that call programs.
#include <algorithm>
#include <cmath>

#include "channels/fanuc/interpreter.hpp"
#include "channels/fanuc/macro/expression.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Argument specification I: letter -> variable; 0: cannot pass an argument.
constexpr std::array<std::uint8_t, 26> kArgument = {
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

}  // namespace

// Words from `from_word` on become #1 ... #33. I, J, K may come in up to ten sets (specification
// II).
bool Interpreter::gather_arguments(LocalSet& arguments, std::size_t from_word) {
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
        for (; empty < block_.empty_count && block_.empties[empty].before <= words; ++empty) {
            const auto [letter, before] = block_.empties[empty];
            if (before < from_word || letter == 'N' || letter == 'O' || letter == 'P' ||
                letter == 'L')
                continue;
            if (const std::size_t variable = variable_of(letter)) arguments[variable] = kNull;
        }
    };
    for (std::size_t k = from_word; k < block_.count; ++k) {
        take_empties(k);
        const Word& word = block_.words[k];
        const char letter = word.address;
        if (letter == 'N' || letter == 'O' || letter == 'P' || letter == 'L') continue;
        const auto refuse = [&] {
            fault_column_ = word.column;
            fault_length_ = word.length;
            return core_.fail(Alarm::MacroArgument, 0, std::string(1, letter));
        };
        if (word.axis >= 0 || letter >= 'a') return refuse();
        const std::size_t variable = variable_of(letter);
        if (variable == 0) return refuse();
        double value = word.value;
        if (!word.has_point && !word.from_expression && !settings_.point_means_nothing)
            value *= argument_step(letter);
        arguments[variable] = value;
    }
    take_empties(block_.count);
    return true;
}

// What an argument without a point counts in: the least increment of its address (fanuc_lathe
// 6.9.1), an angle's whatever the unit of lengths; D and H, numbers elsewhere, and what is no
// length are whole numbers.
double Interpreter::argument_step(char letter) const {
    constexpr std::uint32_t kCounting = letter_set("ABCEIJKQRUVWXYZ"), kAngles = letter_set("ABC");
    if (!(kCounting & letter_bit(letter))) return 1.0;
    const auto index = static_cast<std::size_t>(letter - 'A');
    const int place = absolute_axis_[index] >= 0 ? absolute_axis_[index] : incremental_axis_[index];
    const ChannelAxis& axis = core_.view().axes[place < 0 ? 0 : static_cast<std::size_t>(place)];
    const bool angle = place < 0 ? (kAngles & letter_bit(letter)) != 0 : axis.rotary;
    return axis.increment * (inch_ && !angle ? 0.1 : 1.0);
}

// P of a call, or <NAME>: the program of a file by its name has a number below 0 (call_program).
bool Interpreter::program_word(char letter, std::int64_t& program) {
    if (!block_.name_length)
        return block_.has('P') ? whole('P', program)
                               : core_.fail(Alarm::SubprogramWordMissing, letter);
    if (block_.has('P')) return core_.fail(Alarm::AddressIllegal, 'P', "P");
    const std::string name(line_.substr(block_.name_from, block_.name_length));
    const auto file = files_->find_name(name);
    fault_column_ = block_.name_from;
    fault_length_ = block_.name_length + 2u;
    if (!file) return core_.fail(Alarm::SubprogramMissing, 0, "<" + name + ">");
    fault_column_ = fault_length_ = 0;
    program = -1 - static_cast<std::int64_t>(*file);
    return true;
}

// L of a call: 1 to 9999 (fanuc_lathe 6.9.2).
bool Interpreter::call_count(std::int64_t& repeats) {
    repeats = 1;
    if (!block_.has('L')) return true;
    if (!whole('L', repeats)) return false;
    if (repeats < 1) return core_.fail(Alarm::ValueOutOfRange, 'L', "L");
    return repeats <= 9999 ? true : core_.fail(Alarm::DigitsTooMany, 'L', "L");
}

bool Interpreter::macro_words(std::int64_t& program, std::int64_t& repeats, LocalSet& arguments) {
    if (!program_word('G', program) || !call_count(repeats)) return false;
    std::size_t from = 0;
    for (std::size_t k = 0; k < block_.count; ++k)
        if (block_.words[k].address == 'G' && block_.words[k].value >= 65 &&
            block_.words[k].value < 67)
            from = k + 1;
    return (from == 0 || call_stands_first(from - 1)) && gather_arguments(arguments, from);
}

// Arguments stand behind the call, which is word `call` of the block (fanuc_lathe 6.9.1): what
// precedes it would do nothing.
bool Interpreter::call_stands_first(std::size_t call) {
    for (std::size_t k = 0; k < call; ++k) {
        const Word& word = block_.words[k];
        if (word.axis < 0 && (word.address == 'N' || word.address == 'O' || word.address == 'P' ||
                              word.address == 'L'))
            continue;
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(Alarm::MacroArgument, 0, std::string(text_of(word)));
    }
    return true;
}

bool Interpreter::g_macro_call(const GCode&) {
    if (block_.has('H') && !settings_.nct) {
        std::int64_t kind = 0;
        if (!block_.word('H').has_point && block_.value('H') >= 90 && block_.value('H') <= 94)
            return whole('H', kind) && g_pattern_data(kind);
    }
    std::int64_t program = 0, repeats = 1;
    LocalSet arguments;
    if (!macro_words(program, repeats, arguments)) return false;
    called_ = true;
    return call_program(program, repeats, &arguments, false, false, 'P');
}

bool Interpreter::g_macro_modal(const GCode& row) {
    ModalCall call;
    if (!macro_words(call.program, call.repeats, call.arguments)) return false;
    if (modal_calls_.size() >= settings_.macro_levels)
        return core_.fail(Alarm::MacroTooDeep, 'G', {}, settings_.macro_levels);
    call.every_block = row.tenths == 661;
    modal_calls_.push_back(call);
    return true;
}

bool Interpreter::g_macro_modal_off(const GCode&) {
    if (!modal_calls_.empty()) modal_calls_.pop_back();
    return true;
}

// Between G66.1 and G67 a block does nothing itself: its words are arguments, as behind G65 (nct
// part 2 18.2, "called for every block"; what becomes of the words is the field's standard). The
// end of a program and a block that calls a subprogram are none.
bool Interpreter::gives_arguments() const {
    if (modal_calls_.empty() || !modal_calls_.back().every_block || !modal_calls_.back().armed ||
        b_.registering || life_.mode)
        return false;
    if (sub_program_ >= 0 || !(block_.letters & ~letter_set("NO"))) return false;
    for (std::size_t k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
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
const Word* Interpreter::stops_or_waits() const {
    for (std::size_t k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        if (word.axis >= 0 || word.address != 'M') continue;
        const double code = word.from_expression ? whole_steps(word.value, 1.0) : word.value;
        if (code == 0 || code == 1 || core_.view().machine.is_wait_code(code)) return &word;
    }
    return nullptr;
}

// Whether another word of such a block would move or switch, or be an argument only, is not
// specified: it is alone in its block (P: the channels).
bool Interpreter::stands_alone(const Word& stop) {
    for (std::size_t k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        if (&word == &stop ||
            (word.axis < 0 && (word.address == 'N' || word.address == 'O' || word.address == 'P')))
            continue;
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(Alarm::CodesContradict, 0,
                          std::string(text_of(stop)) + " and " + std::string(text_of(word)));
    }
    return true;
}

// G, L and P are no arguments, as behind G65.
bool Interpreter::per_block_call() {
    const ModalCall modal = modal_calls_.back();
    for (std::size_t k = 0; k < block_.count; ++k)
        if (block_.words[k].axis < 0 && block_.words[k].address == 'G')
            block_.words[k].address = 'N';
    LocalSet arguments = empty_locals();
    called_ = true;
    return gather_arguments(arguments, 0) &&
           call_program(modal.program, modal.repeats, &arguments, false, true, 0);
}

// Codes that call programs instead of acting. `called` says whether the block was used up by a
// call.
bool Interpreter::code_calls(bool& called) {
    sub_program_ = local_call_ = -1;
    const bool inside = std::any_of(frames_.begin() + 1, frames_.end(),
                                    [](const CallLevel& f) { return f.by_code; });
    if (inside && !settings_.nested_calls) return true;
    for (std::size_t k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        const char word_letter = word.address;
        if (word.axis >= 0 || word_letter >= 'a') continue;
        // A subprogram is called when the rest of the block has acted, as by M98; the word itself
        // does nothing else.
        const auto later = [&](std::int32_t program, std::int64_t repeats,
                               bool repeats_word = false) {
            sub_program_ = program;
            sub_repeats_ = repeats;
            sub_column_ = word.column;
            sub_length_ = word.length;
            block_.words[k].address = 'N';
            if (repeats_word) block_.letters &= ~letter_bit('L');  // it was the number of calls
            bool another = false;
            for (std::size_t j = 0; j < block_.count; ++j)
                another = another || block_.words[j].address == word_letter;
            if (!another) block_.letters &= ~letter_bit(word_letter);
            return true;
        };
        const auto use = [&](const CodeCall& call, std::int32_t program) {
            LocalSet arguments = empty_locals();
            std::int64_t repeats = 1;
            if (!call_count(repeats)) return false;
            if (!call.macro) return later(program, repeats, block_.has('L'));
            called = called_ = true;
            // Every other word of the block is an argument (nct part 2 18.2, 18.3); behind a G code
            // of fanuc as behind G65 (6.9.4).
            if (word.address == 'M' || settings_.nct) {
                const Word code = word;
                block_.words[k].address = 'N';
                const bool good = gather_arguments(arguments, 0);
                block_.words[k] = code;
                if (!good) return false;
            } else if (!call_stands_first(k) || !gather_arguments(arguments, k + 1)) {
                return false;
            }
            if (call.modal) {
                ModalCall modal;
                modal.program = program;
                modal.repeats = repeats;
                modal.every_block = call.modal == 2;
                modal.arguments = arguments;
                if (modal_calls_.size() >= settings_.macro_levels)
                    return core_.fail(Alarm::MacroTooDeep, word.address, {},
                                      settings_.macro_levels);
                modal_calls_.push_back(modal);
                return true;
            }
            return call_program(program, repeats, &arguments, true, false, word.address);
        };
        if (word.address == 'G') {
            const auto tenths = static_cast<std::int32_t>(std::lround(word.value * 10));
            for (const CodeCall& call : settings_.g_calls)
                if (call.code == tenths) return use(call, call.program);
        } else if (word.address == 'M') {
            for (const CodeCall& call : settings_.m_calls)
                if (call.code == static_cast<std::int32_t>(word.value)) {
                    // must be the first word
                    if (call.macro && !settings_.nct &&
                        k > (block_.words[0].address == 'N' ? 1u : 0u))
                        continue;
                    return use(call, call.program);
                }
        } else {
            for (const Settings::LetterCall& call : settings_.letter_calls)
                if (call.letter == word.address) {
                    if (letters_written_in_ != core_.at.serial) {
                        letters_written_in_ = core_.at.serial;
                        letters_written_ = 0;
                    }
                    if (!(letters_written_ & letter_bit(word.address)) &&
                        !written(call.variable, word.value, {}))
                        return false;
                    letters_written_ |= letter_bit(word.address);
                    return later(call.program, 1);
                }
        }
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
