// Out and in again is the same table, whatever was set.
#include "ipc/params/export.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "ipc/params/unit.hpp"
#include "tests/property.hpp"

namespace polyturn::params {
namespace {

std::unique_ptr<Table> fresh() {
    auto table = std::make_unique<Table>();
    set_defaults(*table);
    return table;
}

// A value that the row allows, with a liking for the limits and for digits that only just fit a
// double.
double some_number(const Row& row) {
    const auto fraction = static_cast<double>(*rc::gen::inRange(0, 1'000'001)) / 1e6;
    const double low = std::max(row.min, -1e12), high = std::min(row.max, 1e12);
    double value = *rc::gen::element(row.min, row.max, row.default_number(),
                                     low + (high - low) * fraction, low + (high - low) / 3.0);
    if (row.type != Type::Real) value = std::floor(value);
    return std::min(std::max(value, row.min), row.max) + 0.0;
}

std::string some_text(const Row& row) {
    if (row.text_rule == TextRule::Choice)
        return std::string(*rc::gen::elementOf(
            std::vector<std::string_view>(row.choices.begin(), row.choices.end())));
    if (row.text_rule == TextRule::Ipv4)
        return *rc::gen::element<std::string>("", "0.0.0.0", "192.168.1.20", "255.255.255.255");
    const auto length = *rc::gen::inRange(0, static_cast<int>(row.max) + 1);
    return *rc::gen::container<std::string>(
        static_cast<std::size_t>(length),
        rc::gen::element(' ', ';', '"', '\\', '#', '=', 'a', 'Z', '7'));
}

Assignment some_assignment() {
    Assignment out;
    out.row = &rows()[*rc::gen::inRange<std::size_t>(0, rows().size())];
    out.instance = *rc::gen::inRange(0U, instances(out.row->scope) + 1);
    if (out.row->type == Type::Text) {
        out.text = some_text(*out.row);
    } else if (out.row->type == Type::Bits && *rc::gen::arbitrary<bool>()) {
        out.bit = *rc::gen::inRange(0, 8);
        const bool free = (static_cast<unsigned>(out.row->max) >> out.bit & 1U) != 0;
        out.number = free && *rc::gen::arbitrary<bool>() ? 1.0 : 0.0;
    } else {
        out.number = some_number(*out.row);
    }
    return out;
}

PROPERTY(ExportedParameters, ReadInAgainToTheSameTable, ()) {
    std::vector<Assignment> assignments;
    const int count = *rc::gen::inRange(0, 60);
    for (int i = 0; i < count; ++i) assignments.push_back(some_assignment());
    auto table = fresh();
    RC_ASSERT(apply(*table, std::span<const Assignment>(assignments)).ok());
    const Content content = *rc::gen::element(Content::Changed, Content::All);
    const ParsedFile file = parse_param_file(export_lines(*table, content), "export");
    RC_ASSERT(file.diagnoses.empty());  // not even a line twice
    auto again = fresh();
    RC_ASSERT(apply(*again, file).ok());
    RC_ASSERT(same(*table, *again));
    RC_ASSERT(difference(*table, *again).empty());
}

PROPERTY(ParameterDifference, AppliedAsLinesGivesTheOtherTable, ()) {
    auto before = fresh(), after = fresh();
    for (Table* table : {before.get(), after.get()}) {
        std::vector<Assignment> assignments;
        for (int i = 0; i < 10; ++i) assignments.push_back(some_assignment());
        RC_ASSERT(apply(*table, std::span<const Assignment>(assignments)).ok());
    }
    std::string lines;
    for (const Difference& one : difference(*before, *after)) {
        RC_ASSERT(one.before != one.after);
        Target target{one.row, one.instance};
        if (one.row->array > 1) target.element = static_cast<int>(one.element);
        lines += target_text(target) + "=" + one.after + "\n";
    }
    RC_ASSERT(apply(*before, parse_param_file(lines, "difference")).ok());
    RC_ASSERT(same(*before, *after));
}

TEST(ExportedParameters, AreNothingWhenNothingWasChanged) {
    EXPECT_EQ(export_lines(*fresh(), Content::Changed), "");
}

TEST(ExportedParameters, HoldOneLineForAllInstancesThatAreAlike) {
    auto table = fresh();
    ASSERT_TRUE(
        apply(*table, parse_param_file("N0304=12000\nN0106#0 A3=1\nN0003 L1=\"a;b\"\n", "m")).ok());
    EXPECT_EQ(export_lines(*table, Content::Changed),
              "; System Config\n"
              "N0003 L1=\"a;b\"          ; Channel Name\n"
              "\n; Axis Config\n"
              "N0106 A3=1              ; Axis Properties DIA\n"
              "\n; Feedrate\n"
              "N0304=12000             ; Rapid, mm/min|inch/min|deg/min\n");
}

TEST(ParameterDifference, SaysWhatWhereAndInWhichUnit) {
    auto before = fresh(), after = fresh();
    put(*after, pt_horizon, 512);
    put(*after, n0401_acc_tc, 0.1, 3);
    const auto list = difference(*before, *after);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(to_string(list[0]), "N0401 A3: 0.05 -> 0.1 s   (Acc Tc)");
    EXPECT_EQ(to_string(list[1]), "PT_HORIZON: 1024 -> 512 records   (Horizon)");
}

TEST(ParameterUnits, FollowTheAxisAndTheUnitOfItsChannel) {
    auto table = fresh();
    ASSERT_TRUE(
        apply(*table, parse_param_file(
                          "N0002 A1=1\nN0002 A2=1\nN0106#1 A2=1\nN0002 A3=2\nN0104#0 L2=1\n", "m"))
            .ok());
    const Row &rapid = *find("N0304"), &limit = *find("N0303"), &chord = *find("N1339"),
              &surface = *find("N0686");
    EXPECT_EQ(unit_of(rapid, *table, 1), "mm/min");
    EXPECT_EQ(unit_of(limit, *table, 2), "deg/min");
    EXPECT_EQ(unit_of(rapid, *table, 3), "inch/min");
    EXPECT_EQ(unit_of(chord, *table, 1), "mm");
    EXPECT_EQ(unit_of(chord, *table, 2), "inch");
    EXPECT_EQ(unit_of(surface, *table, 2), "ft/min");
    EXPECT_EQ(unit_of(*find("PT_ESTOP_DEC"), *table, 2), "deg/s2");
    EXPECT_EQ(unit_of(*find("PT_HORIZON"), *table, 1), "records");
    EXPECT_EQ(unit_of(*find("N0000"), *table, 1), "");
}

TEST(ParameterValues, AreWrittenAsTheyAreRead) {
    auto table = fresh();
    EXPECT_EQ(value_text(*table, *parse_target("N0304")), "10000");
    EXPECT_EQ(value_text(*table, *parse_target("PT_PATH_TOL L1")), "0.005");
    EXPECT_EQ(value_text(*table, *parse_target("N1301#6 L1")), "1");
    EXPECT_EQ(value_text(*table, *parse_target("PT_LANGUAGE L1")), "fanuc");
    put(*table, n0001_control_type, 1, 2);
    EXPECT_EQ(value_text(*table, *parse_target("N0001")).substr(0, 21), "N0001 L1=0\nN0001 L2=1");
}

}  // namespace
}  // namespace polyturn::params
