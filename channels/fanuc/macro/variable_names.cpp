#include "channels/fanuc/macro/variable_names.hpp"

#include <algorithm>
#include <charconv>

namespace polyturn::channels::fanuc {
namespace {

std::string capitals(std::string_view name) {
    std::string out(name);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
    return out;
}

}  // namespace

void VariableNames::name(std::int64_t number, std::string_view name) {
    std::erase_if(numbers_, [&](const auto& one) { return one.second == number; });
    numbers_[capitals(name)] = number;
}

std::optional<std::int64_t> VariableNames::find(std::string_view name) const {
    const auto found = numbers_.find(capitals(name));
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::string_view VariableNames::of(std::int64_t number) const {
    for (const auto& [name, own] : numbers_)
        if (own == number) return name;
    return {};
}

std::string VariableNames::text() const {
    std::string out;
    for (const auto& [name, number] : numbers_) out += std::to_string(number) + " " + name + "\n";
    return out;
}

bool VariableNames::take(std::string_view text) {
    VariableNames read;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return false;
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end + 1);
        std::int64_t number = 0;
        const auto [at, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        const std::string_view name = line.substr(static_cast<std::size_t>(at - line.data()));
        if (error != std::errc{} || name.size() < 2 || name.size() > kLongest + 1 ||
            name[0] != ' ' || !begins(name[1]) ||
            !std::all_of(name.begin() + 1, name.end(), goes_on))
            return false;
        read.name(number, name.substr(1));
    }
    *this = std::move(read);
    return true;
}

}  // namespace polyturn::channels::fanuc
