// G65 H90 to H94: what builds the pattern menu and the pattern data screens (fanuc_lathe 11).
//
//   G65 H91 P2 Q066079 R076084        pattern 2 is called BOLT: two characters a word, three digits each
//
// The texts are messages of the program O9500 (menu) and O9501 to O9510 (data); the HMI runs these programs and shows them.
#include <fmt/format.h>

#include <cmath>

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
        if (!good) return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(number));
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
            if (code < 32 || code > 95 || code == '(' || code == ')') return core_.fail(Alarm::PatternText, letter, std::to_string(codes));
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
    return true;
}

}  // namespace polyturn::channels::fanuc
