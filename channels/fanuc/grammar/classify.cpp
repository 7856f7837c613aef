#include "channels/fanuc/grammar/classify.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/mefi/shifts.hpp"

namespace polyturn::channels::fanuc {
namespace {

std::string g_name(double value) {
    std::string text = "G" + std::to_string(static_cast<long>(value));
    const long tenth = std::lround((value - std::floor(value)) * 10);
    if (tenth) text += "." + std::to_string(tenth);
    return text;
}

// The bits that would make it a code: G95 is one of systems B and C. Nothing: it is none in any of
// them.
std::string known_elsewhere(const Settings& settings, double tenths) {
    std::uint8_t systems = 0;
    for (const GCode& row : g_codes())
        if (row.tenths == tenths) systems |= row.systems;
    if (!settings.policy.words.systems_by_bits || !(systems & kFanuc)) return {};
    std::string where;
    if ((systems & kA) && settings.system != kA) where += "A: F3401#6 = 0, #7 = 0";
    if ((systems & kB) && settings.system != kB)
        where += std::string(where.empty() ? "" : "; ") + "B: F3401#6 = 1" +
                 (settings.system == kC ? ", #7 = 0" : "");
    if ((systems & kC) && settings.system != kC)
        where += std::string(where.empty() ? "" : "; ") + "C: F3401#7 = 1";
    return where.empty() ? where : " (" + where + ")";
}

bool too_many_words(Execution& x, const Word& word) {
    blame(x, word);
    return x.core.fail(Alarm::WordsTooMany);
}

}  // namespace

// A milling channel calls three drilling cycles by the numbers that a lathe needs for turning
// (N1503#0, N1611#0).
std::uint32_t drilling_name(const Execution& x, std::uint32_t tenths) {
    constexpr std::uint32_t kNoCode = 9999;
    // aliases of the codes that have moved
    if (x.settings.milling_drills && (tenths == 1830 || tenths == 1840 || tenths == 1860))
        return kNoCode;
    // G183 is G83.1 (nct part 2 17.4)
    if (x.settings.policy.words.g183_is_g83_1 &&
        (tenths == 1830 || tenths == 1840 || tenths == 1860))
        return (tenths - 1000) + 1;
    if (!x.settings.milling_drills) return tenths;
    // CSM = 0: these cycles have the numbers below, and no others (nct part 1 16.2)
    if (tenths == 831 || tenths == 841 || tenths == 861) return kNoCode;
    return tenths == 730 ? 831 : tenths == 740 ? 841 : tenths == 760 ? 861 : tenths;
}

// Sorts the words: G rows by group, M words, axis words.
bool classify(Execution& x) {
    x.words.groups = 0;
    x.words.m_count = x.words.axis_count = x.words.g_count = x.words.comma_count = 0;
    x.words.spindles = false;
    x.words.comma_angle = -1;
    for (unsigned i = 0; i < x.block.count; ++i) {
        const Word& word = x.block.words[i];
        if (word.axis >= kSpindleWord) {
            x.words.spindles = true;
            continue;
        }
        if (word.axis >= 0) {
            if (x.words.axis_count == x.words.axes.size()) return too_many_words(x, word);
            x.words.axes[x.words.axis_count++] = static_cast<std::uint8_t>(i);
            continue;
        }
        const char letter = word.address;
        if (letter >= 'a') {
            if (letter == 'a' && x.words.comma_angle < 0 && !x.block.has('A') &&
                x.settings.policy.words.comma_words) {
                x.words.comma_angle = static_cast<int>(i);
                continue;
            }
            if (x.words.comma_count == x.words.commas.size() ||
                !x.settings.policy.words.comma_words) {
                blame(x, word);
                return x.core.fail(Alarm::AddressIllegal, 0,
                                   std::string(",") + static_cast<char>(letter - 32));
            }
            x.words.commas[x.words.comma_count++] = static_cast<std::uint8_t>(i);
            continue;
        }
        if (letter == 'G') {
            const double tenths = word.value * 10.0, whole_tenths = std::nearbyint(tenths);
            const GCode* row =
                std::fabs(tenths - whole_tenths) < 1e-6 && whole_tenths >= 0 && whole_tenths < 10000
                    ? x.vocabulary.table.find(
                          drilling_name(x, static_cast<std::uint32_t>(whole_tenths)))
                    : nullptr;
            if (!row) {
                blame(x, word);
                return x.core.fail(Alarm::GCodeUnknown, 'G',
                                   g_name(word.value) + known_elsewhere(x.settings, whole_tenths));
            }
            if (x.words.g_count < x.words.g.size())
                x.words.g[x.words.g_count++] = static_cast<std::uint8_t>(i);
            x.words.coded[static_cast<std::size_t>(row->group)] = row;
            x.words.groups |= bit_of(row->group);
        } else if (letter == 'M') {
            // fanuc_lathe 6.1
            if (word.from_expression) x.block.words[i].value = whole_steps(word.value, 1.0);
            if (x.words.m_count == x.words.m.size()) return too_many_words(x, word);
            x.words.m[x.words.m_count++] = static_cast<std::uint8_t>(i);
        } else if (x.vocabulary.axis_letters >> (letter - 'A') & 1u) {
            if (x.words.axis_count == x.words.axes.size()) return too_many_words(x, word);
            x.words.axes[x.words.axis_count++] = static_cast<std::uint8_t>(i);
        }
    }
    // H behind G43, G44, G43.7, G43.4, G43.1 is an offset number, not the increment of an axis.
    const bool tip_control =
        x.words.has(GGroup::Transform) && x.words.row(GGroup::Transform)->is(Trait::Length);
    if ((x.words.has(GGroup::Length) || tip_control) && x.block.has('H') &&
        x.vocabulary.absolute_axis['H' - 'A'] < 0) {
        unsigned kept = 0;
        for (unsigned k = 0; k < x.words.axis_count; ++k)
            if (x.block.words[x.words.axes[k]].axis >= 0 ||
                x.block.words[x.words.axes[k]].address != 'H')
                x.words.axes[kept++] = x.words.axes[k];
        x.words.axis_count = kept;
    }
    return !x.settings.policy.words.once || says_it_once(x);
}

const GCode* g_row(const Execution& x, unsigned k) {
    return x.vocabulary.table.find(
        static_cast<std::uint32_t>(std::lround(x.block.words[x.words.g[k]].value * 10.0)));
}

// In the block of G65 and G66 all other words are arguments, and no other G code may stand there.
bool is_macro_call(const Execution& x) {
    for (unsigned k = 0; k < x.words.g_count; ++k)
        if (const GCode* row = g_row(x, k);
            row && (row->is(Trait::MacroCall) || row->is(Trait::MacroCall)))
            return true;
    return false;
}

}  // namespace polyturn::channels::fanuc
