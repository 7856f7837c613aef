// libs: polyturn_channels
//
// Any text as a fanuc, nct or mefi program; the first byte chooses language, live values and steps
// back.
#include "tests/fuzz/play_text.hpp"

using namespace polyturn;
using namespace polyturn::channels;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto table = fuzz::lathe([](params::Table& t) {
        params::put(t, params::n2201_waiting_m_codes_min, 500);
        params::put(t, params::n2202_waiting_m_codes_max, 599);
    });
    if (size == 0) return 0;
    const unsigned choice = data[0] % 3;
    const char* const name = choice == 0 ? "fanuc" : choice == 1 ? "nct" : "mefi";
    fuzz::play(
        fuzz::behind_first(data, size), *table,
        {dialect_of(name), (data[0] & 64) != 0, data[0] & 128 ? 7u : 0u},
        [&](auto& view, auto& sink, auto& port, auto& files) {
            return make_language(name, view, sink, port, files);
        },
        [](Language&) {});
    return 0;
}
