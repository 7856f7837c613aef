#include "ipc/params/registry.hpp"

#include <algorithm>
#include <array>

#include "ipc/params/row_table.hpp"

namespace polyturn::params {
namespace {

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

constexpr std::size_t kLongest = 48;  // longer names are nobody's; bounds the work on rubbish

// Letters changed, added, dropped or swapped with the neighbour to get from one text to the other;
// `limit` or more once it is clear that it will not be less. Both texts at most kLongest long.
std::size_t edit_distance(std::string_view from, std::string_view to, std::size_t limit) {
    std::array<std::size_t, kLongest + 1> before{}, above{}, now{};
    for (std::size_t j = 0; j <= to.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        now[0] = i;
        std::size_t least = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t change = above[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            now[j] = std::min({change, above[j] + 1, now[j - 1] + 1});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
            least = std::min(least, now[j]);
        }
        if (least > limit) return least;  // a swap still reaches back one line, hence not >=
        before = above;
        above = now;
    }
    return above[to.size()];
}

// N, F, MD, PT, FG: what precedes the first digit, point or underscore.
std::string_view family(std::string_view number) {
    return number.substr(0, number.find_first_of("0123456789._"));
}

// A name that begins as those of one family do is a slip within it; any other may be a slip in the
// letters.
bool is_family(std::string_view letters) {
    constexpr std::string_view kFamilies[] = {"N", "F", "MD", "SD", "PT", "FG", "MEFI"};
    return std::find(std::begin(kFamilies), std::end(kFamilies), letters) != std::end(kFamilies);
}

std::string without_leading_zeros(std::string_view number) {
    const std::size_t letters = family(number).size();
    const std::size_t digits = std::min(number.find_first_not_of('0', letters), number.size());
    std::string out(number.substr(0, letters));
    return out.append(number.substr(digits));
}

}  // namespace

std::string Row::title() const { return std::string(number) + ' ' + std::string(name); }

std::span<const Row> rows() noexcept { return detail::kRows; }

namespace {

// What other controls call a value that exists here already. Lengths per minute in all of them.
struct OtherName {
    std::string_view name, number;
};
constexpr OtherName kOtherNames[] = {
    {"FG.MAXFEED", "N0305"},
    {"FG.G00FEED", "N0304"},  // fagor_8037t part 1, 9.3
    {"MD32000", "N0304"},
    {"MD36200", "N0304"},  // sinumerik part 1, 11.1
};

}  // namespace

const Row* find(std::string_view number) noexcept {
    if (number.size() > kLongest) return nullptr;
    char key[kLongest];
    std::transform(number.begin(), number.end(), key, [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    const std::string_view wanted(key, number.size());
    const auto order = detail::kByNumber;
    const auto found = std::lower_bound(
        order.begin(), order.end(), wanted,
        [](std::uint16_t row, std::string_view text) { return rows()[row].number < text; });
    if (found == order.end() || rows()[*found].number != wanted) {
        for (const OtherName& other : kOtherNames)
            if (other.name == wanted) return find(other.number);
        return nullptr;
    }
    return &rows()[*found];
}

std::vector<std::string_view> nearest(std::string_view number, std::size_t count) {
    const std::string wanted = upper(number.substr(0, kLongest));
    const std::string wanted_short = without_leading_zeros(wanted);
    struct Candidate {
        std::size_t distance;
        std::string_view number;
    };
    if (count == 0) return {};
    std::vector<Candidate> best;  // ascending, of equals the earlier row first
    // more than half of the letters wrong: no resemblance worth showing
    const std::size_t far = wanted.size() + 1;
    const bool one_family = is_family(family(wanted));
    for (const Row& row : rows()) {
        if (one_family && family(row.number) != family(wanted)) continue;
        const std::size_t limit = best.size() < count ? far : best.back().distance;
        const std::size_t lengths =
            std::max(wanted.size(), row.number.size()) - std::min(wanted.size(), row.number.size());
        // the commonest slip: N304 for N0304
        const bool zeros = wanted_short == without_leading_zeros(row.number);
        if (!zeros && 2 * lengths >= limit) continue;
        const std::size_t distance = zeros ? 0 : 2 * edit_distance(wanted, row.number, limit / 2);
        if (distance >= limit) continue;
        const auto place = std::upper_bound(
            best.begin(), best.end(), distance,
            [](std::size_t value, const Candidate& one) { return value < one.distance; });
        best.insert(place, {distance, row.number});
        if (best.size() > count) best.pop_back();
    }
    std::vector<std::string_view> out;
    for (const Candidate& candidate : best) out.push_back(candidate.number);
    return out;
}

}  // namespace polyturn::params
