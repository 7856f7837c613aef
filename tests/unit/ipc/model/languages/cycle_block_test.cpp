// Forms written into a program and read back: the same values, nothing else touched.
#include "ipc/model/languages/cycle_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ipc/model/languages/block_text.hpp"
#include "tests/property.hpp"

namespace polyturn::forms {
namespace {

using Lines = std::vector<std::string>;

const Dialect kDialects[] = {
    {kFanucA, true, 0.001},    {kFanucA, false, 0.001},   {kFanucB, true, 0.0001},
    {kSeries15A, true, 0.001}, {kSeries15B, true, 0.001}, {kNct, true, 0.001},
    {kNct, false, 0.001},      {kFagor, false, 0.0001},   {kSinumerik, false, 0.001}};

std::vector<const Form*> forms_of(const Dialect& dialect) {
    std::vector<const Form*> out;
    each_form(dialect, [&](const Form& form) { out.push_back(&form); });
    return out;
}

// Values on the grid that the field is written with.
Value random_value(const Field& field, const Dialect& dialect) {
    Value value;
    if (!*rc::gen::arbitrary<bool>() && !field.needed && !field.digits) return value;
    const double step = std::pow(10.0, -decimals_of(field, dialect));
    const double low = std::max(field.low, -2000.0), high = std::min(field.high, 2000.0);
    value.set = true;
    value.number = *rc::gen::inRange<long>(std::lround(std::ceil(low / step - 1e-9)),
                                           std::lround(std::floor(high / step + 1e-9)) + 1) *
                   step;
    return value;
}

void expect_same(const CycleBlock& a, const CycleBlock& b) {
    RC_ASSERT(a.form == b.form);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        RC_ASSERT(a.values[i].set == b.values[i].set);
        RC_ASSERT(a.values[i].expression == b.values[i].expression);
        if (a.values[i].set) RC_ASSERT(std::fabs(a.values[i].number - b.values[i].number) < 1e-6);
    }
}

PROPERTY(CycleForms, WhatIsWrittenIsReadBack, ()) {
    const Dialect& dialect = kDialects[*rc::gen::inRange<std::size_t>(0, std::size(kDialects))];
    const auto forms = forms_of(dialect);
    const Form& form = *forms[*rc::gen::inRange<std::size_t>(0, forms.size())];
    CycleBlock cycle = new_cycle(form);
    for (std::size_t i = 0; i < cycle.values.size(); ++i)
        cycle.values[i] = random_value(form.fields[i], dialect);
    RC_ASSERT(is_good(check_cycle(cycle)));
    const Lines before{"G0 X60. Z2.", "M8", "M30"};
    Lines lines = before;
    apply_changes(lines, write_cycle(lines, CycleBlock{&form, {}, {-1, -1}}, cycle, 1, dialect));
    RC_ASSERT(lines.front() == before.front());
    RC_ASSERT(lines[lines.size() - 2] == "M8");
    RC_ASSERT(lines.back() == "M30");
    const auto found = read_cycle(lines, static_cast<int>(lines.size()) - 3, dialect);
    RC_ASSERT(found.has_value());
    expect_same(*found, cycle);
    // A form that nobody changes changes nothing (I1).
    RC_ASSERT(write_cycle(lines, *found, *found, 0, dialect).empty());
    // One field: its word alone (I3).
    const auto i = *rc::gen::inRange<std::size_t>(0, form.fields.size());
    Lines commented = lines;
    for (int block : {0, 1})
        if (found->line[block] >= 0) {
            std::string& line = commented[static_cast<std::size_t>(found->line[block])];
            line = "N70 " + line +
                   (dialect.speaks == kFagor || form.is_call() ? " ;why so"
                    : dialect.speaks == kSinumerik             ? " M8 ;why so"
                                                               : " M8 (why so)");
        }
    const auto again = read_cycle(
        commented,
        found->line[form.fields[i].block] >= 0 ? found->line[form.fields[i].block] : found->line[1],
        dialect);
    RC_ASSERT(again.has_value());
    expect_same(*again, cycle);
    CycleBlock changed = *again;
    changed.values[i] = random_value(form.fields[i], dialect);
    RC_PRE(changed.values[i].set || !form.fields[i].digits);
    Lines after = commented;
    const auto changes = write_cycle(commented, *again, changed, 0, dialect);
    RC_ASSERT(changes.size() <= 1u);
    apply_changes(after, changes);
    if (changes.empty() || changes[0].inserts) return;
    const Notation notation = dialect.speaks == kFagor       ? Notation::Fagor
                              : dialect.speaks == kSinumerik ? Notation::Sinumerik
                                                             : Notation::Family;
    const BlockText was(commented[static_cast<std::size_t>(changes[0].at)], notation),
        is(changes[0].text, notation);
    RC_ASSERT(is.line().substr(0, 4) == "N70 ");
    RC_ASSERT(is.line().find("why so") != std::string::npos);
    for (const TextWord& word : was.words())
        if (word.address != form.fields[i].address) {
            RC_ASSERT(is.find(word.address) != nullptr);
            RC_ASSERT(is.find(word.address)->value == word.value);
        }
    const auto third = read_cycle(after, changes[0].at, dialect);
    RC_ASSERT(third.has_value());
    expect_same(*third, changed);
}

TEST(CycleForms, BothBlocksOpenTheSameForm) {
    const Lines lines{"G0 X62. Z2.",     "N5 G71 U2. R0.5 (roughing)", "",
                      "(contour below)", "G71P100Q200U.4W0.1F.25S150", "N100 G0 X20."};
    const Dialect dialect{kFanucA, true, 0.001};
    for (const int at : {1, 4}) {
        const auto cycle = read_cycle(lines, at, dialect);
        ASSERT_TRUE(cycle) << at;
        EXPECT_EQ(cycle->line[0], 1);
        EXPECT_EQ(cycle->line[1], 4);
        EXPECT_DOUBLE_EQ(cycle->values[0].number, 2);
        EXPECT_DOUBLE_EQ(cycle->values[4].number, 0.4);
    }
    EXPECT_FALSE(read_cycle(lines, 0, dialect));
    EXPECT_FALSE(read_cycle(lines, 3, dialect));
    auto now = *read_cycle(lines, 4, dialect);
    const auto before = now;
    now.values[4].number = 0.6;
    now.values[5].set = false;
    Lines after = lines;
    apply_changes(after, write_cycle(lines, before, now, 0, dialect));
    EXPECT_EQ(after[4], "G71P100Q200U0.6F.25S150");
    EXPECT_EQ(after[1], lines[1]);
}

TEST(CycleForms, ExpressionsAndIncrementsStay) {
    const Lines lines{"G90 U-4. Z[#100*2+1] F#3 (one pass)"};
    const Dialect dialect{kFanucA, true, 0.001};
    const auto cycle = read_cycle(lines, 0, dialect);
    ASSERT_TRUE(cycle);
    EXPECT_EQ(cycle->values[0].address, "U");
    EXPECT_EQ(cycle->values[1].expression, "[#100*2+1]");
    EXPECT_EQ(cycle->values[3].expression, "#3");
    CycleBlock now = *cycle;
    now.values[0].number = -5;
    Lines after = lines;
    apply_changes(after, write_cycle(lines, *cycle, now, 0, dialect));
    EXPECT_EQ(after[0], "G90 U-5. Z[#100*2+1] F#3 (one pass)");
    // the end point instead of the way
    now.values[0].address.clear();
    now.values[0].number = 36;
    after = lines;
    apply_changes(after, write_cycle(lines, *cycle, now, 0, dialect));
    EXPECT_EQ(after[0], "G90 Z[#100*2+1] F#3 X36. (one pass)");
}

TEST(CycleForms, CountsWithoutAPointAreRead) {
    const Lines lines{"G76 P021060 Q50 R20", "G76 X17550 Z-20000 P1227 Q300 F2.0"};
    const Dialect dialect{kFanucA, true, 0.001};
    const auto cycle = read_cycle(lines, 0, dialect);
    ASSERT_TRUE(cycle);
    const double expected[] = {2, 10, 60, 0.05, 0.02, 17.55, -20, 0, 1.227, 0.3, 2};
    for (std::size_t i = 0; i < std::size(expected); ++i)
        EXPECT_NEAR(cycle->values[i].number, expected[i], 1e-9) << i;
    CycleBlock now = *cycle;
    now.values[1].number = 5;
    EXPECT_EQ(write_cycle(lines, *cycle, now, 0, dialect)[0].text, "G76 P020560 Q50 R20");
}

TEST(CycleForms, FaultsStandAtTheirFields) {
    const Dialect dialect{kNct, true, 0.001};
    CycleBlock cycle = new_cycle(*forms_of(dialect)[0]);  // G71
    EXPECT_TRUE(is_good(check_cycle(cycle)));
    cycle.values[0].number = -1;
    cycle.values[2].set = false;
    cycle.values[3].number = 20.5;
    const auto faults = check_cycle(cycle);
    EXPECT_EQ(faults[0].kind, FieldFault::TooSmall);
    EXPECT_EQ(faults[2].kind, FieldFault::Missing);
    EXPECT_EQ(faults[3].kind, FieldFault::NotWhole);
    EXPECT_EQ(faults[4].kind, FieldFault::None);
}

TEST(CycleForms, NoFormTouchesAMacroOrABlockBehindASemicolon) {
    const Dialect dialect{kFanucA, true, 0.001};
    EXPECT_FALSE(read_cycle({"IF[#1EQ2]GOTO90"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"#90=71"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"G90 X30. Z-5.;G0 X50."}, 0, dialect));
    EXPECT_FALSE(read_cycle({"G90 X30. Z-5."}, 0, {}));
    EXPECT_TRUE(read_cycle({"/2 G90 X30. Z-5. ;"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"(G90 X30. Z-5.)"}, 0, dialect));
}

TEST(CycleForms, FagorValuesMayBeParameters) {
    const Dialect dialect{kFagor, false, 0.0001};
    const Lines lines{"N0070 G81 X20 Z0 Q40 R-30 C P5 D1 L0.5 ;section"};
    const auto cycle = read_cycle(lines, 0, dialect);
    ASSERT_TRUE(cycle);
    EXPECT_EQ(cycle->values[4].expression, "P5");
    CycleBlock now = *cycle;
    now.values[4] = {true, 2.5, {}, {}};
    EXPECT_EQ(write_cycle(lines, *cycle, now, 0, dialect)[0].text,
              "N0070 G81 X20 Z0 Q40 R-30 C 2.5 D1 L0.5 ;section");
}

// sinumerik_part2 10.10.1: K makes a thread along Z, I one in the face; SF is a word of two
// letters.
TEST(CycleForms, SinumerikThreadsAreChosenByTheirLead) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    const Lines lines{"N10 G33 Z=R1+2 K2 SF=180 LFON ;second start", "G33X20I1.5",
                      "G33 X40 Z-30 I3"};
    const auto along = read_cycle(lines, 0, dialect);
    ASSERT_TRUE(along);
    const auto value = [](const CycleBlock& cycle, std::string_view address) {
        for (std::size_t i = 0; i < cycle.values.size(); ++i)
            if (cycle.form->fields[i].address == address) return cycle.values[i];
        return Value{};
    };
    EXPECT_EQ(value(*along, "Z").expression, "R1+2");
    EXPECT_DOUBLE_EQ(value(*along, "K").number, 2);
    EXPECT_DOUBLE_EQ(value(*along, "SF").number, 180);
    CycleBlock now = *along;
    for (std::size_t i = 0; i < now.values.size(); ++i) {
        if (now.form->fields[i].address == "SF") now.values[i].number = 90;
        if (now.form->fields[i].address == "Z") now.values[i] = {true, -35, {}, {}};
        if (now.form->fields[i].address == "DITE") now.values[i] = {true, 3, {}, {}};
    }
    EXPECT_EQ(write_cycle(lines, *along, now, 0, dialect)[0].text,
              "N10 G33 Z=-35 K2 SF=90 LFON DITE=3 ;second start");
    for (const int at : {1, 2}) {
        const auto face = read_cycle(lines, at, dialect);
        ASSERT_TRUE(face) << at;
        EXPECT_EQ(face->form->picture, Picture::FaceThread) << at;
        EXPECT_TRUE(value(*face, "I").set);
    }
}

// The speed has a block of its own (10.11.1); both open the form.
TEST(CycleForms, SinumerikTapsHaveTheirSpeedInABlockOfItsOwn) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    const Lines lines{"SPOS=0", "G331 S400", "G331 X20 I-1.25", "G332 X46 I-1.25"};
    for (const int at : {1, 2}) {
        const auto tap = read_cycle(lines, at, dialect);
        ASSERT_TRUE(tap) << at;
        EXPECT_EQ(tap->form->picture, Picture::TapSide);
        EXPECT_EQ(tap->line[0], 1);
        EXPECT_EQ(tap->line[1], 2);
        EXPECT_DOUBLE_EQ(tap->values[0].number, 400);
    }
    Lines fresh{"M30"};
    each_form(dialect, [&](const Form& form) {
        if (form.code == "G331" && form.picture == Picture::TapFace)
            apply_changes(fresh, write_cycle(fresh, CycleBlock{&form, {}, {-1, -1}},
                                             new_cycle(form), 0, dialect));
    });
    EXPECT_EQ(fresh, (Lines{"G331 S500", "G331 Z-15 K1.5", "M30"}));
}

// The arguments of a call are told by their place; an empty one stays empty, at the end it is not
// written.
TEST(CycleForms, SinumerikCallsHaveTheirValuesInBrackets) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    const Lines lines{"N10 mcall Cycle82 ( 10,0 , 2, -20, , R1 * (2 + R[3,1]) ) ;why so",
                      "CYCLE85(10,0,,-20,,,80)"};
    const auto deep = read_cycle(lines, 0, dialect);
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->form->code, "MCALL CYCLE82");
    const double expected[] = {10, 0, 2, -20};
    for (std::size_t i = 0; i < std::size(expected); ++i)
        EXPECT_DOUBLE_EQ(deep->values[i].number, expected[i]) << i;
    EXPECT_FALSE(deep->values[4].set);
    EXPECT_EQ(deep->values[5].expression, "R1 * (2 + R[3,1])");
    const auto changed = [&](const CycleBlock& before,
                             const std::vector<std::pair<std::size_t, Value>>& values) {
        CycleBlock now = before;
        for (const auto& [i, value] : values) now.values[i] = value;
        const auto changes = write_cycle(lines, before, now, 0, dialect);
        return changes.size() == 1 ? changes[0].text : std::string("none");
    };
    const Value none;
    EXPECT_EQ(changed(*deep, {{1, {true, -2.5, {}, {}}}}),
              "N10 mcall Cycle82 ( 10,-2.5 , 2, -20, , R1 * (2 + R[3,1]) ) ;why so");
    EXPECT_EQ(changed(*deep, {{3, none}, {4, {true, 15, {}, {}}}}),
              "N10 mcall Cycle82 ( 10,0 , 2, , 15, R1 * (2 + R[3,1]) ) ;why so");
    EXPECT_EQ(changed(*deep, {{5, none}}), "N10 mcall Cycle82 ( 10,0 , 2, -20) ;why so");
    const auto ream = read_cycle(lines, 1, dialect);
    ASSERT_TRUE(ream);
    EXPECT_EQ(ream->form->code, "CYCLE85");
    EXPECT_FALSE(ream->values[2].set || ream->values[5].set || ream->values[7].set);
    EXPECT_DOUBLE_EQ(ream->values[6].number, 80);
    EXPECT_EQ(changed(*ream, {{2, {true, 1, {}, {}}}, {7, {true, 200, {}, {}}}}),
              "CYCLE85(10,0,1,-20,,,80,200)");
    EXPECT_EQ(changed(*ream, {{6, none}}), "CYCLE85(10,0,,-20)");
}

TEST(CycleForms, SinumerikCallsAreProposedAsOneWritesThem) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    Lines fresh;
    each_form(dialect, [&](const Form& form) {
        if (form.is_call())
            apply_changes(fresh,
                          write_cycle(fresh, CycleBlock{&form, {}, {-1, -1}}, new_cycle(form),
                                      static_cast<int>(fresh.size()), dialect));
    });
    EXPECT_EQ(fresh, (Lines{"CYCLE81(10, 0, 2, -15)", "CYCLE82(10, 0, 2, -15, , 0.5)",
                            "CYCLE85(10, 0, 2, -15)", "MCALL CYCLE81(10, 0, 2, -15)",
                            "MCALL CYCLE82(10, 0, 2, -15, , 0.5)", "MCALL CYCLE85(10, 0, 2, -15)",
                            "HOLES1(0, 0, 0, 10, 8, 3)", "HOLES2(0, 0, 20, 0, 0, 6)"}));
}

// DP or DPR: one of them is needed (CYCLE81).
TEST(CycleForms, TheBottomOfAHoleIsToldByPlaceOrByDepth) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    EXPECT_TRUE(is_good(check_cycle(*read_cycle({"CYCLE81(10, 0, 2, -15)"}, 0, dialect))));
    EXPECT_TRUE(is_good(check_cycle(*read_cycle({"CYCLE81(10, 0, 2, , 15)"}, 0, dialect))));
    const auto faults = check_cycle(*read_cycle({"CYCLE81(10, 0, 2)"}, 0, dialect));
    EXPECT_EQ(faults[3].kind, FieldFault::Missing);
    EXPECT_EQ(faults[4].kind, FieldFault::None);
}

TEST(CycleForms, NoFormTouchesASinumerikStatementOrASplitValue) {
    const Dialect dialect = dialect_of("sinumerik", 'A', false, false, 0.001);
    EXPECT_FALSE(read_cycle({"G33 Z=R1 + 2 K2"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"G33 Z-20 K2EX1"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"START: G33 Z-20 K2"}, 0, dialect));
    EXPECT_FALSE(read_cycle({"MSG(\"G33 Z-20 K2\")"}, 0, dialect));
    for (const char* call :
         {"CYCLE83(10, 0, 2, -15)", "G0 CYCLE81(10, 0, 2, -15)", "CYCLE81(10, 0, 2, -15) M8",
          "CYCLE81(10, 0, 2, -15", "CYCLE81(10, 0, 2, -15 ;)", "CYCLE81(10, (0, 2), \"-15\")",
          "IF (R1 == 2) CYCLE81(10, 0, 2, -15)", "CYCLE81[10, 0, 2, -15]", "CYCLE81(10, 0, 2, -15]",
          ";CYCLE81(10, 0, 2, -15)", "CYCLE81 10", "CYCLE81", "MCALL"})
        EXPECT_FALSE(read_cycle({call}, 0, dialect)) << call;
    EXPECT_FALSE(read_cycle({"IF R1 == 2 G33 Z-20 K2"}, 0, dialect));
    EXPECT_TRUE(read_cycle({"/1 N20 G33 Z=IC(-20) K2 F0.2 DIAMON"}, 0, dialect));
}

}  // namespace
}  // namespace polyturn::forms
