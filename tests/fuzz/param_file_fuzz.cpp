// libs: polyturn_params
// Whatever is read as a parameter file ends in assignments and diagnoses; what was accepted is written out and read in again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace polyturn::params;
    static Table table, again;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedFile file = parse_param_file(text, "fuzz");
    for (const auto& diagnosis : file.diagnoses) {
        if (diagnosis.text().empty() || diagnosis.remedy().empty()) std::abort();
        (void)polyturn::render(diagnosis, polyturn::Dialect::Polyturn, text.substr(0, 200));
    }
    if (file.assignments.empty()) return 0;
    set_defaults(table);
    set_defaults(again);
    if (!polyturn::params::apply(table, file.assignments).ok()) std::abort();  // parsed means valid
    const ParsedFile back = parse_param_file(export_lines(table, Content::Changed), "export");
    if (!apply(again, back).ok() || !same(table, again)) std::abort();
    return 0;
}
