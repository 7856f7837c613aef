// Parameter lines: what `--set`, `--param-file`, machine.params, import and export read and write
// (cli.md 1).
//
//   NAME[#BIT][[ELEMENT]] [SCOPE]=VALUE   ; comment
//
//   N1300 L1=5             the channel parameter N1300 of channel 1
//   N1414#2=1              bit 2, in every channel: without a scope a line means every instance
//   F5002=00000010         eight binary digits: the bits #7 to #0
//   MD20150[5]=2           element 5 of an indexed parameter
//   N0003 L1="Upper; left" a text; quotes only where it holds ; or " or begins or ends with a blank
//
// Names and scope letters may be written small. A line is checked whole: name, bit, element, scope,
// index, type and range. An Assignment is therefore always valid, and what is wrong is a Diagnosis
// with its column.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::params {

// Which value of a parameter is meant.
struct Target {
    static constexpr unsigned kEveryInstance = 0;
    static constexpr int kWhole = -1;  // not one bit, but the value
    static constexpr int kEveryElement = -1;

    const Row* row = nullptr;
    unsigned instance = kEveryInstance;  // from 1
    int bit = kWhole;                    // 0..7
    int element = kEveryElement;         // from 0
    // FG.DFORMAT X: the axes of that name instead of an instance
    char axis = 0;
};

struct Assignment : Target {
    double number = 0.0;  // numbers and bits
    std::string text;     // Type::Text
    Place place;          // where it was written
};

// One line such as the argument of --set; a comment behind it is allowed. A line without an
// assignment is an error.
[[nodiscard]] Result<Assignment> parse_assignment(std::string_view line);

// "N1600 L1", "N1414#2 L1", "PT_HORIZON": the argument of `params get`.
[[nodiscard]] Result<Target> parse_target(std::string_view text);

struct ParsedFile {
    std::vector<Assignment> assignments;  // in the file's order; a later one wins
    // every bad line; at the most kMostDiagnoses, then one that says so
    std::vector<Diagnosis> diagnoses;
    [[nodiscard]] bool ok() const noexcept;  // no error among the diagnoses
};
inline constexpr std::size_t kMostDiagnoses = 200;  // more than that is another kind of file

// A whole file: LF, CRLF or CR, with or without a UTF-8 byte order mark. `filename` goes into the
// places.
[[nodiscard]] ParsedFile parse_param_file(std::string_view text, std::string_view filename);

// Writes all of them or, when one is not valid, none. Call it as params::apply: unqualified, with a
// std::vector, the compiler would take std::apply.
[[nodiscard]] Result<void> apply(Table& table, std::span<const Assignment> assignments);
// Also refuses a file with errors, with the first of them.
[[nodiscard]] Result<void> apply(Table& table, const ParsedFile& file);

}  // namespace polyturn::params
