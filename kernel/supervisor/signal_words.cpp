#include "kernel/supervisor/signal_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace polyturn::supervisor {

namespace {

bool same_word(std::string_view a, std::string_view b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
               return std::toupper(static_cast<unsigned char>(x)) == std::toupper(static_cast<unsigned char>(y));
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

Diagnosis fault(Alarm alarm, std::string detail) { return Diagnosis{alarm, {}, {}, std::move(detail)}; }

}  // namespace

std::string_view trimmed(std::string_view words) {
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.front()))) words.remove_prefix(1);
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.remove_suffix(1);
    return words;
}

Result<SignalName> parse_signal(std::string_view words) {
    words = trimmed(words);
    const auto space = words.find_first_of(" \t");
    const std::string_view name = words.substr(0, space);
    const std::string_view scope = space == std::string_view::npos ? std::string_view() : trimmed(words.substr(space));
    const SignalRow* found = nullptr;
    for (const SignalRow& row : signal_rows())
        if (same_word(row.name, name)) found = &row;
    if (!found) return fault(Alarm::SignalUnknown, std::string(words));
    SignalName out{found, 1};
    const char letter = letter_of(found->scope);
    if (scope.empty()) {
        if (letter) return fault(Alarm::SignalScope, fmt::format("{} is one per instance: write {} {}1 and so on", found->name, found->name, letter));
        return out;
    }
    std::uint32_t number = 0;
    bool good = letter && scope.size() >= 2 && scope.size() <= 4 && std::toupper(static_cast<unsigned char>(scope[0])) == letter;
    for (const char c : scope.substr(good ? 1 : 0)) {
        if (!good || c < '0' || c > '9')
            good = false;
        else
            number = number * 10 + static_cast<std::uint32_t>(c - '0');
    }
    if (!good || number < 1 || number > count_of(found->scope))
        return fault(Alarm::SignalScope, letter ? fmt::format("{} of {}: {}1 to {}{} are possible", scope, found->name, letter, letter, count_of(found->scope))
                                                : fmt::format("{} is one for the whole machine", found->name));
    out.instance = number;
    return out;
}

}  // namespace polyturn::supervisor
