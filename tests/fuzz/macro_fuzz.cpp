// libs: polyturn_channels
//
// Macro programs put together from statements, functions, calls and jumps
// in any order: each ends, loops (and is stopped by the caller), or is refused with an alarm.
#include "tests/fuzz/draw.hpp"
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

namespace {

std::string operand(fuzz::Draw& draw, int depth) {
    static constexpr const char* kFunctions[] = {"SIN",  "COS", "TAN", "ASIN", "ACOS",  "ATAN",
                                                 "SQRT", "ABS", "LN",  "EXP",  "ROUND", "FIX",
                                                 "FUP",  "BIN", "BCD", "RO"};
    static constexpr int kSystem[] = {0,    1000, 1032, 1100, 1132,  2001,   2701, 3000, 3001,
                                      3003, 3011, 3901, 4001, 4109,  4120,   5001, 5021, 5041,
                                      5061, 5081, 5201, 5221, 10001, 100101, 99999};
    switch (depth > 0 ? draw.below(5) : draw.below(2)) {
        case 0:
            return draw.number(draw.length());
        case 1:
            return "#" + std::to_string(draw.below(4) ? static_cast<int>(draw.below(200))
                                                      : kSystem[draw.below(std::size(kSystem))]);
        case 2:
            return "[" + operand(draw, depth - 1) + "]";
        case 3: {
            const std::string name = kFunctions[draw.below(std::size(kFunctions))];
            return name + "[" + operand(draw, depth - 1) + "]" +
                   (name == "ATAN" ? "/[" + operand(draw, depth - 1) + "]" : "");
        }
        default: {
            static constexpr const char* kSigns[] = {"+",     "-",    "*",     "/",    " MOD ",
                                                     " AND ", " OR ", " XOR ", " EQ ", " LT "};
            return "[" + operand(draw, depth - 1) + kSigns[draw.below(std::size(kSigns))] +
                   operand(draw, depth - 1) + "]";
        }
    }
}

std::string condition(fuzz::Draw& draw) {
    static constexpr const char* kSigns[] = {" EQ ", " NE ", " GT ", " GE ", " LT ", " LE "};
    return "[" + operand(draw, 2) + kSigns[draw.below(std::size(kSigns))] + operand(draw, 2) + "]";
}

std::string program(fuzz::Draw& draw) {
    std::string text = "O1\n";
    for (int line = 0; line < 40 && !draw.empty(); ++line) {
        const std::string n = "N" + std::to_string(line) + " ",
                          m = std::to_string(1 + draw.below(4));
        switch (draw.below(14)) {
            case 0:
            case 1:
            case 2:
                text += n + "#" +
                        (draw.below(6) ? std::to_string(100 + draw.below(60)) : operand(draw, 1)) +
                        "=" + operand(draw, 3) + "\n";
                break;
            case 3:
                text += n + "IF" + condition(draw) + "GOTO" + std::to_string(draw.below(45)) + "\n";
                break;
            case 4:
                text += n + "IF" + condition(draw) + "THEN#" + std::to_string(draw.below(34)) +
                        "=" + operand(draw, 2) + "\n";
                break;
            case 5:
                text += "WHILE" + condition(draw) + "DO" + m + "\n";
                break;
            case 6:
                text += "END" + m + "\n";
                break;
            case 7:
                text += n + "GOTO[" + operand(draw, 1) + "]\n";
                break;
            case 8:
                text += n + "G65P1L" + std::to_string(draw.below(4)) + draw.word('A') +
                        draw.word('I') + draw.word('J') + draw.word('I') + "\n";
                break;
            case 9:
                text += n + (draw.below(2) ? "G66P2A1.\n" : "G67\n");
                break;
            case 10:
                text += n + "G0X#" + std::to_string(draw.below(34)) + "Z" + operand(draw, 2) + "\n";
                break;
            case 11:
                text += "DPRNT[X" + std::string("#") + std::to_string(draw.below(150)) + "[" +
                        std::to_string(draw.below(99)) + "]*Z]\nPOPEN\n";
                break;
            case 12:
                text += n + "M98P2\n";
                break;
            default:
                text +=
                    n + (draw.below(2) ? "M99\n" : "M99P" + std::to_string(draw.below(45)) + "\n");
                break;
        }
    }
    return text + "M30\nO2\n#101=#101+1\nM99\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table&) {});
    fuzz::Draw draw(data, size);
    const unsigned how = draw.byte();
    const bool nct = how & 1;
    const std::string text = program(draw);
    fuzz::play(
        text, *table, {nct ? Dialect::Nct : Dialect::Fanuc, (how & 2) != 0, how & 4 ? 7u : 0u},
        [&](auto& view, auto& sink, auto& port, auto& files) {
            return make_language(nct ? "nct" : "fanuc", view, sink, port, files);
        },
        [](Language&) {});
    return 0;
}
