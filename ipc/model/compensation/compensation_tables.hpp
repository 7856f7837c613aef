// Measured errors of a machine: the cells of pitch and straightness tables and the points of
// volumetric ones, kept beside the machine's parameters (nct_parameters_part2 26 to 28):
// machine.compensation beside machine.params.
//
//   10500=0.0012            cell 10500, in the unit of the compensated axis; `;` begins a comment
//   3D L1 17=0.001 0 -0.002 point 17 of channel 1's grid: corrections of its first, second and
//   third axis; the first axis of
//                           the grid counts fastest, points from 0
//
// A machine without this file has not been measured yet: every cell is 0. In a file that is there,
// each cell that a table uses must have its value.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/capacities.hpp"
#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"

namespace polyturn {

inline constexpr std::int64_t kFirstCell = 10000, kLastCell = 29999;
inline constexpr std::int64_t kMostGridPoints = 1'000'000;

struct CompensationTables {
    bool measured = false;  // there was a file
    // by cell less kFirstCell; NaN: not given
    std::vector<float> cells;
    std::array<std::vector<std::array<float, 3>>, kMaxChannels> points;  // NaN: not given

    // 0 where nothing is given.
    double cell(std::int64_t number) const {
        if (number < kFirstCell || number > kLastCell || cells.empty()) return 0.0;
        const double value =
            static_cast<double>(cells[static_cast<std::size_t>(number - kFirstCell)]);
        return value == value ? value : 0.0;
    }
};

// The grid of a channel as its parameters lay it out (nct_parameters_part2 28). An axis that it
// does not have counts one point.
struct CompensationGrid {
    std::array<unsigned, 3> axis{};  // from 1; 0: none
    std::array<std::int64_t, 3> count{1, 1, 1}, zero{};
    std::array<double, 3> interval{1, 1, 1};

    bool described() const { return axis[0] || axis[1] || axis[2]; }
    // As the file counts them; 0: there is none, or so many that no file holds them.
    std::int64_t points() const;
    std::int64_t number(const std::array<std::int64_t, 3>& place) const {
        return place[0] + count[0] * (place[1] + count[1] * place[2]);
    }
};
CompensationGrid compensation_grid(const params::Table& table, unsigned channel);

// "…/machine.params" gives "…/machine.compensation".
std::string compensation_file_of(std::string_view params_file);
CompensationTables parse_compensation(std::string_view content, std::string_view filename,
                                      std::vector<Diagnosis>& diagnoses);
// What a line of the file is about: a cell, or a point of a channel's grid; both 0: neither. Its
// values are not looked at.
struct CompensationLine {
    std::int64_t cell = 0;
    unsigned channel = 0;
    std::int64_t point = 0;
};
CompensationLine compensation_line(std::string_view line);
// No file: not measured, no diagnosis.
CompensationTables load_compensation(const std::string& path, std::vector<Diagnosis>& diagnoses);
// What the parameters use of a measured machine: gaps, and cyclic tables that would not close.
void check_compensation_tables(const params::Table& table, const CompensationTables& tables,
                               std::string_view filename, std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn
