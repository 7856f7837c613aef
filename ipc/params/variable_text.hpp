// How a macro variable is listed (nct_parameters_part2 18.5 PRC, 18.8): 15 significant digits, or
// rounded to N1761 digits behind the point. Programs in other languages: 12 significant digits.
#pragma once
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::params {

std::string variable_text(double value, const Table& table, unsigned channel, Dialect language);

}  // namespace polyturn::params
