// One line, one fact. Columns count characters from 1.
#include <gtest/gtest.h>

#include <cmath>

#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::params {
namespace {

struct Good {
    std::string_view line;
    std::string_view target;  // as target_text() writes it
    double number;
    std::string_view text = "";
};
constexpr Good kGood[] = {
    {"N1300 L1=5", "N1300 L1", 5},
    {"N1300=5", "N1300", 5},  // every channel
    {"N1414#2=1", "N1414#2", 1},
    {"N2102#0 A6=1", "N2102#0 A6", 1},
    {"N2101 A6=2", "N2101 A6", 2},
    {"F5002#1=0", "F5002#1", 0},
    {"F5002=00000010", "F5002", 2},  // the leftmost of eight digits is #7
    {"F5002=10000001", "F5002", 129},
    {"F5002=129", "F5002", 129},
    {"F5002=00000000", "F5002", 0},
    {"F6052=130", "F6052", 130},
    {"F1260=360", "F1260", 360},
    {"PT_HORIZON=512", "PT_HORIZON", 512},
    {"MEFI.80=12.5", "MEFI.80", 12.5},
    {"N0304 A96=1e4", "N0304 A96", 10000},
    {"N0304 A1=+10000.", "N0304 A1", 10000},
    {"N0200 A1=-.5", "N0200 A1", -0.5},
    {"N0200 A1=-0", "N0200 A1", 0},  // one value, one spelling
    {"N0634 S32=4000", "N0634 S32", 4000},
    {"PT_WAIT_TIMEOUT T8=30", "PT_WAIT_TIMEOUT T8", 30},
    {"  n1300\t l16 = 5  ; power-on", "N1300 L16", 5},  // small letters, blanks, comment
    {"N0003 L1=Upper", "N0003 L1", 0, "Upper"},
    {"N0003 L1 = up per ; left one", "N0003 L1", 0, "up per"},
    {"N0003 L1=\"a;b\"", "N0003 L1", 0, "a;b"},
    {"N0003 L1=\" \\\"\\\\ \" ; quoted", "N0003 L1", 0, " \"\\ "},
    {"N0003 L2=", "N0003 L2", 0, ""},
    // eight characters in ten bytes
    {"N0003 L1=\u00d6ffnen\u00df", "N0003 L1", 0, "\u00d6ffnen\u00df"},
    {"PT_LANGUAGE L2=sinumerik", "PT_LANGUAGE L2", 0, "sinumerik"},
    {"N5101=192.168.0.1", "N5101", 0, "192.168.0.1"},
    {"N0512 A1=4294967296", "N0512 A1", 4294967296.0},
};

TEST(ParameterLine, IsRead) {
    for (const Good& good : kGood) {
        SCOPED_TRACE(good.line);
        const auto result = parse_assignment(good.line);
        ASSERT_TRUE(result.ok()) << result.diagnosis().text();
        EXPECT_EQ(target_text(*result), good.target);
        EXPECT_DOUBLE_EQ(result->number, good.number);
        EXPECT_FALSE(std::signbit(result->number) && result->number == 0.0);
        EXPECT_EQ(result->text, good.text);
    }
}

struct Bad {
    std::string_view line;
    Alarm alarm;
    unsigned column, length;
    std::string_view says;  // part of the text that the operator reads
};
constexpr Bad kBad[] = {
    {"", Alarm::ParamSyntax, 1, 1, "name is missing"},
    {"   ; only a comment", Alarm::ParamSyntax, 4, 1, "name is missing"},
    {"=5", Alarm::ParamSyntax, 1, 1, "name"},
    {"!N1300=5", Alarm::ParamSyntax, 1, 6, "!N1300"},
    {"N1300", Alarm::ParamSyntax, 6, 1, "'=' and a value are missing"},
    {"N1300 L1", Alarm::ParamSyntax, 9, 1, "'='"},
    {"N1300 L1 L2=5", Alarm::ParamSyntax, 10, 2, "'='"},
    {"N1300L1=5", Alarm::ParamUnknown, 1, 7, "N1300L1"},
    {"N9999=5", Alarm::ParamUnknown, 1, 5, "N9999"},
    {"N304 A1=5", Alarm::ParamUnknown, 1, 4, "N0304 Rapid"},  // proposes what was meant
    {"MD99999[5]=2", Alarm::ParamUnknown, 1, 7, "MD99999"},   // known grammar, no such row
    {"SD49999=1", Alarm::ParamUnknown, 1, 7, "SD49999"},
    {"FG.NONE X=1", Alarm::ParamUnknown, 1, 7, "FG.NONE"},
    {"PT_HORIZN=1", Alarm::ParamUnknown, 1, 9, "PT_HORIZON"},
    {"N1300 A1=5", Alarm::ParamScope, 7, 2, "once per channel (L1 to L16)"},
    {"N1300 L0=5", Alarm::ParamScope, 7, 2, "outside L1 to L16"},
    {"N1300 L17=5", Alarm::ParamScope, 7, 3, "outside L1 to L16"},
    {"N0304 A97=5", Alarm::ParamScope, 7, 3, "A96"},
    {"N0304 A99999999999999999999=5", Alarm::ParamScope, 7, 21, "axis"},
    {"N0634 S33=5", Alarm::ParamScope, 7, 3, "S32"},
    {"N0304 X=5", Alarm::ParamScope, 7, 1, "axis"},
    {"N0304 A=5", Alarm::ParamScope, 7, 1, "axis"},
    {"PT_HORIZON L1=5", Alarm::ParamScope, 12, 2, "exists once"},
    {"N1300#8 L1=1", Alarm::ParamBit, 6, 2, "#0 to #7"},
    {"N1300# L1=1", Alarm::ParamBit, 6, 1, "#0 to #7"},
    {"N1300#12=1", Alarm::ParamBit, 6, 3, "#0 to #7"},
    {"N0304#1=1", Alarm::ParamBit, 6, 2, "has no bits"},
    {"N1414#2=2", Alarm::ParamBit, 9, 1, "0 or 1"},
    {"N1414#2=01", Alarm::ParamBit, 9, 2, "0 or 1"},
    {"N1414#2=on", Alarm::ParamBit, 9, 2, "0 or 1"},
    {"N1756#5=1", Alarm::ParamBit, 9, 1, "reserved"},
    {"N1300[1]=5", Alarm::ParamElement, 6, 3, "has no index"},
    {"N1300[x]=5", Alarm::ParamSyntax, 6, 1, "brackets"},
    {"N1300 L1=", Alarm::ParamValue, 10, 1, "missing"},
    {"N1300 L1=;5", Alarm::ParamValue, 10, 1, "missing"},
    {"N0304 A1=fast", Alarm::ParamValue, 10, 4, "'fast' is no number"},
    {"N0304 A1=2,5", Alarm::ParamValue, 10, 3, "behind a point"},
    {"N0304 A1=10 mm", Alarm::ParamValue, 10, 5, "is no number"},
    {"N0304 A1=inf", Alarm::ParamValue, 10, 3, "is no number"},
    {"N0304 A1=nan", Alarm::ParamValue, 10, 3, "is no number"},
    {"N0304 A1=0x10", Alarm::ParamValue, 10, 4, "is no number"},
    {"N0304 A1=--1", Alarm::ParamValue, 10, 3, "is no number"},
    {"N0304 A1=+-1", Alarm::ParamValue, 10, 3, "is no number"},
    {"N1307 L1=5.5", Alarm::ParamValue, 10, 3, "whole number"},
    {"N0304 A1=1e999", Alarm::ParamRange, 10, 5, "1e999"},
    {"N0304 A1=-1", Alarm::ParamRange, 10, 2, "from 0 mm/min"},
    {"N1300 L1=256", Alarm::ParamRange, 10, 3, "0 to 255"},
    {"N0000 L1=9", Alarm::ParamRange, 10, 1, "0 to 8"},
    {"N1756 L1=00000100", Alarm::ParamRange, 10, 8, "0 to 3"},
    {"N2308 L1=-1", Alarm::ParamRange, 10, 2, "from 0"},
    {"N0003 L1=\"open", Alarm::ParamSyntax, 10, 1, "closing"},
    {"N0003 L1=\"a\" b", Alarm::ParamSyntax, 14, 1, "behind the text"},
    {"N0003 L1=nine char", Alarm::ParamText, 10, 9, "0 to 8 characters"},
    {"N0003 L1=a\x01", Alarm::ParamText, 10, 2, "control"},
    {"N0003 L1=\xff\xfe", Alarm::ParamText, 10, 2, "UTF-8"},
    {"PT_LANGUAGE L1=heidenhain", Alarm::ParamText, 16, 10, "one of fanuc, nct"},
    {"N5101=300.1.1.1", Alarm::ParamText, 7, 9, "0 to 255"},
    {"N5101=1.2.3", Alarm::ParamText, 7, 5, "four numbers"},
    {"N5101=1.2.3.4.5", Alarm::ParamText, 7, 9, "four numbers"},
    {"N5101=1.2.3.04", Alarm::ParamText, 7, 8, "four numbers"},
    {"\u00e9=1", Alarm::ParamSyntax, 1, 1, "\u00e9"},
    // columns count characters, not bytes
    {"N0003 \u00e9\u00e9=1", Alarm::ParamSyntax, 7, 2, "behind N0003"},
};

TEST(ParameterLine, IsDiagnosedAtItsColumn) {
    for (const Bad& bad : kBad) {
        SCOPED_TRACE(bad.line);
        const auto result = parse_assignment(bad.line);
        ASSERT_FALSE(result.ok());
        const Diagnosis& diagnosis = result.diagnosis();
        EXPECT_EQ(diagnosis.alarm, bad.alarm) << diagnosis.text();
        EXPECT_EQ(diagnosis.place.column, bad.column);
        EXPECT_EQ(diagnosis.place.length, bad.length);
        EXPECT_NE(diagnosis.text().find(bad.says), std::string::npos) << diagnosis.text();
        EXPECT_FALSE(diagnosis.remedy().empty());
    }
}

TEST(ParameterLine, NeverRepeatsALongLineOrControlCharacters) {
    const auto result = parse_assignment("N1300 L1=" + std::string(1'000'000, '\x1b'));
    ASSERT_FALSE(result.ok());
    EXPECT_LT(result.diagnosis().text().size(), 400U);
    EXPECT_EQ(result.diagnosis().text().find('\x1b'), std::string::npos);
}

TEST(ParameterTarget, IsReadWithoutAValue) {
    const auto target = parse_target("N1600 L1");
    ASSERT_TRUE(target.ok());
    EXPECT_EQ(target_text(*target), "N1600 L1");
    EXPECT_EQ(target_text(*parse_target("n1414#2")), "N1414#2");
    EXPECT_EQ(parse_target("N1600 L1=5").diagnosis().alarm, Alarm::ParamSyntax);
    EXPECT_EQ(parse_target("N1600 L1=5").diagnosis().place.column, 9U);
    EXPECT_EQ(parse_target("").diagnosis().alarm, Alarm::ParamSyntax);
}

TEST(ParameterTarget, OtherControlsNamesLeadToTheSameValue) {
    EXPECT_EQ(target_text(*parse_target("MD32000 A2")), "N0304 A2");
    EXPECT_EQ(target_text(*parse_target("fg.g00feed")), "N0304");
    // the axis by its letter, as Fagor names it
    const auto line = parse_assignment("FG.MAXFEED X=1500");
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line->row->number, "N0305");
    EXPECT_EQ(line->axis, 'X');
    EXPECT_FALSE(parse_assignment("N0305 X=1500").ok());
}

}  // namespace
}  // namespace polyturn::params
