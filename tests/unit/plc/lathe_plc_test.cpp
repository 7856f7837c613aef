// The built-in lathe PLC as a table: what the NC shows it, what it answers.
#include "kernel/plc/lathe/lathe_plc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "kernel/plc/plc_api.h"

namespace polyturn::plc {
namespace {

// A machine of two channels, a PLC cycle of 10 ticks of 1 ms; signals go by the names that the PLC
// itself asks for.
class LatheRig : public ::testing::Test {
protected:
    static std::int32_t slot_of(std::vector<std::string>& names, const char* name,
                                std::uint32_t instance) {
        const std::string full = std::string(name) + " " + std::to_string(instance);
        const auto found = std::find(names.begin(), names.end(), full);
        if (found != names.end()) return static_cast<std::int32_t>(found - names.begin());
        names.push_back(full);
        return static_cast<std::int32_t>(names.size() - 1);
    }
    static inline std::vector<std::string> nc_names, plc_names;
    static inline std::map<std::string, double> parameters;

    void SetUp() override {
        nc_names.clear();
        plc_names.clear();
        parameters = {{"PT_TURRET_TIME", 0.3},
                      {"PT_CHUCK_TIME", 0.8},
                      {"PT_TURRET_STATIONS", 12},
                      {"PT_DRIVEN_SPINDLE", 3}};
        restart();
    }
    // A new PLC, with the parameters as they are now; what is not named is 0.
    void restart() {
        nc_names.clear();
        plc_names.clear();
        plc_ = {};
        PolyturnPlcHost host{POLYTURN_PLC_API,
                             16,
                             96,
                             32,
                             256,
                             0.001,
                             [](const char* name, std::uint32_t instance) {
                                 return slot_of(nc_names, name, instance);
                             },
                             [](const char* name, std::uint32_t instance) {
                                 return slot_of(plc_names, name, instance);
                             },
                             [](const char* number, std::uint32_t, double* value) {
                                 const auto found = parameters.find(number);
                                 *value = found == parameters.end() ? 0.0 : found->second;
                                 return 1;
                             },
                             nullptr,
                             nullptr};
        ASSERT_EQ(plc_.resolve(host), nullptr);
        nc_.assign(nc_names.size(), 0);
        plc_out_.assign(plc_names.size(), 0);
        nc("N_MACHINE_ON") = 1;
        for (const unsigned s : {1U, 2U, 3U, 4U}) nc("SN_N0", s) = nc("SN_NS", s) = 1;
        nc("CN_SSEL", 1) = nc("CN_SSEL", 2) = 1;
        run();
    }

    std::int32_t& nc(const char* name, unsigned instance = 1) {
        return nc_.at(static_cast<std::size_t>(slot_of(nc_names, name, instance)));
    }
    std::int32_t plc(const char* name, unsigned instance = 1) {
        return plc_out_.at(static_cast<std::size_t>(slot_of(plc_names, name, instance)));
    }
    std::uint8_t output(std::size_t point) const { return output_.at(point); }

    void run(int cycles = 1) {
        for (int i = 0; i < cycles; ++i) {
            const PolyturnPlcInputs in{cycle_, static_cast<std::int64_t>(cycle_ - 1) * 10,
                                       nc_.data(), input_.data()};
            PolyturnPlcOutputs out{plc_out_.data(), output_.data()};
            plc_.cycle(in, out);
            ++cycle_;
        }
    }
    void m(int code, unsigned channel = 1) {
        nc("CN_MCODE", channel) = code;
        ++nc("CN_MSTR", channel);
        run();
    }
    void t(int code, unsigned channel = 1) {
        nc("CN_TCODE", channel) = code;
        ++nc("CN_TSTR", channel);
        run();
    }
    bool m_done(unsigned channel = 1) { return plc("CP_MFIN", channel) == nc("CN_MSTR", channel); }
    bool t_done(unsigned channel = 1) { return plc("CP_TFIN", channel) == nc("CN_TSTR", channel); }
    // The spindle answers as a real one: flags fall with the command, rise when it is there.
    void spindle(unsigned s, int reached, int stands) {
        nc("SN_NS", s) = reached;
        nc("SN_N0", s) = stands;
    }

    LathePlc plc_;
    std::vector<std::int32_t> nc_, plc_out_;
    std::vector<std::uint8_t> input_ = std::vector<std::uint8_t>(256),
                              output_ = std::vector<std::uint8_t>(256);
    std::uint64_t cycle_ = 1;
};

TEST_F(LatheRig, CodesThatMoveNothingAreFinishedInTheSameCycle) {
    for (const int code : {0, 1, 2, 30, 8, 9, 41, 98, 500}) {
        SCOPED_TRACE(code);
        m(code);
        EXPECT_TRUE(m_done());
    }
    ++nc("CN_SSTR");
    run();
    EXPECT_EQ(plc("CP_SFIN"), nc("CN_SSTR"));
    EXPECT_EQ(plc("CP_FIN"), 10) << "nine M codes and one S code";
}

TEST_F(LatheRig, SpindleCodeIsFinishedAtOnce) {
    // the other way without a stop waits for the kernel: a test of its own
    for (const int code : {3, 5, 4, 5}) {
        SCOPED_TRACE(code);
        spindle(1, 0, 0);
        m(code);
        EXPECT_EQ(plc("SP_ROT", 1), code);
        EXPECT_TRUE(m_done()) << "a feed waits for the speed, the code does not";
    }
}

TEST_F(LatheRig, SpindleThatDoesNotComeIntoPositionIsReported) {
    m(19);
    run(1499);
    EXPECT_EQ(plc("PLC_ALARM"), kNoMessage);
    run(1);
    EXPECT_EQ(plc("PLC_ALARM"), kSpindleTooSlow);
    EXPECT_FALSE(m_done());
}

TEST_F(LatheRig, LoopIsClosedByItsOwnCodeAndStatesOfTheBuilderGoIntoTheRegister) {
    parameters["N0823"] = 24;
    parameters["N0689"] = 20;
    parameters["N0690"] = 23;
    restart();
    m(24);
    EXPECT_EQ(plc("SP_ROT", 1), 24);
    EXPECT_EQ(plc("SP_OREQ", 1), 1);
    EXPECT_FALSE(m_done());
    nc("SN_INPOS", 1) = 1;
    run(3);
    EXPECT_TRUE(m_done());
    m(21);
    EXPECT_EQ(plc("SP_ROT", 1), 21);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, GearRangeEngagesAtCreepSpeed) {
    parameters["PT_GEAR_RANGES"] = 2;
    parameters["PT_GEAR_TIME"] = 0.5;
    restart();
    m(3);
    m(42);
    spindle(1, 0, 0);
    EXPECT_EQ(plc("SP_PAR", 1), 1);
    run(20);
    EXPECT_EQ(plc("SP_RANGE", 1), 1) << "it does not creep yet";
    spindle(1, 1, 0);
    run(50);
    EXPECT_EQ(plc("SP_RANGE", 1), 1);
    EXPECT_FALSE(m_done());
    run(2);
    EXPECT_EQ(plc("SP_RANGE", 1), 2);
    EXPECT_EQ(plc("SP_PAR", 1), 0);
    EXPECT_TRUE(m_done());
    m(44);
    EXPECT_TRUE(m_done()) << "no such range: nobody's code";
    EXPECT_EQ(plc("SP_RANGE", 1), 2);
}

TEST_F(LatheRig, AutomaticRangeIsTheLowestThatGivesTheSpeed) {
    parameters["PT_GEAR_RANGES"] = 3;
    parameters["N0650"] = 500;
    parameters["N0651"] = 1500;
    parameters["N0652"] = 4000;
    restart();
    m(40);
    for (const auto& [rpm, range] :
         {std::pair{400, 1}, std::pair{1500, 2}, std::pair{1501, 3}, std::pair{9000, 3}}) {
        nc("CN_SCODE") = rpm;
        ++nc("CN_SSTR");
        run();
        EXPECT_EQ(plc("SP_RANGE", 1), range) << rpm;
    }
}

TEST_F(LatheRig, HelpersTakeTheirTimeAndRefuseWhatIsDangerous) {
    parameters["PT_M_TAILSTOCK"] = 25;
    parameters["PT_TAILSTOCK_TIME"] = 0.2;
    parameters["PT_M_CATCHER"] = 60;
    parameters["PT_CATCHER_TIME"] = 0.1;
    restart();
    m(25);
    EXPECT_EQ(output(kTailstockOut), 1);
    run(19);
    EXPECT_FALSE(m_done());
    run(1);
    EXPECT_TRUE(m_done());
    spindle(1, 1, 0);
    m(3);
    m(26);
    EXPECT_EQ(plc("PLC_ALARM"), kTailstockTurning);
    ++nc("CN_RESET");
    run();
    m(26);
    run(50);
    EXPECT_EQ(output(kTailstockOut), 1) << "the spindle is still coming to rest";
    spindle(1, 1, 1);
    run(22);
    EXPECT_TRUE(m_done());
    EXPECT_EQ(output(kTailstockOut), 0);
    m(60);
    run(10);
    EXPECT_EQ(output(kCatcherOut), 1);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, BarFeedOpensTheChuckFeedsAndClamps) {
    parameters["PT_M_BAR"] = 35;
    parameters["PT_BAR_TIME"] = 0.5;
    parameters["PT_IN_BAR"] = 7;
    restart();
    m(35);
    EXPECT_EQ(plc("PLC_ALARM"), kBarEnd);
    EXPECT_EQ(plc("CP_BAREND"), 1);
    ++nc("CN_RESET");
    input_[6] = 1;
    run();
    m(35);
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckOpen), 1);
    EXPECT_EQ(plc("SP_UNCLAMPED", 1), 1);
    run(80);
    EXPECT_EQ(output(kBarFeeds), 1);
    run(50);
    EXPECT_EQ(output(kBarFeeds), 0);
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckClamp), 1);
    EXPECT_FALSE(m_done());
    run(80);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, ChuckWaitsForASpindleThatStops) {
    spindle(1, 1, 0);
    m(3);
    m(5);
    m(11);
    run(50);
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckOpen), 0);
    spindle(1, 1, 1);
    run(2);
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckOpen), 1);
    run(80);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, SpindleNeitherTurnsAsAnAxisNorWithTheDoorOpenNorWithoutPressure) {
    parameters["PT_M_C_AXIS"] = 30 + 70;
    parameters["PT_IN_DOOR"] = 1;
    parameters["PT_IN_CHUCK"] = 2;
    restart();
    m(3);
    EXPECT_EQ(plc("PLC_ALARM"), kNoPressure);
    EXPECT_EQ(plc("SP_UNCLAMPED", 1), 1);
    ++nc("CN_RESET");
    input_[1] = 1;
    run();
    m(3);
    EXPECT_EQ(plc("PLC_ALARM"), kDoorOpen);
    EXPECT_EQ(plc("CP_DOOROPEN"), 1);
    ++nc("CN_RESET");
    input_[0] = 1;
    run();
    m(100);
    run(3);
    EXPECT_TRUE(m_done());
    EXPECT_EQ(plc("SP_SDETCHR", 1), 1);
    m(3);
    EXPECT_EQ(plc("PLC_ALARM"), kSpindleIsAxis);
    ++nc("CN_RESET");
    run();
    m(101);
    run(3);
    m(3);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, SpindleOfTheChannelIsChosenByCode) {
    parameters["PT_M_SPINDLE"] = 70;
    restart();
    m(71);
    EXPECT_EQ(plc("CP_SSEL"), 2);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, ValidCodeOfAGroupIsShown) {
    parameters["N1342"] = 51;
    parameters["N1358"] = 53;
    restart();
    m(52);
    EXPECT_EQ(plc("CP_MGR2"), 52);
    m(60);
    EXPECT_EQ(plc("CP_MGR2"), 52);
}

TEST_F(LatheRig, AxisThatHasTravelledItsDistanceIsLubricated) {
    parameters["PT_LUBE_TIME"] = 0.3;
    parameters["N0002"] = 1;
    restart();
    nc("AN_LUBR", 4) = 1;
    run();
    nc("AN_LUBR", 4) = 0;
    EXPECT_EQ(output(kLubricates), 1);
    run(29);
    EXPECT_EQ(output(kLubricates), 1);
    run(2);
    EXPECT_EQ(output(kLubricates), 0);
}

TEST_F(LatheRig, TurretMayBeOneThatTurnsForwardsOnlyAndMustBeLocked) {
    parameters["PT_TURRET_FORWARD"] = 1;
    parameters["PT_TURRET_CLAMP"] = 0.2;
    restart();
    t(12);
    int cycles = 1;
    for (; !t_done() && cycles < 1000; ++cycles) run();
    EXPECT_EQ(cycles, 1 + 30 * 11 + 20);
}

TEST_F(LatheRig, OrientationClosesTheLoopAndEndsInPosition) {
    m(19);
    EXPECT_EQ(plc("SP_ROT", 1), 19);
    EXPECT_EQ(plc("SP_OREQ", 1), 1);
    run(20);
    EXPECT_FALSE(m_done());
    nc("SN_INPOS", 1) = 1;
    run();
    EXPECT_TRUE(m_done());
    m(5);
    EXPECT_EQ(plc("SP_OREQ", 1), 0);
}

TEST_F(LatheRig, SelectedSpindleIsTheChannelsOwnChoice) {
    nc("CN_SSEL", 2) = 2;
    m(3, 1);
    m(4, 2);
    EXPECT_EQ(plc("SP_ROT", 1), 3);
    EXPECT_EQ(plc("SP_ROT", 2), 4);
}

// A cut behind it must not see the old direction taken away from under it.
TEST_F(LatheRig, AReversalIsFinishedWhenTheKernelHasHeardOfIt) {
    m(3);
    EXPECT_TRUE(m_done());
    m(4);
    EXPECT_EQ(plc("SP_ROT", 1), 4);
    EXPECT_FALSE(m_done());
    run(3);
    EXPECT_TRUE(m_done());
    m(4);
    EXPECT_TRUE(m_done());
}

TEST_F(LatheRig, DrivenToolHasItsOwnCodesAndSpindle) {
    m(3);
    m(14);
    EXPECT_EQ(plc("SP_ROT", 1), 3);
    EXPECT_EQ(plc("SP_ROT", 3), 4);
    m(15);
    EXPECT_EQ(plc("SP_ROT", 1), 3);
    EXPECT_EQ(plc("SP_ROT", 3), 5);
}

TEST_F(LatheRig, TurretTakesTheShorterWay) {
    // from the row before, 12 stations, 0.3 s each = 30 cycles
    struct Row {
        int station;
        int steps;
    };
    for (const Row& row :
         {Row{1, 0}, Row{3, 2}, Row{12, 3}, Row{6, 6}, Row{6, 0}, Row{0, 0}, Row{5, 1}}) {
        SCOPED_TRACE(row.station);
        t(row.station);
        int cycles = 1;
        for (; !t_done() && cycles < 1000; ++cycles) run();
        EXPECT_EQ(cycles, 1 + 30 * row.steps);
        EXPECT_TRUE(row.station == 0 || plc("CP_ACTT") == row.station);
        EXPECT_EQ(output(kTurretLocked), 1);
    }
}

// 24 positions: 1 to 12 are the stations, 13 to 24 lie behind them; half a station takes half the
// time.
TEST_F(LatheRig, TurretStopsAtHalfStationsToo) {
    parameters["PT_TURRET_HALF"] = 1;
    parameters["PT_TURRET_STATIONS"] = 24;
    restart();
    // from the row before
    struct Row {
        int station;
        int half_steps;
    };
    for (const Row& row : {Row{13, 1}, Row{2, 1}, Row{24, 3}, Row{1, 1}, Row{7, 12}}) {
        SCOPED_TRACE(row.station);
        t(row.station);
        int cycles = 1;
        for (; !t_done() && cycles < 1000; ++cycles) run();
        EXPECT_EQ(cycles, 1 + 15 * row.half_steps);
        EXPECT_EQ(plc("CP_ACTT"), row.station);
    }
}

TEST_F(LatheRig, TurretGoesToThePotWhereToolManagementHasFoundTheTool) {
    // its pots count from 101
    parameters["PT_TURRET_MAGAZINE"] = 2;
    parameters["N2907"] = 101;
    restart();
    nc("CN_MGZNO") = 2;
    nc("CN_POTNO") = 104;
    t(35);  // a type number, no station
    run(90);
    EXPECT_TRUE(t_done());
    EXPECT_EQ(plc("CP_ACTT"), 4);
    // stands elsewhere: the turret stays
    nc("CN_MGZNO") = 1;
    nc("CN_POTNO") = 7;
    t(36);
    EXPECT_TRUE(t_done());
    EXPECT_EQ(plc("CP_ACTT"), 4);
    nc("CN_MGZNO") = 0;  // no tool management: T is the station
    t(5);
    run(30);
    EXPECT_TRUE(t_done());
    EXPECT_EQ(plc("CP_ACTT"), 5);
}

TEST_F(LatheRig, KeySwitchShowsItsHighestInput) {
    parameters["PT_IN_KEY"] = 10;
    restart();
    EXPECT_EQ(plc("PLC_KEY"), 0);
    input_[9] = 1;
    run();
    EXPECT_EQ(plc("PLC_KEY"), 1);
    input_[11] = 1;
    run();
    EXPECT_EQ(plc("PLC_KEY"), 3);
}

TEST_F(LatheRig, TurretsOfTwoChannelsTurnIndependently) {
    t(2, 1);
    t(3, 2);
    EXPECT_EQ(output(0 * kOutputsPerChannel + kTurretTurns), 1);
    EXPECT_EQ(output(1 * kOutputsPerChannel + kTurretTurns), 1);
    run(31);
    EXPECT_TRUE(t_done(1));
    EXPECT_FALSE(t_done(2));
    run(30);
    EXPECT_TRUE(t_done(2));
}

TEST_F(LatheRig, StationThatTheTurretDoesNotHaveIsRefusedUntilReset) {
    t(13);
    run(1000);
    EXPECT_FALSE(t_done());
    EXPECT_EQ(plc("PLC_ALARM"), kNoSuchStation);
    ++nc("CN_RESET");
    run();
    EXPECT_EQ(plc("PLC_ALARM"), kNoMessage);
    EXPECT_TRUE(t_done());
    t(2);
    run(30);
    EXPECT_TRUE(t_done());
}

TEST_F(LatheRig, ChuckOpensOnlyAtStandstillAndTakesItsTime) {
    m(11);
    run(79);
    EXPECT_FALSE(m_done());
    run(1);
    EXPECT_TRUE(m_done());
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckOpen), 1);
    m(3);
    EXPECT_EQ(plc("PLC_ALARM"), kTurningWhileOpen);
    EXPECT_EQ(plc("SP_ROT", 1), 5);
    ++nc("CN_RESET");
    run();
    m(10);
    run(80);
    EXPECT_TRUE(m_done());
    m(3);
    spindle(1, 1, 0);
    run(5);
    EXPECT_TRUE(m_done());
    m(11);
    run(200);
    EXPECT_FALSE(m_done());
    EXPECT_EQ(plc("PLC_ALARM"), kChuckWhileTurning);
    EXPECT_EQ(output(kFirstSpindleOutput + kChuckClamp), 1);
}

TEST_F(LatheRig, EndOfProgramStopsWhatTheChannelStartedAndNothingElse) {
    m(8, 2);
    m(8, 1);
    m(3, 1);
    m(30, 2);
    EXPECT_EQ(plc("SP_ROT", 1), 3) << "L1 started it";
    EXPECT_EQ(output(1 * kOutputsPerChannel + kCoolant), 0);
    EXPECT_EQ(output(0 * kOutputsPerChannel + kCoolant), 1);
    m(30, 1);
    EXPECT_EQ(plc("SP_ROT", 1), 5);
    EXPECT_EQ(output(kCoolant), 0);
}

TEST_F(LatheRig, ResetAnswersWhatWasPendingAndStopsTheSpindle) {
    m(19);
    run(10);
    EXPECT_FALSE(m_done());
    ++nc("CN_RESET");
    run();
    EXPECT_TRUE(m_done());
    EXPECT_EQ(plc("SP_ROT", 1), 5);
    EXPECT_EQ(plc("SP_OREQ", 1), 0);
}

TEST_F(LatheRig, EmergencyStopStopsEverythingAndTheTurretHalts) {
    m(3);
    m(8);
    t(5);
    run(35);  // one station passed
    nc("N_ESTOP") = 1;
    run(100);
    EXPECT_EQ(plc("SP_ROT", 1), 5);
    EXPECT_EQ(output(kCoolant), 0);
    EXPECT_EQ(output(kTurretTurns), 0);
    EXPECT_EQ(plc("CP_ACTT"), 2);
    EXPECT_FALSE(t_done()) << "the turret is not where the program wants it";
    nc("N_ESTOP") = 0;
    ++nc("CN_RESET");
    run();
    t(5);
    run(90);
    EXPECT_TRUE(t_done());
    EXPECT_EQ(plc("CP_ACTT"), 5);
}

TEST_F(LatheRig, NoSpindleSelectedIsSaid) {
    nc("CN_SSEL") = 0;
    m(3);
    run(10);
    EXPECT_FALSE(m_done());
    EXPECT_EQ(plc("PLC_ALARM"), kNoSpindle);
}

}  // namespace
}  // namespace polyturn::plc
