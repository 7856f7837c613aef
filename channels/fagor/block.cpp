// One block of words: what it codes, whether every word has a taker, and the order in which it
// acts.
#include <cmath>
#include <string>

#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr std::size_t at(GGroup group) { return static_cast<std::size_t>(group); }
constexpr std::uint32_t kAlways = letter_set("FSTDM");
constexpr double kLargestNumber = 99'999.9999;  // of ±5.4
constexpr double kLargestInch = 3'937.00787;    // of ±4.5 (part 1, 3.3)
constexpr double kLargestProgram = 999'999;     // Q of a profile cycle has six digits

}  // namespace

const Word* Interpreter::word(char letter) const {
    return by_letter_[static_cast<std::size_t>(letter - 'A')];
}

bool Interpreter::whole(const Word& word, std::int64_t& value) {
    const double rounded = std::nearbyint(word.value);
    if (std::fabs(word.value - rounded) > 1e-6)
        return fail_word(word, Alarm::PointForbidden, std::string(1, word.letter));
    if (rounded < 0) return fail_word(word, Alarm::NegativeSign, std::string(1, word.letter));
    value = static_cast<std::int64_t>(rounded);
    return true;
}

// Sorts the words: G rows by group with the words bound to them, M words, axis words.
bool Interpreter::classify() {
    coded_.fill(nullptr);
    letters_ = mirrors_ = 0;
    axis_words_.fill(nullptr);
    axis_word_count_ = m_count_ = 0;
    element_word_ = number_word_ = centre_second_ = nullptr;
    repeats_ = -1;
    in_machine_ = false;
    bool cycle = false;
    for (unsigned i = 0; i < block_.count; ++i) {
        const Word& word = block_.words[i];
        if (word.letter == 'G') {
            std::int64_t number = 0;
            if (!whole(word, number)) return false;
            const GCode* row = number < 1000 ? find_g_code(static_cast<unsigned>(number)) : nullptr;
            if (!row) return fail_word(word, Alarm::GCodeUnknown, "G" + std::to_string(number));
            const GCode*& before = coded_[at(row->group)];
            if (row->group == GGroup::Mirror && row->number >= 11 &&
                (!before || before->number >= 11))
                mirrors_ |= 1u << (row->number - 11);
            else if (before && before != row)
                return fail_word(
                    word, Alarm::FagorIncompatible,
                    "G" + std::to_string(before->number) + " G" + std::to_string(number));
            before = row;
            cycle = cycle || row->group == GGroup::Cycle;
            if (row->binds && i + 1 < block_.count && block_.words[i + 1].letter == row->binds)
                (row->binds == 'R' ? element_word_ : number_word_) = &block_.words[++i];
            continue;
        }
        const auto letter = static_cast<std::size_t>(word.letter - 'A');
        if (word.letter == 'M' && !cycle) {
            if (m_count_ == m_words_.size()) return fail_word(word, Alarm::WordsTooMany);
            m_words_[m_count_++] = &word;
            continue;
        }
        if (word.letter == 'N') {
            std::int64_t number = 0;
            if (!whole(word, number)) return false;
            if (number > 9999) return fail_word(word, Alarm::FagorLabel);
            repeats_ = number;
            continue;
        }
        const bool program = word.letter == 'Q' && cycle && coded_[at(GGroup::Cycle)]->number < 81;
        if (std::fabs(word.value) > (program ? kLargestProgram : kLargestNumber) + 5e-5)
            return fail_word(word, Alarm::DigitsTooMany, std::string(1, word.letter));
        if (by_letter_[letter]) {
            // The plane X U has two centre words of one letter, the first of X.
            if (word.letter >= 'I' && word.letter <= 'K' && !centre_second_) {
                centre_second_ = &word;
                continue;
            }
            return fail_word(word, Alarm::FagorWordTwice, std::string(1, word.letter));
        }
        by_letter_[letter] = &word;
        letters_ |= letter_bit(word.letter);
        if (cycle || place_[letter] < 0) continue;
        axis_words_[static_cast<std::size_t>(place_[letter])] = &word;
        ++axis_word_count_;
    }
    // A cycle may stand behind other codes of its block.
    return true;
}

// Every word must be used: an unused word is a mistake of the program.
bool Interpreter::check_words() {
    std::uint32_t taken = kAlways, axes = 0;
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (place_[i] >= 0) axes |= 1u << i;
    unsigned codes = 0;
    const GCode* alone = nullptr;
    bool own_motion = false;
    for (const GCode* row : coded_) {
        if (!row) continue;
        ++codes;
        if (row->alone) alone = row;
        own_motion = own_motion || (row->group == GGroup::OneShot && row->number != 4) ||
                     row->group == GGroup::Cycle || row->number == 8 || row->number == 9 ||
                     row->number == 16 || row->number == 51;
        for (const char letter : row->takes) taken |= letter == 'x' ? axes : letter_bit(letter);
    }
    if (coded(GGroup::Cycle))
        taken &= ~(letter_set("FSTDM") & ~letter_set(coded_[at(GGroup::Cycle)]->takes));
    if (!own_motion && !coded(GGroup::Motion)) {
        for (const char letter : find_g_code(modal_.motion)->takes)
            taken |= letter == 'x' ? axes : letter_bit(letter);
    }
    if (alone &&
        (codes > 1 || m_count_ || (letters_ & letter_set("FSTDM") & ~letter_set(alone->takes))))
        return core_.fail(Alarm::FagorAlone, 'G', "G" + std::to_string(alone->number));
    if (const std::uint32_t extra = letters_ & ~taken) {
        const char letter = static_cast<char>('A' + __builtin_ctz(extra));
        return fail_word(*word(letter), Alarm::AddressIllegal, std::string(1, letter));
    }
    if (coded(GGroup::OneShot) && coded(GGroup::Motion) &&
        coded_[at(GGroup::OneShot)]->number != 4) {
        const unsigned a = coded_[at(GGroup::OneShot)]->number,
                       b = coded_[at(GGroup::Motion)]->number;
        // G01 holds behind G52, G75 and G76 anyway.
        if (!((a == 52 || a == 75 || a == 76) && b == 1))
            return core_.fail(Alarm::FagorIncompatible, 'G',
                              "G" + std::to_string(a) + " G" + std::to_string(b));
    }
    const bool threading = coded(GGroup::Motion) ? coded_[at(GGroup::Motion)]->number >= 33
                                                 : modal_.motion >= 33 && has_axes();
    if (modal_.corner == 51 && !coded(GGroup::Corner)) {
        const bool stop = coded(GGroup::OneShot) && coded_[at(GGroup::OneShot)]->number == 52;
        const bool revolution = coded(GGroup::Feed) && coded_[at(GGroup::Feed)]->number == 95;
        if (threading || stop || revolution)
            return core_.fail(Alarm::FagorIncompatible, 'G',
                              threading ? "G51 and a thread"
                              : stop    ? "G51 G52"
                                        : "G51 G95");
    }
    if (repeats_ >= 0 && modal_.modal_call.kind == ModalCall::Kind::None)
        return core_.fail(Alarm::FagorRepeat, 'N');
    for (unsigned k = 0; k < m_count_; ++k) {
        const MEntry* entry = m_entry(m_words_[k]->value);
        if (entry && entry->subroutine && m_count_ > 1)
            return fail_word(*m_words_[k], Alarm::FagorMAlone, {}, entry->code);
    }
    return true;
}

bool Interpreter::act() {
    const auto run = [this](GGroup group) {
        const GCode* row = coded_[at(group)];
        return !row || !row->act || (this->*row->act)(*row);
    };
    for (const GGroup group :
         {GGroup::Units, GGroup::XFormat, GGroup::Plane, GGroup::Distance, GGroup::Feed})
        if (!run(group)) return false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (axis_words_[i] && modal_.inch && !core_.view().axes[i].rotary &&
            !coded(GGroup::Machine) && std::fabs(axis_words_[i]->value) > kLargestInch + 5e-6)
            return fail_word(*axis_words_[i], Alarm::DigitsTooMany,
                             std::string(1, axis_words_[i]->letter));
    const GCode* one_shot = coded_[at(GGroup::OneShot)];
    const GCode* cycle = coded_[at(GGroup::Cycle)];
    const bool own_words = (one_shot && one_shot->number != 4 && one_shot->number != 52 &&
                            one_shot->number != 75 && one_shot->number != 76) ||
                           cycle;
    if (coded(GGroup::Motion)) modal_.motion = coded_[at(GGroup::Motion)]->number;
    if (!own_words && has('F') && !feed_word()) return false;
    if (!run(GGroup::Spindle)) return false;
    if (!own_words && modal_.m_done < 0 && !(spindle_word() && tool_words())) return false;
    if (m_count_ && !m_before()) return false;
    if (called_) return true;  // the subroutine of an M function comes first
    if (!core_.commit_spindle()) return false;
    for (const GGroup group : {GGroup::Corner, GGroup::Mirror, GGroup::Comp})
        if (!run(group)) return false;
    if (one_shot && one_shot->number == 4 && !g_dwell(*one_shot)) return false;
    if (coded(GGroup::Machine) && !begin_machine_block()) return false;
    if (one_shot && one_shot->number != 4) {
        if (!(this->*one_shot->act)(*one_shot)) return false;
    } else if (cycle) {
        core_.at.cycle = cycle_name(cycle->number);
        const bool good = (this->*cycle->act)(*cycle);
        core_.at.cycle = {};
        if (!good) return false;
    } else if (coded(GGroup::Modifier) && coded_[at(GGroup::Modifier)]->number != 6) {
        if (!g_arc(*coded_[at(GGroup::Modifier)])) return false;
    } else if (has_axes() || has('Q') || has('R') ||
               (modal_.motion >= 2 && (letters_ & letter_set("IJK")))) {
        const GCode* motion = find_g_code(modal_.motion);
        if (coded(GGroup::Plane) && modal_.plane == 16) return true;
        const bool ends_comp = coded(GGroup::Comp) && coded_[at(GGroup::Comp)]->number == 40;
        // no arc without a way
        if (ends_comp && (modal_.motion == 2 || modal_.motion == 3) && at_standstill())
            return !m_count_ || m_after();
        if (!(this->*motion->act)(*motion)) return false;
    } else if (coded(GGroup::Element)) {
        return core_.fail(Alarm::FagorMotionWord, 'G', "a motion",
                          coded_[at(GGroup::Element)]->number);
    }
    if (ended_) return true;
    return m_count_ ? m_after() : true;
}

bool Interpreter::has_positioning_axes(std::string_view letters) const {
    for (const Word* word : axis_words_)
        if (word && letters.find(word->letter) == std::string_view::npos) return true;
    return false;
}

std::string_view Interpreter::cycle_name(unsigned number) {
    static constexpr std::string_view kNames[] = {"G81", "G82", "G83", "G84", "G85",
                                                  "G86", "G87", "G88", "G89"};
    if (number >= 81) return kNames[number - 81];
    return number == 66 ? "G66" : number == 68 ? "G68" : "G69";
}

// Millimetres (X as a radius) or degrees of a programmed number.
double Interpreter::length(double programmed, int place) const {
    const MachineView& view = core_.view();
    if (place < 0) return programmed * unit();
    const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
    if (axis.rotary) return programmed;
    return programmed * unit() * (axis.diameter ? 0.5 : 1.0);
}

double Interpreter::from_length(double true_mm, int place) const {
    const MachineView& view = core_.view();
    if (place < 0) return true_mm / unit();
    const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
    if (axis.rotary) return true_mm;
    return true_mm * (axis.diameter ? 2.0 : 1.0) / unit();
}

}  // namespace polyturn::channels::fagor
