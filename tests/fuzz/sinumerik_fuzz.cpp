// libs: polyturn_channels
//
// Any text as a sinumerik program with one tool; the first byte says how
// often the reader goes back.
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table&) {});
    if (size == 0) return 0;
    fuzz::play(fuzz::behind_first(data, size), *table, {Dialect::Sinumerik, true, data[0]},
               make_sinumerik, [](Language& language) {
                   language.preset_tool(1, "A");
                   language.preset_edge(1, 1, "DP1", 500);
                   language.preset_edge(1, 1, "DP6", 0.8);
               });
    return 0;
}
