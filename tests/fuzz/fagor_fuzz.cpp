// libs: polyturn_channels
//
// Any text as a fagor program; the first byte chooses live values and how
// often the reader goes back.
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table& t) {
        params::put(t, params::fg_m19type, 1, 1);
        params::put(t, params::fg_angaxna, 1, 1);
        params::put(t, params::fg_ortaxna, 3, 1);
        params::put(t, params::fg_angantr, 30, 1);
    });
    if (size == 0) return 0;
    fuzz::play(fuzz::behind_first(data, size), *table,
               {Dialect::Fagor, (data[0] & 1) != 0, data[0] / 2u}, make_fagor, [](Language&) {});
    return 0;
}
