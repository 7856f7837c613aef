// The way back: a table as parameter lines that read in again to the same table, and the difference
// of two tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ipc/params/param_file.hpp"

namespace polyturn::params {

enum class Content : std::uint8_t {
    Changed,  // only what differs from the default: what a machine file holds
    All,      // every value; rows whose instances are all alike in one line
};

// Lines with the group's name above and name and unit behind, as comments.
[[nodiscard]] std::string export_lines(const Table& table, Content content);
// The lines of one row, without its group.
[[nodiscard]] std::string export_row(const Row& row, const Table& table, Content content);

// One value as a parameter line has it: shortest digits that read back exactly, texts quoted where
// needed.
[[nodiscard]] std::string value_text(const Row& row, const Table& table, unsigned instance,
                                     unsigned element = 0);
// What `params get` prints last; for a target that names several values they must be alike, else
// one line each.
[[nodiscard]] std::string value_text(const Table& table, const Target& target);
// "N1300 L1", "MD20150[5]": the left side of a line.
[[nodiscard]] std::string target_text(const Target& target);

struct Difference {
    const Row* row;
    unsigned instance;  // from 1
    unsigned element;   // from 0
    std::string before, after;
    std::string_view unit;
};
[[nodiscard]] std::vector<Difference> difference(const Table& before, const Table& after);
// "N0304 A3: 10000 -> 12000 mm/min   (Rapid)"
[[nodiscard]] std::string to_string(const Difference& difference);

}  // namespace polyturn::params
