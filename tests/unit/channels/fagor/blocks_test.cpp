// The language fagor: where blocks of words lead. Every row follows from spec fagor_8037t part 1,
// section in brackets.
#include <gtest/gtest.h>

#include "../play.hpp"
#include "../quiet_sink.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::testing {
namespace {

Play fagor(std::vector<std::string> sets = {}) {
    Play how;
    how.language = "fagor";
    how.sets = std::move(sets);
    return how;
}

// Programmed points "X,Z" of all moves.
std::string points(const Played& played) {
    std::string all;
    for (const std::string& line : played.lines()) {
        const std::size_t x = line.find("\"pos\":{\"X\":");
        if (line.find("\"ev\":\"move\"") == std::string::npos || x == std::string::npos) continue;
        const std::size_t from = x + 11, comma = line.find(',', from),
                          z = line.find("\"Z\":", comma) + 4;
        if (!all.empty()) all += ' ';
        all +=
            line.substr(from, comma - from) + "," + line.substr(z, line.find_first_of(",}", z) - z);
    }
    return all;
}

struct Row {
    std::string_view program, points;
};

TEST(FagorBlock, MovesWhereItsWordsSay) {
    const Row rows[] = {
        // [2] blanks, missing numbers
        {"G152\nG X 1.5 Z -.5\nG01 X Z F100", "1.5,-0.5 0,0"},
        // [2] parameters as numbers
        {"G152\n(P101=7)\nG00 XP101 Z-P101", "7,-7"},
        // [3.4] increments of X are diameters
        {"G151\nG00 X20 Z0\nG91 X-10", "20,0 10,0"},
        {"G152\nG70 G00 X1 Z-2\nG71 X1", "25.4,-50.8 1,-50.8"},  // [3.3]
        // [3.6.2] what is missing stays
        {"G152\nG00 R10 Q90\nQ0\nG91 R5\nQ90", "10,0 0,10 0,15 15,0"},
        // [3.6.2] modulo a turn, [4.5]
        {"G152\nG93 I10 J20\nG00 R5 Q-270", "25,10"},
        // [3.6.3]
        {"G152\nG00 X10 Z10\nQ45 Z20\nQ270 X5\nQ180 Z0", "10,10 20,20 5,20 5,0"},
        // [7.5, 7.6]
        {"G152\nG13\nG00 X1 Z2\nG10\nZ3\nG72 S2\nX5 Z5", "1,-2 1,3 10,10"},
        {"G152\nG11 G13\nG00 X1 Z2\nG10\nG14 Z\nZ9", "-1,-2 -1,-9"},
        {"G152\nG00 X0 Z10\nG01 G36 R2 X10 F100\nZ0", "0,10 8,10 10,8 10,0"},  // [6.9]
        {"G152\nG00 X0 Z10\nG01 G39 R2 X10 F100\nZ0", "0,10 8,10 10,8 10,0"},  // [6.10]
        // [6.7] on the circle about X5 Z10
        {"G152\nG00 X20 Z30\nG01 G37 R5 X0 Z10 F100\nZ0", "20,30 1.680816,13.739388 0,10 0,0"},
    };
    for (const Row& row : rows)
        EXPECT_EQ(points(play(row.program, fagor())), row.points) << row.program;
}

// [5, 6.14] The move to a hard stop is a G01: F, S and T of its block act, and hold behind it.
TEST(FagorBlock, TheMoveToAHardStopTakesItsWords) {
    const Played played = play("G152\nG01 X30 Z0 F200\nG52 X40 F100 T3\nG01 X30", fagor());
    EXPECT_EQ(played.errors, 0u);
    EXPECT_FALSE(played.find({"\"line\":3", "\"ev\":\"aux\"", "T3"}).empty());
    const std::string behind = played.find({"\"line\":4", "\"ev\":\"move\""});
    EXPECT_NE(behind.find("100"), std::string::npos) << behind;
    EXPECT_EQ(behind.find("200"), std::string::npos) << behind;
}

TEST(FagorBlock, ArcsGoTheWayTheirFormSays) {
    const auto arc = [](std::string_view program) {
        const Played played = play(program, fagor());
        return played.find({"centre"});
    };
    // [6.3] a full circle
    EXPECT_NE(arc("G152\nG00 X10 Z0\nG02 X10 Z0 K5 I0 F100").find("\"kind\":\"cw\""),
              std::string::npos);
    EXPECT_NE(arc("G152\nG00 X10 Z0\nG03 X0 Z10 R-10 F100").find("\"centre\":{\"Z\":0,\"X\":0}"),
              std::string::npos);
    // [6.5]
    EXPECT_NE(arc("G152\nG00 X10 Z0\nG01 Z-5 F100\nG08 X20 Z-15").find("\"radius\":10"),
              std::string::npos);
    // [6.6]
    EXPECT_NE(arc("G152\nG00 X0 Z10\nG09 X0 Z-10 I10 K0 F100").find("\"kind\":\"ccw\""),
              std::string::npos);
    // [6.4]
    EXPECT_NE(
        arc("G152\nG00 X10 Z0\nG06 G02 X0 Z10 I0 K0 F100").find("\"centre\":{\"Z\":0,\"X\":0}"),
        std::string::npos);
}

TEST(FagorBlock, ZerosReplaceOrAddToEachOther) {
    const auto machine = [](std::string_view program) {
        const Played played = play(program, fagor(), [](MachineView& view) {
            for (int row = 1; row <= 6; ++row)
                view.store->zeros[static_cast<std::size_t>(row) * kChannelAxes + 1] = 10.0 * row;
            view.store->zeros[*settable_zero_row(7) * kChannelAxes + 1] = 70.0;
        });
        std::string all;
        for (const std::string& line : played.lines()) {
            const std::size_t x = line.find("\"machine\":{");
            if (x == std::string::npos) continue;
            const std::size_t z = line.find("\"Z\":", x) + 4;
            all += line.substr(z, line.find_first_of(",}", z) - z) + " ";
        }
        return all;
    };
    // [4.4.2]
    EXPECT_EQ(machine("G152\nG00 Z1\nG55\nZ0\nG59\nZ0\nG58\nZ0\nG56\nZ0\nG53\nZ0"),
              "1 20 80 70 30 0 ");
    EXPECT_EQ(machine("G152\nG159 N5\nG00 Z0\nG159 N7\nZ0"), "50 70 ");
    // [4.4.1]
    EXPECT_EQ(machine("G152\nG54\nG00 Z5\nG92 Z0\nZ1\nG57\nZ0"), "15 16 40 ");
    // [4.3]
    EXPECT_EQ(machine("G152\nG54\nG00 Z5\nG53 Z3\nZ5"), "15 3 15 ");
}

struct Refusal {
    std::string_view program;
    Alarm alarm;
    std::string_view place;  // part of the event
};

TEST(FagorBlock, RefusesByName) {
    const Refusal rows[] = {
        {"G60 X1", Alarm::GCodeUnknown, "\"column\":1"},
        {"G152\n\nG00 X1", Alarm::FagorBlockEmpty, "\"line\":2"},
        {"G54 M8", Alarm::FagorAlone, "\"line\":1"},
        {"G00 G01 X1", Alarm::FagorIncompatible, "\"number\":7"},
        {"G152\nG00 X5\nG02 X5 R4 F10", Alarm::FagorFullCircle, "\"line\":3"},
        {"G152\nG00 X10 Z0\nG02 X0 Z20 K3 F10", Alarm::ArcRadiusDiffers, "\"line\":3"},
        {"G152\nG00 X10 Z0\nG91 R-20", Alarm::FagorPolarRadius, "\"line\":3"},
        {"G152\nG00 X0 Z0\nQ90 Z5", Alarm::FagorAngle, "\"line\":3"},
        {"G96 S100 M3", Alarm::FagorGear, "\"line\":1"},
        {"G51 E0.1\nG95", Alarm::FagorIncompatible, "\"number\":7"},
        {"G51 E0.1\nG33 Z-5 L1", Alarm::FagorIncompatible, "\"number\":7"},
        {"G152\nG01 G37 X5 F10", Alarm::FagorElementRadius, "\"line\":2"},
        {"G152\nG00 X10 Z0\nG02 G37 R2 X0 Z10 R10 F10", Alarm::FagorTangential, "\"line\":3"},
        {"G152\nG02 G41 X1", Alarm::CompArcStartEnd, "\"line\":2"},
        {"X1 N3", Alarm::FagorRepeat, "\"line\":1"},
        {"G33 Z-5 L1 Q90", Alarm::FagorThreadAngle, "\"line\":1"},
        {"G83 X0 Z0 I0 B5", Alarm::FagorCycleZero, "\"line\":1"},
        {"G81 X30 Z0 Q54 R-24 C0", Alarm::FagorCycleZero, "\"line\":1"},
        {"G86 X30 Z0 Q30 R-20 I1 B0.2 C1 M0.1 K-10", Alarm::FagorCyclePair, "\"line\":1"},
        {"G88 X30 Z0 Q30 R-20 C2", Alarm::FagorGrooveDepth, "\"line\":1"},
        // [3.3] 5.4
        {"X100000", Alarm::DigitsTooMany, "\"line\":1"},
        // [3.3] inch 4.5
        {"G70\nX3937.1", Alarm::DigitsTooMany, "\"line\":2"},
        // [part 2, 11.2.1]
        {"XP2000", Alarm::FagorMakerParameter, "\"column\":2"},
        // [part 2, 9.0.3] six digits
        {"G68 X20 Z0 C2 S1 E2 Q123456", Alarm::SubprogramMissing, "P123456"},
        // [part 2, 9.2]
        {"G152\nG00 X50 Z-5\nG68 X20 Z0 C2 S1 E2\nM30\nN1 G01 Z-10\nN2 X30 Z-20",
         Alarm::FagorCyclePosition, "\"line\":3"},
        {"G152\nG00 X50 Z0.2\nG68 X20 Z0 C2 M0.3 S1 E2\nM30\nN1 G01 Z-10\nN2 X30 Z-20",
         Alarm::FagorCyclePosition, "\"line\":3"},
        // [part 2, 9.3]
        {"G152\nG00 X20 Z5\nG69 X30 Z-10 C2 S1 E2\nM30\nN1 G01 X20\nN2 X10 Z0",
         Alarm::FagorCyclePosition, "\"line\":3"},
        // [part 2, 1] hundredths, whole ones
        {"G83 X0 Z0 I20 B5 K1.5", Alarm::PointForbidden, "\"column\":18"},
        {"G88 X30 Z0 Q20 R-5 C2 K1.5", Alarm::PointForbidden, "\"line\":1"},
        {"G89 X30 Z0 Q20 R-5 C2 K1.5", Alarm::PointForbidden, "\"line\":1"},
        // [part 2, 9.9.5] 0 or 1
        {"G86 X30 Z0 Q30 R-20 I1 B0.2 C1 U2", Alarm::FagorValueRange, "U"},
        {"G152\nG00 X10 Z10\nG20 K1 X0 Z0\nG21 K1 X5 Z5\nG22 K1 S1\nX1 Z1", Alarm::FagorZoneEntered,
         "\"line\":6"},
    };
    for (const Refusal& row : rows) {
        const Played played = play(row.program, fagor());
        const std::string number(alarm_number(row.alarm, Dialect::Fagor));
        EXPECT_TRUE(played.has({"\"ev\":\"alarm\"", number, std::string(row.place)}))
            << row.program << "\n"
            << played.events;
    }
}

// The tip, not the centre of the nose, is what a program sees (8.2); a rapid move leaves the cut
// the radius before its end. [5.2.2] no error of G95 is named, and the PLC may start the spindle:
// the block is read, and check says once what it does not know.
TEST(FagorBlock, FeedPerRevolutionWaitsForASpindle) {
    const Played played = play("G152 G95\nG01 X10 Z0 F0.2\nZ-5", fagor());
    EXPECT_EQ(points(played), "10,0 10,-5");
    EXPECT_EQ(played.errors, 0u) << played.events;
    EXPECT_TRUE(played.has({"\"ev\":\"alarm\"", "\"severity\":\"warning\""})) << played.events;
}

TEST(FagorCompensation, BeginsAndEndsWhereItStands) {
    Play how = fagor({"FG.COMPMODE=1"});
    const auto with_nose = [&](std::string_view program, double tip) {
        return points(play(program, how, [tip](MachineView& view) {
            view.store->offsets[1].geometry_r = 2;
            view.store->offsets[1].tip = tip;
        }));
    };
    EXPECT_EQ(with_nose("G152\nT1 D1\nG00 X10 Z20\nG41 G01 X10 Z20 F100\nZ0\nG40 Z0\nX20", 0),
              "10,20 8,20 8,0 10,0 20,0");
    EXPECT_EQ(with_nose("G152\nT1 D1\nG00 X10 Z20\nG42 G01 X10 Z20 F100\nZ0\nG40 G00 X30", 0),
              "10,20 12,20 12,2 30,0");
    EXPECT_EQ(with_nose("G152\nT1 D1\nG00 X10 Z20\nG42 G01 X10 Z20 F100\nZ0\nG40 G00 X30", 3),
              "10,20 10,18 10,0 30,0");
    // [8.2.7] Behind an arc the nose touches the perpendicular too, on its own circle: 8 about X30
    // Z-15, and 12.
    for (const auto& [arc, end] : {std::pair{"G02 X30 Z-25 R10", "28,-22.745967"},
                                   std::pair{"G03 X10 Z-25 R10", "12,-26.83216"}}) {
        const std::string all =
            with_nose(std::string("G152\nT1 D1\nG00 X60 Z10\nG42 G01 X20 Z2 F100\nZ-15\n") + arc +
                          "\nG00 X60 Z10\nG40",
                      0);
        EXPECT_NE(all.find(end), std::string::npos) << arc << ": " << all;
    }
}

Played with_round_nose(std::string_view contour) {
    const std::string program =
        "G18 G71 G90 G94 G152\nT1 D1\nG0 X60 Z40\n" + std::string(contour) + "\nG40 X80\nM30\n";
    return play(program, fagor({"FG.COMPMODE=2"}), [](MachineView& view) {
        view.store->offsets[1].geometry_r = 2;
        view.store->offsets[1].tip = 0;
    });
}

// [8.2.3, 8.2.5] modal: the side that is active already begins nothing anew, an inner corner stays
// the intersection.
TEST(FagorCompensation, TheSameSideAgainChangesNothing) {
    const std::string as_ever = "60,40 32,10 32,-18 60,-18 80,-20";
    EXPECT_EQ(points(with_round_nose("G42 G1 X30 Z10 F100\nZ-20\nX60")), as_ever);
    EXPECT_EQ(points(with_round_nose("G42 G1 X30 Z10 F100\nG42 Z-20\nG42 X60")), as_ever);
    EXPECT_EQ(points(with_round_nose("G42 G1 X30 Z10 F100\nG42\nZ-20\nG42\nX60")), as_ever);
}

// [8.3] an axis beside the plane ends no search, and moves where its block is left out.
TEST(FagorCompensation, ALoopMayHaveBlocksOfOtherAxes) {
    const std::string contour = "G42 N5 G1 X30 Z10 F100\nZ0\nX29\nZ-1\nX30\nZ-20";
    const Played plain = with_round_nose(contour);
    EXPECT_EQ(plain.errors, 0u) << plain.events;
    const Played turned =
        with_round_nose("G42 N5 G1 X30 Z10 F100\nZ0\nX29 C30\nZ-1\nX30 C60\nZ-20");
    EXPECT_EQ(turned.errors, 0u) << turned.events;
    EXPECT_EQ(points(turned), "60,40 32,10 32,0 32,0 32,0 32,-20 80,-20");
    EXPECT_TRUE(turned.has({"\"ev\":\"move\"", "\"C\":30"})) << turned.events;
    EXPECT_TRUE(turned.has({"\"ev\":\"move\"", "\"C\":60"})) << turned.events;
    EXPECT_TRUE(turned.has(
        {"\"ev\":\"alarm\"", std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))}))
        << turned.events;
}

// [8.3] a groove that the nose does not fit into is left out, with one warning, however deep it is.
TEST(FagorCompensation, AGrooveNarrowerThanTheNoseIsPassedOver) {
    for (const char* groove : {"X25\nZ-2\nX30", "X28\nZ-2\nX30", "X25 Z-1\nX30 Z-2"}) {
        const Played played =
            with_round_nose("G42 N10 G1 X30 Z10 F100\nZ0\n" + std::string(groove) + "\nZ-20");
        EXPECT_EQ(played.errors, 0u) << played.events;
        EXPECT_EQ(points(played), "60,40 32,10 32,0 32,-20 80,-20") << groove;
        unsigned warnings = 0;
        for (const std::string& line : played.lines())
            warnings +=
                line.find(std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))) !=
                std::string::npos;
        EXPECT_EQ(warnings, 1u) << played.events;
    }
    const Played shoulder = with_round_nose("G42 N10 G1 X28 Z10 F100\nZ0\nX24\nZ-2\nX31\nZ-20");
    EXPECT_EQ(points(shoulder), "60,40 30,10 30,0 33,0 33,-20 80,-20") << shoulder.events;
    const Played flat = with_round_nose("G42 N10 G1 X30 Z10 F100\nZ0\nX29\nZ-10\nX30\nZ-20");
    EXPECT_EQ(points(flat), "60,40 32,10 32,-2 31,-2 31,-8 32,-8 32,-20 80,-20") << flat.events;
}

// [5.5] the flags of the M table: 1 nobody waits for AUXEND.
struct ToldFunctions final : QuietSink {
    std::vector<std::string> with_wait, without;
    void aux(const Aux& a, const BlockContext&) override {
        (a.beside ? without : with_wait).emplace_back(a.text);
    }
};

TEST(FagorFunctions, AreWaitedForUnlessTheTableSaysNot) {
    const auto table =
        lathe({"FG.MFUN[0] L1=21", "FG.MFLAGS[0] L1=1", "FG.MFUN[1] L1=22", "FG.MFLAGS[1] L1=0"});
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    ToldFunctions told;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text("M21\nM22\nM23\nM30\n", "test.nc");
    const auto language = make_language("fagor", view, told, port, files);
    ASSERT_TRUE(language->start(*main).ok());
    language->core().start_at_machine(view.start);
    run_to_end(*language);
    EXPECT_EQ(told.without, std::vector<std::string>{"M21"});
    EXPECT_EQ(told.with_wait, (std::vector<std::string>{"M22", "M23"}));
}

// [8.3] what does not fit is the rounding or chamfer at the end of the block: the block itself is
// driven, up to the corner.
TEST(FagorCompensation, ACornerElementSmallerThanTheNoseIsLeftOutAlone) {
    for (const char* element : {"G36 R1", "G39 R1"}) {
        const Played played =
            with_round_nose("G42 N5 G1 X30 Z10 F100\n" + std::string(element) + " Z-20\nX60");
        EXPECT_EQ(points(played), "60,40 32,10 32,-18 60,-18 80,-20") << element << played.events;
        EXPECT_TRUE(played.has(
            {"\"line\":5", std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))}))
            << played.events;
    }
    EXPECT_TRUE(with_round_nose("G42 N5 G1 X30 Z10 F100\nG36 R3 Z-20\nX60").has({"\"radius\":1"}));
}

// [part 2, 9.1.2] a rounding may stand in a line between the two of its corner; part and blank.
TEST(FagorProfile, TakesARoundingBetweenItsBlocks) {
    const auto cut = [](const char* first) {
        return points(play(
            "G18 G71 G90 G94 G152\nT1 D1\nG0 X60 Z4 F100\n"
            "G68 X20 Z0 C4 D1 L0.5 M0.5 F50 S100 E110\n"
            "M30\n" +
                std::string(first) + "\nG01 X40 Z-15\nG01 Z-30\nG00 X50 Z0\nN110 G01 X50 Z-30\n",
            fagor()));
    };
    const std::string together = cut("N100 G01 G36 R2 X20 Z-15");
    EXPECT_NE(together.find("20.5,-12.5 22.5,-14.5"), std::string::npos) << together;
    EXPECT_EQ(cut("N100 G01 X20 Z-15 ; to the shoulder\nG36 R2"), together);
}

// [part 2, 9.1.5] an inner radius that the nose does not fit into is closed, with a warning, before
// anything is cut.
TEST(FagorProfile, IsClosedForTheNoseOfTheFinishingPass) {
    const auto finished = [](const char* code, const char* corner) {
        const std::string program =
            "G18 G71 G90 G94 G152\nT1 D1\nG0 X60 Z4 F100\n" + std::string(code) + " X20 Z0 " +
            (code == std::string("G66") ? "I8 C4" : "C4 D1") +
            " L0.5 M0.5 H80 S10 E20\nM30\nN10 G1 " + corner + "\nX40\nN20 G1 Z-20\n";
        Played played = play(program, fagor(), [](MachineView& view) {
            view.store->offsets[1].geometry_r = 2;
            view.store->offsets[1].tip = 0;
        });
        std::string compensated;
        for (const std::string& line : played.lines())
            if (line.find("\"comp\"") != std::string::npos)
                compensated +=
                    line.substr(line.find("\"pos\""),
                                line.find("}", line.find("\"pos\"")) - line.find("\"pos\"")) +
                    '\n';
        return std::pair{played, compensated};
    };
    for (const char* code : {"G66", "G68", "G69"}) {
        const auto [closed, path] = finished(code, "Z-10\nG2 X21 Z-11 R1\nG1");
        const auto [sharp, same] = finished(code, "Z-11");
        EXPECT_EQ(closed.errors, 0u) << code << closed.events;
        EXPECT_TRUE(
            closed.has({std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))}))
            << code << closed.events;
        EXPECT_FALSE(
            sharp.has({std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))}))
            << code;
        EXPECT_FALSE(path.empty()) << code << closed.events;
        EXPECT_EQ(path, same) << code;
    }
}

// [part 2, 9.6.1] H is how far the tool goes back, though the approach point is nearer.
TEST(FagorCycle, APeckGoesBackAsFarAsItsWordSays) {
    EXPECT_EQ(points(play("G152\nM3 S100\nG00 X0 Z30 F100\nG83 X0 Z0 I10 B5 D2 H9", fagor())),
              "0,30 0,2 0,-5 0,4 0,-4 0,-10 0,2");
}

// [part 2, 9.6.3, 11.2.14] a rigid tap ends with the spindle stopped by M05; a floating one has its
// direction again.
TEST(FagorCycle, MStatesTellHowATapLeavesTheSpindle) {
    const auto state = [](std::string_view kind, std::string_view name) {
        Play how = fagor();
        // its position loop can be closed
        how.sets.insert(how.sets.end(), {"N0608 S1=4096", "N0823 S1=29"});
        const Played played = play("G95\nM3 S100 F1\nG00 X0 Z30\nG83 X0 Z0 I10 B0 R" +
                                       std::string(kind) + "\n(P100=" + std::string(name) + ")",
                                   how);
        return played.has({"\"name\":\"P100\"", "\"value\":1}"});
    };
    for (const char* kind : {"1", "2"}) {
        EXPECT_TRUE(state(kind, "MS5")) << kind;
        EXPECT_FALSE(state(kind, "MS3")) << kind;
        EXPECT_FALSE(state(kind, "MS19")) << kind;
    }
    EXPECT_TRUE(state("0", "MS3"));
    EXPECT_FALSE(state("0", "MS5"));
}

// [part 2, 9.1.2] where a level is the surface of the blank there is nothing to cut; on a slope of
// it the pass begins there.
TEST(FagorProfile, APassAlongTheSurfaceOfTheBlankIsLeftOut) {
    const auto cut = [](const char* blank) {
        return points(
            play("G18 G71 G90 G94 G152\nG0 X30 Z5 F100\nG68 X10 Z0 C2 D0 S10 E20\n"
                 "M30\nN10 G01 Z-20\nG01 X20\n" +
                     std::string(blank),
                 fagor()));
    };
    EXPECT_EQ(cut("G00 X14 Z0\nN20 G01 Z-20"),
              "30,5 12,5 12,0 12,-20 12,5 10,5 10,0 10,-20 10,5 30,5");
    EXPECT_EQ(cut("G00 X12 Z0\nG01 Z-20\nN20 G01 X16"), "30,5 10,5 10,0 10,-20 10,5 30,5");
    EXPECT_EQ(cut("G00 X12 Z-10\nN20 G01 X14 Z-20"),
              "30,5 12,5 12,-10 12,-20 12,5 10,5 10,-10 10,-20 10,5 30,5");
}

// [part 2, 9.9] A has no limit but that of a flank: 60 degrees to the X axis are allowed.
TEST(FagorCycle, AThreadTakesAWideAngle) {
    const char* const thread = "G152\nM3 S100\nG00 X20 Z5\nG86 X10 Z0 Q10 R-20 I1 B1 C2 L-0.1 A";
    EXPECT_TRUE(
        play(std::string(thread) + "60", fagor()).has({"\"kind\":\"rapid\"", "\"Z\":-1.558846"}));
    EXPECT_GT(play(std::string(thread) + "90", fagor()).errors, 0u);
}

// [6.15] no axis is faster than it can, on an arc neither: the part of the circle that is driven
// counts.
TEST(FagorBlock, InverseTimeKeepsToWhatTheAxesCan) {
    const auto feed = [](std::string_view arc) {
        return play("G152\nG00 X10 Z0\nG32 F2000\n" + std::string(arc),
                    fagor({"N0305 A1=3000", "N0305 A2=6000"}))
            .find({"centre"});
    };
    EXPECT_NE(feed("G03 X10 Z0 I-10 K0").find("\"feed\":{\"mode\":\"per_min\",\"value\":3000}"),
              std::string::npos)
        << feed("G03 X10 Z0 I-10 K0");
    // From the abscissa up by 30 degrees only the ordinate is fast; from the top by 30 degrees it
    // does at most half the path's speed.
    // whose end is rounded: 30 degrees and a little
    const std::string slanted = feed("G02 X8.660254 Z5 I-10 K0");
    const std::size_t value = slanted.find("\"per_min\",\"value\":");
    ASSERT_NE(value, std::string::npos) << slanted;
    EXPECT_NEAR(std::stod(slanted.substr(value + 18)), 6000, 0.01) << slanted;
    EXPECT_NE(play("G152\nG00 X10 Z0\nG32 F2\nG03 X10 Z0 I-10 K0", fagor())
                  .find({"centre"})
                  .find("\"mode\":\"inverse_time\",\"value\":2}"),
              std::string::npos);
    EXPECT_TRUE(play("G152\nG72 S2\nG00 X10 Z0\nG32 F2\nG03 X10 Z0 I-10 K0\n(P100=FEED)", fagor())
                    .has({"\"name\":\"P100\"", "\"value\":251.32741"}));
}

// [3.6.2] the polar origin goes to the part zero when the plane changes, and only then.
TEST(FagorBlock, TheSamePlaneKeepsThePolarOrigin) {
    EXPECT_EQ(points(play("G152 G18\nG93 I10 J20\nG18\nG00 R5 Q0", fagor())), "20,15");
    EXPECT_EQ(points(play("G152 G18\nG93 I10 J20\nG17\nG18\nG00 R5 Q0", fagor())), "0,5");
}

// [part 2, 9.1.2; 7.6] a scale acts on what the cycle cuts, once: not on the reading of the
// profile.
TEST(FagorProfile, IsReadAsItIsProgrammedUnderAScale) {
    const auto cut = [](const char* scale, const char* corner) {
        return points(play("G18 G71 G90 G94 G152\n" + std::string(scale) +
                               "\nG0 X30 Z5 F100\nG68 X10 Z0 C10 D0 H50 S10 E20\nM30\nN10 G01 " +
                               corner + " Z-15\nN20 G01 X20",
                           fagor()));
    };
    EXPECT_EQ(cut("G72 X2", ""),
              "60,5 40,5 40,-15 40,5 20,5 20,-15 20,5 60,5 20,5 20,0 20,-15 40,-15 60,-15 60,5");
    EXPECT_EQ(
        cut("G72 Z2", ""),
        "30,10 20,10 20,-30 20,10 10,10 10,-30 10,10 30,10 10,10 10,0 10,-30 20,-30 30,-30 30,10");
    EXPECT_NE(cut("G72 S2", "G36 R2").find("20,-26 24,-30 40,-30"), std::string::npos)
        << cut("G72 S2", "G36 R2");
}

// [8.3; 7.6] the nose is as large as it is: under G72 S it fits into grooves that are wide enough
// when they are cut.
TEST(FagorCompensation, TheSearchForLoopsKnowsTheScale) {
    const auto warned = [](const char* scale, const char* wall) {
        return with_round_nose(std::string(scale) + "\nG42 N9 G1 X30 Z10 F100\nZ-18\nX25\n" + wall +
                               "\nX30\nZ-60")
            .has({std::string(alarm_number(Alarm::FagorProfileHollow, Dialect::Fagor))});
    };
    EXPECT_TRUE(warned("G72 S1", "Z-21"));   // 3 mm, nose 2 mm
    EXPECT_FALSE(warned("G72 S2", "Z-21"));  // 6 mm
    EXPECT_FALSE(warned("G72 S1", "Z-24"));
    EXPECT_TRUE(warned("G72 S0.5", "Z-24"));  // 3 mm
    EXPECT_EQ(with_round_nose("G72 X2\nG42 N5 G1 X15 Z10 F100\nZ-20\nX30").errors, 0u);
}

}  // namespace
}  // namespace polyturn::channels::testing
