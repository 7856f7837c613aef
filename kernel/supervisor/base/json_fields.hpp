// A field of JSON that somebody else has written: its value when it is there and of the kind that
// is wanted, the other one otherwise. nlohmann's value() ends the program when the kind is another.
#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace polyturn::supervisor {

inline std::string text_field(const nlohmann::json& from, const char* key,
                              const char* otherwise = "") {
    if (!from.is_object()) return otherwise;
    const auto found = from.find(key);
    return found != from.end() && found->is_string() ? found->get<std::string>()
                                                     : std::string(otherwise);
}

// A number from 0 that fits.
inline unsigned count_field(const nlohmann::json& from, const char* key, unsigned otherwise = 0) {
    if (!from.is_object()) return otherwise;
    const auto found = from.find(key);
    if (found == from.end() || !found->is_number()) return otherwise;
    const double value = found->get<double>();
    return value >= 0 && value <= 4e9 ? static_cast<unsigned>(value) : otherwise;
}

// A text, or a number as it is written.
inline std::string word_field(const nlohmann::json& from, const char* key) {
    if (!from.is_object()) return {};
    const auto found = from.find(key);
    if (found == from.end()) return {};
    return found->is_string()   ? found->get<std::string>()
           : found->is_number() ? found->dump()
                                : std::string();
}

}  // namespace polyturn::supervisor
