// Listed macro variables (nct_parameters_part2 18.5, 18.8).
#include "ipc/params/variable_text.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "ipc/params/registry.hpp"

namespace polyturn::params {
namespace {

TEST(VariableText, HasTheDigitsThatTheNctParametersSay) {
    const auto table = std::make_unique<Table>();
    set_defaults(*table);
    // PRC 0: 15 digits
    EXPECT_EQ(variable_text(1.0 / 3, *table, 2, Dialect::Nct), "0.333333333333333");
    EXPECT_EQ(variable_text(12345678.9, *table, 2, Dialect::Nct), "12345678.9");
    // PRC 1: N1761, 6 behind the point
    put(*table, n1755_macro_contr, 8, 2);
    EXPECT_EQ(variable_text(2.0 / 3, *table, 2, Dialect::Nct), "0.666667");
    EXPECT_EQ(variable_text(-1e-9, *table, 2, Dialect::Nct), "0.000000");
    put(*table, n1761_precision_setting, 2, 2);
    EXPECT_EQ(variable_text(2.346, *table, 2, Dialect::Nct), "2.35");
    EXPECT_EQ(variable_text(-7, *table, 2, Dialect::Nct), "-7.00");
    put(*table, n1761_precision_setting, 0, 2);
    EXPECT_EQ(variable_text(2.6, *table, 2, Dialect::Nct), "3");
    // Fanuc has no such setting
    EXPECT_EQ(variable_text(2.0 / 3, *table, 2, Dialect::Fanuc), "0.666666666667");
}

}  // namespace
}  // namespace polyturn::params
