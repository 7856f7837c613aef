#include "channels/fanuc/grammar/check_words.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/spindles/g_couplings.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::uint32_t kAlways = letter_set("NOFSTMG");

}  // namespace

bool length_word(const Execution& x) {
    const GCode* active = x.modal.in_force(GGroup::Length);
    return x.settings.power_on_length != 0 && !x.words.has(GGroup::Length) && x.block.has('H') &&
           !(x.vocabulary.axis_letters & letter_bit('H')) && active &&
           (active->tenths == 430 || active->tenths == 440);
}

// Every word must be used: an unused word is a mistake of the program.
bool check_words(Execution& x) {
    if (!polygon_alone(x)) return false;
    std::uint32_t taken = kAlways;
    for (std::uint32_t left = x.words.groups; left; left &= left - 1) {
        const GCode* row = x.words.coded[static_cast<std::size_t>(__builtin_ctz(left))];
        // whatever words it has
        if (!row->act) return x.core.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        taken |= x.vocabulary.taken_by(row);
    }
    if (!x.words.has(GGroup::OneShot) && !x.words.has(GGroup::Motion))
        taken |= x.vocabulary.taken_by(x.modal.motion);
    if (x.words.m_count) taken |= letter_set("PQL");
    if (x.settings.offsets_by_g || x.core.view().config().kind == ChannelKind::Mill)
        taken |= letter_set("D");
    if (x.modal.drilling && !x.words.has(GGroup::OneShot))
        taken |= letter_set("RQPLKEIJ") | x.vocabulary.axis_letters;
    if (length_word(x)) taken |= letter_set("H");
    if (x.modal.parameter_input) taken |= letter_set("NPR");
    if (x.modal.life.mode) taken |= letter_set("NPLQT");
    for (unsigned k = 0; k < x.words.m_count; ++k)
        if (x.block.words[x.words.m[k]].value == x.settings.interrupt.on) taken |= letter_set("P");
    for (const char letter : x.settings.aux_letters)
        if (letter) taken |= letter_bit(letter);
    for (const auto& address : x.settings.spindle_addresses)
        if (address.name.size() == 1) taken |= letter_bit(address.name[0]);
    bool calls = false;
    for (unsigned k = 0; k < x.words.m_count; ++k)
        calls = calls || x.block.words[x.words.m[k]].value == 98;
    if (x.block.name_length && !calls) {
        x.words.culprit.column = x.block.name_from;
        x.words.culprit.length = x.block.name_length + 2u;
        return x.core.fail(
            Alarm::AddressIllegal, 0,
            "<" + std::string(x.text.line.substr(x.block.name_from, x.block.name_length)) + ">");
    }
    const std::uint32_t extra = x.block.letters & ~taken;
    if (!extra) return true;
    const char letter = static_cast<char>('A' + __builtin_ctz(extra));
    return x.core.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
}

}  // namespace polyturn::channels::fanuc
