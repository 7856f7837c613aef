#include "ipc/params/variable_text.hpp"

#include <fmt/format.h>

namespace polyturn::params {

std::string variable_text(double value, const Table& table, unsigned channel, Dialect language) {
    if (language != Dialect::Nct) return fmt::format("{:.12g}", value);
    if (!bit(table, n1755_macro_contr, channel, 3)) return fmt::format("{:.15g}", value);
    std::string text = fmt::format("{:.{}f}", value, get(table, n1761_precision_setting, channel));
    // rounded to nothing
    if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);
    return text;
}

}  // namespace polyturn::params
