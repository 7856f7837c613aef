#include "kernel/supervisor/press/signal_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

namespace polyturn::supervisor {

namespace {

bool same_word(std::string_view a, std::string_view b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
               return std::toupper(static_cast<unsigned char>(x)) ==
                      std::toupper(static_cast<unsigned char>(y));
           });
}

char letter_of(SignalScope scope) {
    switch (scope) {
        case SignalScope::Channel:
            return 'L';
        case SignalScope::Axis:
            return 'A';
        case SignalScope::Spindle:
            return 'S';
        case SignalScope::Global:
            break;
    }
    return 0;
}

std::uint32_t count_of(SignalScope scope) {
    switch (scope) {
        case SignalScope::Channel:
            return kMaxChannels;
        case SignalScope::Axis:
            return kMaxAxes;
        case SignalScope::Spindle:
            return kMaxSpindles;
        case SignalScope::Global:
            break;
    }
    return 1;
}

Diagnosis bad_word(Alarm alarm, std::string detail) {
    return Diagnosis{alarm, {}, {}, std::move(detail)};
}

bool is_called(const SignalRow& row, std::string_view name) {
    if (same_word(row.name, name)) return true;
    for (std::string_view rest = row.alias; !rest.empty();) {
        const std::string_view one = rest.substr(0, rest.find(' '));
        if (same_word(one, name)) return true;
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    }
    return false;
}

// Letters to change, add, leave out or swap.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    const auto same = [](char x, char y) {
        return std::toupper(static_cast<unsigned char>(x)) ==
               std::toupper(static_cast<unsigned char>(y));
    };
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {row[j - 1] + 1, last[j] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0u : 1u)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

std::string unknown(std::string_view words, std::string_view name) {
    std::string_view nearest;
    std::size_t least = 1 + name.size() / 2;  // what differs by more than half is no misspelling
    for (const SignalRow& row : signal_rows())
        if (const std::size_t d = distance(name, row.name); d < least) {
            least = d;
            nearest = row.name;
        }
    return nearest.empty() ? std::string(words) : fmt::format("{} (nearest: {})", words, nearest);
}

std::optional<std::uint32_t> whole_number(std::string_view digits) {
    std::uint32_t number = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (digits.empty() || end.ec != std::errc() || end.ptr != digits.data() + digits.size())
        return std::nullopt;
    return number;
}

// What may follow the name, to be shown when something else was found.
std::string possible(const SignalRow& row) {
    if (row.elements)
        return fmt::format("{0}[{1}] to {0}[{2}] are possible", row.name, row.first,
                           row.first + row.elements - 1);
    const char letter = letter_of(row.scope);
    if (!letter) return fmt::format("{} is one for the whole machine", row.name);
    return fmt::format("{0} {1}1 to {1}{2} are possible", row.name, letter, count_of(row.scope));
}

}  // namespace

std::string_view trimmed(std::string_view words) {
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.front())))
        words.remove_prefix(1);
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back())))
        words.remove_suffix(1);
    return words;
}

Result<SignalName> parse_signal(std::string_view words) {
    words = trimmed(words);
    const auto name_end = words.find_first_of(" \t[");
    const std::string_view name = words.substr(0, name_end);
    std::string_view scope =
        name_end == std::string_view::npos ? std::string_view() : trimmed(words.substr(name_end));
    const SignalRow* found = nullptr;
    for (const SignalRow& row : signal_rows())
        if (is_called(row, name)) found = &row;
    if (!found) return bad_word(Alarm::SignalUnknown, unknown(words, name));
    SignalName out{found, 1, 0};
    const char letter = letter_of(found->scope);
    const auto wrong = [&] {
        return bad_word(Alarm::SignalScope, fmt::format("{}: {}", words, possible(*found)));
    };
    if (scope.empty()) {
        if (letter)
            return bad_word(Alarm::SignalScope,
                            fmt::format("{} is one per instance: write {} {}1 and so on",
                                        found->name, found->name, letter));
        if (found->elements) return wrong();
        return out;
    }
    // In brackets: the element of an array, or the instance by its number alone.
    const bool brackets = scope.front() == '[';
    if (brackets) {
        if (scope.back() != ']') return wrong();
        scope = trimmed(scope.substr(1, scope.size() - 2));
        if (found->elements) {
            const auto index = whole_number(scope);
            if (!index || *index < found->first ||
                *index >= static_cast<std::uint32_t>(found->first) + found->elements)
                return wrong();
            out.element = *index - found->first;
            return out;
        }
    }
    if (!letter) return wrong();
    if (!scope.empty() && std::toupper(static_cast<unsigned char>(scope[0])) == letter)
        scope.remove_prefix(1);
    else if (!brackets)
        return wrong();
    const auto number = whole_number(scope);
    if (!number || *number < 1 || *number > count_of(found->scope)) return wrong();
    out.instance = *number;
    return out;
}

}  // namespace polyturn::supervisor
