// What is stored but acts on nothing, and is set all the same: one warning for each, so that nobody
// relies on it. A row says in its column `acts` why it does not; single bits of rows that act are
// listed here, and their text says so too. Addresses of hardware say where a drive would be, which
// the drive interface answers (N0500 and on); they stand in every machine's file and are no
// mistake.
#include <array>
#include <string_view>

#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

constexpr std::string_view kHardware = "never: hardware is reached through the drive interface";

bool holds_default(const Row& row, const Table& table, unsigned instance) {
    for (unsigned element = 0; element < row.array; ++element)
        if (table.numbers[row.first_slot + (instance - 1) * row.array + element] !=
            row.default_number(element))
            return false;
    return true;
}

template <class HandleType>
void check_bits(Report& report, HandleType handle, unsigned instances,
                std::initializer_list<unsigned> bits, std::string_view names) {
    for (unsigned l = 1; l <= instances; ++l)
        for (const unsigned number : bits)
            if (bit(report.table, handle, l, number)) {
                report.add(Alarm::ParamWithoutEffect,
                           report.line(handle, l) + ": " + std::string(names));
                break;
            }
}

}  // namespace

void check_effects(Report& report) {
    for (const Row& row : rows()) {
        if (row.acts == "yes" || row.acts.empty() || row.acts == kHardware ||
            row.type == Type::Text)
            continue;
        const char letter = scope_letter(row.scope);
        const unsigned instances = params::instances(row.scope);
        for (unsigned n = 1; n <= instances; ++n)
            if (!holds_default(row, report.table, n)) {
                report.add(
                    Alarm::ParamWithoutEffect,
                    std::string(row.number) +
                        (letter ? std::string(" ") + letter + std::to_string(n) : std::string()) +
                        "=" + value_text(row, report.table, n));
                break;  // one of them tells
            }
    }
    check_bits(report, f1008, kMaxAxes, {2}, "#2");
    check_bits(report, n1402_tool_meas, kMaxChannels, {1, 2}, "#1, #2");
    check_bits(report, n1755_macro_contr, kMaxChannels, {4}, "#4");
    check_bits(report, n1758_intrrt_contr, kMaxChannels, {5}, "#5");
    check_bits(report, n1800_egb_contr, kMaxChannels, {2}, "#2");
}

}  // namespace polyturn::config
