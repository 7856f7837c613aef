#include "ipc/model/files/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ipc/model/files/toml_limits.hpp"

namespace polyturn::text {

namespace {
std::string_view kind_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a text";
        case toml::node_type::integer:
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

std::uint32_t length_of(const toml::node& node) {
    const auto& source = node.source();
    if (source.end.line != source.begin.line || source.end.column <= source.begin.column) return 1;
    return source.end.column - source.begin.column;
}
}  // namespace

std::optional<toml::table> TomlReader::parse(std::string_view content) {
    if (const auto beyond = beyond_toml_limits(content)) {
        diagnoses_->push_back({Alarm::TextTooDeep,
                               Place{std::string(filename_), beyond->line, beyond->column, 1},
                               {},
                               beyond->what});
        return std::nullopt;
    }
    try {
        return toml::parse(content, filename_);
    } catch (const toml::parse_error& error) {
        fault(Alarm::TextSyntax, error.source(), std::string(error.description()));
        return std::nullopt;
    }
}

void TomlReader::each(const toml::table& table, const Take& take) {
    struct Entry {
        const toml::key* key;
        const toml::node* node;
    };
    // the library sorts by name; diagnoses and stimuli come in the file's order
    std::vector<Entry> entries;
    for (const auto& [key, node] : table) entries.push_back({&key, &node});
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        const auto &left = a.key->source().begin, &right = b.key->source().begin;
        return left.line != right.line ? left.line < right.line : left.column < right.column;
    });
    for (const Entry& entry : entries) take(*entry.key, *entry.node);
}

const toml::table* TomlReader::table(const toml::key& key, const toml::node& node) {
    if (!node.is_table()) wrong(key, node, "a table { ... }");
    return node.as_table();
}

const toml::array* TomlReader::array(const toml::key& key, const toml::node& node) {
    if (!node.is_array()) wrong(key, node, "a list [ ... ]");
    return node.as_array();
}

std::optional<double> TomlReader::number(const toml::key& key, const toml::node& node) {
    std::optional<double> value;
    if (const auto* real = node.as_floating_point()) value = real->get();
    if (const auto* whole = node.as_integer()) value = static_cast<double>(whole->get());
    if (!value || !std::isfinite(*value)) {
        wrong(key, node, "a number");
        return std::nullopt;
    }
    return value;
}

std::optional<long> TomlReader::whole(const toml::key& key, const toml::node& node, long low,
                                      long high) {
    const auto value = number(key, node);
    if (!value) return std::nullopt;
    if (*value != std::floor(*value) || *value < static_cast<double>(low) ||
        *value > static_cast<double>(high)) {
        wrong(key, node, fmt::format("a whole number from {} to {}", low, high));
        return std::nullopt;
    }
    return static_cast<long>(*value);
}

std::optional<bool> TomlReader::flag(const toml::key& key, const toml::node& node) {
    if (const auto* value = node.as_boolean()) return value->get();
    if (const auto* value = node.as_integer(); value && (value->get() == 0 || value->get() == 1))
        return value->get() == 1;
    wrong(key, node, "true or false");
    return std::nullopt;
}

std::optional<std::string> TomlReader::text(const toml::key& key, const toml::node& node) {
    if (const auto* value = node.as_string()) return value->get();
    wrong(key, node, "a text in quotes");
    return std::nullopt;
}

std::optional<long> TomlReader::whole_key(const toml::key& key, long low, long high,
                                          std::string_view what) {
    const std::string_view name = key.str();
    long value = 0;
    bool good = !name.empty() && name.size() <= 9;
    for (const char c : name) {
        good = good && c >= '0' && c <= '9';
        if (good) value = value * 10 + (c - '0');
    }
    if (good && value >= low && value <= high) return value;
    fault(Alarm::UnknownKey, key.source(),
          fmt::format("{} (here stands {} from {} to {})", name, what, low, high),
          static_cast<std::uint32_t>(std::max<std::size_t>(1, name.size())));
    return std::nullopt;
}

void TomlReader::unknown(const toml::key& key, std::string_view known) {
    fault(Alarm::UnknownKey, key.source(), fmt::format("{} (here can stand: {})", key.str(), known),
          static_cast<std::uint32_t>(std::max<std::size_t>(1, key.str().size())));
}

void TomlReader::wrong(const toml::key& key, const toml::node& node, std::string_view wanted) {
    fault(Alarm::WrongType, node.source(),
          fmt::format("{} is {}, not {}", key.str(), kind_of(node), wanted), length_of(node));
}

void TomlReader::fault(Alarm alarm, const toml::source_region& where, std::string detail,
                       std::uint32_t length) {
    diagnoses_->push_back(Diagnosis{alarm, place(where, length), {}, std::move(detail)});
}

Place TomlReader::place(const toml::source_region& where, std::uint32_t length) const {
    return Place{std::string(filename_), where.begin.line, where.begin.column, length};
}

}  // namespace polyturn::text
