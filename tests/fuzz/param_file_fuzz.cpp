// libs: polyturn_params
//
// Whatever is read as a parameter file ends in assignments and diagnoses;
// what was accepted is written out and read in again. The tables are made once: each run puts back
// the rows that it touched, so that a run costs what its text costs.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/params/row_default.hpp"

namespace {

using namespace polyturn::params;

bool same_row(const Row& row, const Table& a, const Table& b) {
    for (std::size_t i = row.first_slot;
         i < row.first_slot + std::size_t{instances(row.scope)} * row.array; ++i)
        if (row.type == Type::Text ? text_at(a, i) != text_at(b, i) : a.numbers[i] != b.numbers[i])
            return false;
    return true;
}

std::unique_ptr<Table> fresh() {
    auto table = std::make_unique<Table>();
    set_defaults(*table);
    return table;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::unique_ptr<Table> table = fresh(), again = fresh(), untouched = fresh();
    static unsigned runs = 0;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedFile file = parse_param_file(text, "fuzz");
    for (const auto& diagnosis : file.diagnoses) {
        if (diagnosis.text().empty() || diagnosis.remedy().empty()) std::abort();
        (void)polyturn::render(diagnosis, polyturn::Dialect::Polyturn, text.substr(0, 200));
    }
    if (file.assignments.empty()) return 0;
    // parsed means valid
    if (!polyturn::params::apply(*table, file.assignments).ok()) std::abort();
    std::set<const Row*> touched;
    for (const Assignment& one : file.assignments) touched.insert(one.row);
    std::string lines;
    for (const Row* row : touched) lines += export_row(*row, *table, Content::Changed);
    if (!lines.empty() && !apply(*again, parse_param_file(lines, "export")).ok()) std::abort();
    for (const Row* row : touched)
        if (!same_row(*row, *table, *again)) std::abort();
    const bool whole = ++runs % 4096 == 0;  // now and then: nothing else was touched
    if (whole && !same(*table, *again)) std::abort();
    for (const Row* row : touched) {
        set_default(*table, *row);
        set_default(*again, *row);
    }
    if (whole && !same(*table, *untouched)) std::abort();
    return 0;
}
