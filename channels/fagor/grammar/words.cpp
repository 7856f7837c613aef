#include "channels/fagor/grammar/words.hpp"

#include <cmath>
#include <string>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/tools/m_functions.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr std::size_t at(GGroup group) { return static_cast<std::size_t>(group); }
constexpr std::uint32_t kAlways = letter_set("FSTDM");
constexpr double kLargestNumber = 99'999.9999;  // of ±5.4
constexpr double kLargestProgram = 999'999;     // Q of a profile cycle has six digits

}  // namespace

bool BlockWords::has_axes_beside(std::string_view others) const {
    for (const Word* word : axis)
        if (word && others.find(word->letter) == std::string_view::npos) return true;
    return false;
}

bool whole(Execution& x, const Word& word, std::int64_t& value) {
    const double rounded = std::nearbyint(word.value);
    if (std::fabs(word.value - rounded) > 1e-6)
        return x.fail_word(word, Alarm::PointForbidden, std::string(1, word.letter));
    if (rounded < 0) return x.fail_word(word, Alarm::NegativeSign, std::string(1, word.letter));
    value = static_cast<std::int64_t>(rounded);
    return true;
}

// Sorts the words: G rows by group with the words bound to them, M words, axis words.
bool classify(Execution& x) {
    const Block& block = x.line.block;
    BlockWords& words = x.words;
    words.codes.fill(nullptr);
    words.letters = words.mirrors = 0;
    words.axis.fill(nullptr);
    words.axis_count = words.m_count = 0;
    words.element = words.bound_number = words.second_centre = nullptr;
    words.repeats = -1;
    words.in_machine = false;
    bool cycle = false;
    for (unsigned i = 0; i < block.count; ++i) {
        const Word& word = block.words[i];
        if (word.letter == 'G') {
            std::int64_t number = 0;
            if (!whole(x, word, number)) return false;
            const GCode* row = number < 1000 ? find_g_code(static_cast<unsigned>(number)) : nullptr;
            if (!row) return x.fail_word(word, Alarm::GCodeUnknown, "G" + std::to_string(number));
            const GCode*& before = words.codes[at(row->group)];
            if (row->group == GGroup::Mirror && row->number >= 11 &&
                (!before || before->number >= 11))
                words.mirrors |= 1u << (row->number - 11);
            else if (before && before != row)
                return x.fail_word(
                    word, Alarm::FagorIncompatible,
                    "G" + std::to_string(before->number) + " G" + std::to_string(number));
            before = row;
            cycle = cycle || row->group == GGroup::Cycle;
            if (row->binds && i + 1 < block.count && block.words[i + 1].letter == row->binds)
                (row->binds == 'R' ? words.element : words.bound_number) = &block.words[++i];
            continue;
        }
        const auto letter = static_cast<std::size_t>(word.letter - 'A');
        if (word.letter == 'M' && !cycle) {
            if (words.m_count == words.m.size()) return x.fail_word(word, Alarm::WordsTooMany);
            words.m[words.m_count++] = &word;
            continue;
        }
        if (word.letter == 'N') {
            std::int64_t number = 0;
            if (!whole(x, word, number)) return false;
            if (number > 9999) return x.fail_word(word, Alarm::FagorLabel);
            words.repeats = number;
            continue;
        }
        const bool program = word.letter == 'Q' && cycle && words.code(GGroup::Cycle)->number < 81;
        if (std::fabs(word.value) > (program ? kLargestProgram : kLargestNumber) + 5e-5)
            return x.fail_word(word, Alarm::DigitsTooMany, std::string(1, word.letter));
        if (words.by_letter[letter]) {
            // The plane X U has two centre words of one letter, the first of X.
            if (word.letter >= 'I' && word.letter <= 'K' && !words.second_centre) {
                words.second_centre = &word;
                continue;
            }
            return x.fail_word(word, Alarm::FagorWordTwice, std::string(1, word.letter));
        }
        words.by_letter[letter] = &word;
        words.letters |= letter_bit(word.letter);
        const int place = x.places.of(word.letter);
        if (cycle || place < 0) continue;
        words.axis[static_cast<std::size_t>(place)] = &word;
        ++words.axis_count;
    }
    return true;
}

// Every word must be used: an unused word is a mistake of the program.
bool check_words(Execution& x) {
    const BlockWords& words = x.words;
    std::uint32_t taken = kAlways, axes = 0;
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (x.places.of(letter) >= 0) axes |= letter_bit(letter);
    unsigned codes = 0;
    const GCode* alone = nullptr;
    bool own_motion = false;
    for (const GCode* row : words.codes) {
        if (!row) continue;
        ++codes;
        if (row->alone) alone = row;
        own_motion = own_motion || (row->group == GGroup::OneShot && row->number != 4) ||
                     row->group == GGroup::Cycle || row->number == 8 || row->number == 9 ||
                     row->number == 16 || row->number == 51;
        for (const char letter : row->takes) taken |= letter == 'x' ? axes : letter_bit(letter);
    }
    if (words.has(GGroup::Cycle))
        taken &= ~(letter_set("FSTDM") & ~letter_set(words.code(GGroup::Cycle)->takes));
    if (!own_motion && !words.has(GGroup::Motion)) {
        for (const char letter : find_g_code(x.modal.motion)->takes)
            taken |= letter == 'x' ? axes : letter_bit(letter);
    }
    if (alone && (codes > 1 || words.m_count ||
                  (words.letters & letter_set("FSTDM") & ~letter_set(alone->takes))))
        return x.fail(Alarm::FagorAlone, 'G', "G" + std::to_string(alone->number));
    if (const std::uint32_t extra = words.letters & ~taken) {
        const char letter = static_cast<char>('A' + __builtin_ctz(extra));
        return x.fail_word(*words.word(letter), Alarm::AddressIllegal, std::string(1, letter));
    }
    if (words.has(GGroup::OneShot) && words.has(GGroup::Motion) &&
        words.code(GGroup::OneShot)->number != 4) {
        const unsigned a = words.code(GGroup::OneShot)->number,
                       b = words.code(GGroup::Motion)->number;
        // G01 holds behind G52, G75 and G76 anyway.
        if (!((a == 52 || a == 75 || a == 76) && b == 1))
            return x.fail(Alarm::FagorIncompatible, 'G',
                          "G" + std::to_string(a) + " G" + std::to_string(b));
    }
    const bool threading = words.has(GGroup::Motion) ? words.code(GGroup::Motion)->number >= 33
                                                     : x.modal.motion >= 33 && words.has_axes();
    if (x.modal.corner == 51 && !words.has(GGroup::Corner)) {
        const bool stop = words.has(GGroup::OneShot) && words.code(GGroup::OneShot)->number == 52;
        const bool revolution = words.has(GGroup::Feed) && words.code(GGroup::Feed)->number == 95;
        if (threading || stop || revolution)
            return x.fail(Alarm::FagorIncompatible, 'G',
                          threading ? "G51 and a thread"
                          : stop    ? "G51 G52"
                                    : "G51 G95");
    }
    if (words.repeats >= 0 && x.modal.modal_call.kind == ModalCall::Kind::None)
        return x.fail(Alarm::FagorRepeat, 'N');
    for (unsigned k = 0; k < words.m_count; ++k) {
        const MEntry* entry = m_entry(x, words.m[k]->value);
        if (entry && entry->subroutine && words.m_count > 1)
            return x.fail_word(*words.m[k], Alarm::FagorMAlone, {}, entry->code);
    }
    return true;
}

}  // namespace polyturn::channels::fagor
