// libs: polyturn_text
// Whatever is read as a setup ends in values and in diagnoses that say where and what to do.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "ipc/model/files/setup.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<polyturn::Diagnosis> diagnoses;
    (void)polyturn::text::parse_setup(text, "fuzz.toml", diagnoses);
    for (const auto& diagnosis : diagnoses) {
        if (diagnosis.text().empty() || diagnosis.remedy().empty()) std::abort();
        (void)polyturn::render(diagnosis, polyturn::Dialect::Polyturn, text.substr(0, 200));
    }
    return 0;
}
