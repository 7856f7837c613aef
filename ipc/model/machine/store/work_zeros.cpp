#include "ipc/model/machine/store/work_zeros.hpp"

#include <cctype>
#include <iterator>

namespace polyturn {
namespace {

constexpr std::size_t kExternal = 0, kFirst = 1, kShift = 7, kExtended = 10, kExtendedCount = 300,
                      kG53 = 311, kG500 = 312;
constexpr std::size_t kFixture[] = {313, 314, 315, 316, 317, 318, 319, 9};  // G54.2P1..G54.2P8
constexpr std::size_t kPlain = 6;                                           // G54..G59
static_assert(kFixture[6] < kWorkZeros);

// Digits only, up to four of them: more is no number that a zero offset has.
std::optional<std::size_t> number(std::string_view digits) {
    if (digits.empty() || digits.size() > 4) return {};
    std::size_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return {};
        value = value * 10 + static_cast<std::size_t>(c - '0');
    }
    return value;
}

}  // namespace

std::optional<std::size_t> settable_zero_row(std::size_t n) {
    if (n >= 1 && n <= kPlain) return kFirst + n - 1;
    if (n > kPlain && n <= kPlain + kExtendedCount) return kExtended + n - kPlain;
    return {};
}

std::optional<std::size_t> work_zero_row(std::string_view name) {
    std::string word;
    for (const char c : name)
        if (c != ' ') word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const std::string_view w = word;
    if (w == "EXTERNAL" || w == "EXT") return kExternal;
    if (w == "SHIFT") return kShift;
    if (w == "G53") return kG53;
    if (w == "G500") return kG500;
    if (w.starts_with("G54.1P")) {
        const auto p = number(w.substr(6));
        return p && *p >= 1 && *p <= kExtendedCount ? std::optional(kExtended + *p) : std::nullopt;
    }
    if (w.starts_with("G54.2P")) {
        const auto p = number(w.substr(6));
        return p && *p >= 1 && *p <= std::size(kFixture) ? std::optional(kFixture[*p - 1])
                                                         : std::nullopt;
    }
    if (w.starts_with("G159N")) {
        const auto n = number(w.substr(5));
        return n && *n <= 20 ? settable_zero_row(*n) : std::nullopt;
    }
    if (!w.starts_with("G")) return {};
    const auto g = number(w.substr(1));
    if (!g) return {};
    if (*g >= 54 && *g <= 59) return kFirst + *g - 54;
    if (*g >= 505 && *g <= 599) return settable_zero_row(*g - 500);
    return {};
}

std::string work_zero_name(std::size_t row) {
    if (row == kExternal) return "external";
    if (row == kShift) return "shift";
    if (row == kG53) return "G53";
    if (row == kG500) return "G500";
    if (row >= kFirst && row < kFirst + kPlain) return "G" + std::to_string(53 + row);
    if (row > kExtended && row <= kExtended + kExtendedCount)
        return "G54.1P" + std::to_string(row - kExtended);
    for (std::size_t p = 0; p < std::size(kFixture); ++p)
        if (row == kFixture[p]) return "G54.2P" + std::to_string(p + 1);
    return {};
}

}  // namespace polyturn
