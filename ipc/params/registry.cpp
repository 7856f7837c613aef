#include "ipc/params/registry.hpp"

#include <algorithm>

#include "ipc/params/row_table.hpp"

namespace polyturn::params {
namespace {

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

// Letters changed, added, dropped or swapped with the neighbour to get from one text to the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> before, above(to.size() + 1), now(to.size() + 1);
    for (std::size_t j = 0; j <= to.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t change = above[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            now[j] = std::min({change, above[j] + 1, now[j - 1] + 1});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = above;
        std::swap(above, now);
    }
    return above[to.size()];
}

// N, F, MD, PT, FG: what stands before the first digit, point or underscore.
std::string_view family(std::string_view number) { return number.substr(0, number.find_first_of("0123456789._")); }

std::string without_leading_zeros(std::string_view number) {
    const std::size_t letters = family(number).size();
    const std::size_t digits = number.find_first_not_of('0', letters);
    return std::string(number.substr(0, letters)) + std::string(number.substr(std::min(digits, number.size())));
}

}  // namespace

std::string Row::title() const { return std::string(number) + ' ' + std::string(name); }

std::span<const Row> rows() noexcept { return detail::kRows; }

const Row* find(std::string_view number) noexcept {
    constexpr std::size_t kLongest = 48;
    if (number.size() > kLongest) return nullptr;
    char key[kLongest];
    std::transform(number.begin(), number.end(), key,
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    const std::string_view wanted(key, number.size());
    const auto order = detail::kByNumber;
    const auto found = std::lower_bound(order.begin(), order.end(), wanted,
                                        [](std::uint16_t row, std::string_view text) { return rows()[row].number < text; });
    if (found == order.end() || rows()[*found].number != wanted) return nullptr;
    return &rows()[*found];
}

std::vector<std::string_view> nearest(std::string_view number, std::size_t count) {
    const std::string wanted = upper(number.substr(0, 48));
    struct Candidate {
        std::size_t distance;
        std::string_view number;
    };
    std::vector<Candidate> candidates;
    for (const Row& row : rows()) {
        // Leading zeros left out are the commonest slip (N304 for N0304): no distance at all. Another family is far.
        std::size_t distance = 2 * edit_distance(wanted, row.number);
        if (without_leading_zeros(wanted) == without_leading_zeros(row.number)) distance = 0;
        if (family(wanted) != family(row.number)) ++distance;
        candidates.push_back({distance, row.number});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<std::string_view> out;
    const std::size_t far = wanted.size() + 1;   // more than half of the letters wrong: no resemblance worth showing
    for (const Candidate& candidate : candidates)
        if (out.size() < count && candidate.distance < far) out.push_back(candidate.number);
    return out;
}

}  // namespace polyturn::params
