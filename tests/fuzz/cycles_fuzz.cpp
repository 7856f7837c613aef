// libs: polyturn_channels
//
// The repetitive cycles over contours that nobody would draw: profiles that
// never retract, arcs that do not fit, zero depths, equal ends. Each ends after a bounded number of
// moves or is refused with an alarm.
#include "tests/fuzz/draw.hpp"
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

namespace {

std::string contour(fuzz::Draw& draw) {
    std::string text = "N1 G0" + draw.word('X') + (draw.below(2) ? draw.word('Z') : "") + "\n";
    const unsigned blocks = 1 + draw.below(8);
    for (unsigned k = 0; k < blocks; ++k) {
        const unsigned motion = draw.below(8) == 0 ? 0 : 1 + draw.below(3);
        text += "G" + std::to_string(motion) +
                (draw.below(4) ? draw.word(draw.below(2) ? 'X' : 'U') : "") +
                (draw.below(4) ? draw.word(draw.below(2) ? 'Z' : 'W') : "");
        if (motion >= 2) text += draw.below(2) ? draw.word('R') : draw.word('I') + draw.word('K');
        text += "\n";
    }
    return text + "N2 G1" + draw.word('X') + "\n";
}

std::string program(fuzz::Draw& draw, bool nct) {
    std::string text = "O1\nG97 S500 M3\nF0.2\nG0 X62. Z3.\n";
    for (int cycle = 0; cycle < 3 && !draw.empty(); ++cycle) {
        switch (draw.below(8)) {
            case 0:
                text += "G71" + draw.word('U') + draw.word('R') + "\nG71 P1 Q2" + draw.word('U') +
                        draw.word('W') + "\n" + contour(draw) +
                        (draw.below(2) ? "G70 P1 Q2\n" : "");
                break;
            case 1:
                text += "G72" + draw.word('W') + draw.word('R') + "\nG72 P1 Q2" + draw.word('U') +
                        draw.word('W') + "\n" + contour(draw);
                break;
            case 2:
                text += "G73" + draw.word('U') + draw.word('W') + "R" +
                        std::to_string(draw.byte()) + "\nG73 P1 Q2" + draw.word('U') +
                        draw.word('W') + "\n" + contour(draw);
                break;
            case 3:
                text += "G74" + draw.word('R') + "\nG74" + draw.word('X') + draw.word('Z') + "P" +
                        std::to_string(draw.byte() * 16) + "Q" + std::to_string(draw.byte() * 16) +
                        "\n";
                break;
            case 4:
                text += "G75" + draw.word('R') + "\nG75" + draw.word('X') + draw.word('Z') + "P" +
                        std::to_string(draw.byte() * 16) + "Q" + std::to_string(draw.byte() * 16) +
                        "\n";
                break;
            case 5:
                text += "G76 P" + std::to_string(draw.byte() * 3900) + " Q" +
                        std::to_string(draw.byte()) + draw.word('R') + "\nG76" + draw.word('X') +
                        draw.word('Z') + draw.word('R') + "P" + std::to_string(draw.byte() * 16) +
                        "Q" + std::to_string(draw.byte() * 16) + draw.word('F') + "\n";
                break;
            case 6:
                text += std::string(nct ? "G77" : "G90") + draw.word('X') + draw.word('Z') +
                        draw.word('R') + "\n";
                break;
            default:
                text += "G83" + draw.word('Z') + draw.word('R') + "Q" +
                        std::to_string(draw.byte() * 8) + (draw.below(2) ? " K3" : "") + "\nG80\n";
                break;
        }
    }
    return text + "M30\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table& t) {
        params::put(t, params::n1604_numb_of_div, 3, 1);
        params::put(t, params::n1600_depth_of_cut, 1, 1);
    });
    fuzz::Draw draw(data, size);
    const unsigned how = draw.byte();
    const bool nct = how & 1;
    const std::string text = (how & 2 ? "T0101\nG42\n" : "") + program(draw, nct);
    fuzz::play(
        text, *table, {nct ? Dialect::Nct : Dialect::Fanuc, false, 0},
        [&](auto& view, auto& sink, auto& port, auto& files) {
            return make_language(nct ? "nct" : "fanuc", view, sink, port, files);
        },
        [](Language&) {});
    return 0;
}
