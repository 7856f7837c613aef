// Names of common variables that a program gives with SETVN, the field's standard where fanuc_lathe
// is silent:
//
//   SETVN 510[TOOL_NO,COUNT]      #510 is TOOL_NO, #511 is COUNT
//   [#COUNT]=[#COUNT]+1           the same as #511=#511+1
//
// A name belongs to one variable and a variable has one name: what is given later holds.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace polyturn::channels::fanuc {

inline constexpr std::string_view kNamesKept = "variable_names";  // Port::keep

class VariableNames {
public:
    static constexpr std::size_t kLongest = 8;

    static bool begins(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
    static bool goes_on(char c) { return begins(c) || (c >= '0' && c <= '9') || c == '_'; }

    void name(std::int64_t number, std::string_view name);
    std::optional<std::int64_t> find(std::string_view name) const;
    std::string_view of(std::int64_t number) const;  // empty: it has none
    std::string text() const;          // "510 TOOL_NO\n511 COUNT\n": survives power-off
    bool take(std::string_view text);  // false: it is no such text, nothing is taken

private:
    std::map<std::string, std::int64_t, std::less<>> numbers_;  // by name in capitals
};

}  // namespace polyturn::channels::fanuc
