// libs: polyturn_channels
//
// Contours of lines and arcs with nose-radius compensation that begins,
// changes its side and radius, is suspended and ends anywhere: each ends or is refused with an
// alarm, and what is driven is finite.
#include "tests/fuzz/draw.hpp"
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

namespace {

std::string program(fuzz::Draw& draw) {
    static constexpr const char* kOther[] = {
        "M8",          "G4 P10",        "U0",       "#1=#1+1",     "T0101",
        "G10 P1 R0.2", "G28 U0",        "G53 X50.", "G50 X40. Z0", "G99",
        "M0",          "G90 X10. Z-5.", ",C1.",     "G33 Z-5. F1."};
    std::string text = "O1\nG98 F200\nT0101\n";
    for (int block = 0; block < 40 && !draw.empty(); ++block) {
        const unsigned what = draw.below(16);
        if (what == 15) {
            text += std::string(kOther[draw.below(std::size(kOther))]) + "\n";
            continue;
        }
        if (draw.below(3) == 0) {
            static constexpr const char* kSides[] = {"G41 ", "G42 ", "G40 "};
            text += kSides[draw.below(3)];
        }
        const unsigned motion = draw.below(4);
        text += "G" + std::to_string(motion) + draw.word(draw.below(2) ? 'X' : 'U') +
                draw.word(draw.below(2) ? 'Z' : 'W');
        if (motion >= 2)
            text += draw.below(2) ? draw.word('R') : draw.word('I') + draw.word('K');
        else if (draw.below(8) == 0)
            text += std::string(draw.below(2) ? ",R" : ",C") + draw.number(draw.length());
        else if (draw.below(8) == 0)
            text += draw.word('I') + draw.word('K');
        text += "\n";
    }
    return text + "M30\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table&) {});
    fuzz::Draw draw(data, size);
    const unsigned how = draw.byte();
    const bool nct = how & 1;
    const std::string text = program(draw);
    fuzz::play(
        text, *table, {nct ? Dialect::Nct : Dialect::Fanuc, false, how & 2 ? 5u : 0u},
        [&](auto& view, auto& sink, auto& port, auto& files) {
            view.store->offsets[1].tip = (how >> 4) % 10;
            return make_language(nct ? "nct" : "fanuc", view, sink, port, files);
        },
        [](Language&) {});
    return 0;
}
