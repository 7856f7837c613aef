// Names of flags and registers: everything that the manuals spell is understood, and a misspelling
// is answered with what was probably meant. Source: nct_parameters_part1 17, nct_parameters_part2
// 37, fagor_8037t_part1 and part2 (marks).
#include "kernel/supervisor/press/signal_words.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace polyturn::supervisor {
namespace {

TEST(SignalWords, EveryNameOfTheManualsIsAccepted) {
    const char* const names[] = {
        "AN_DETCHA A1",  "AP_DETCHR A1",  "SP_SDETCHR S1", "SN_SDETCHA S1", "AP_DIARAD A1",
        "AN_INDP A1",    "AP_OPNR A1",    "AP_OPNA A1",    "AP_EFD A1",     "AP_FLWU A1",
        "AP_END A1",     "AP_DECSW A1",   "AP_RPE A1",     "AP_LIMSELP A1", "AP_LIMSELN A1",
        "AP_LSELN A1",   "AN_OTP A1",     "AN_OTN A1",     "AN_LUBR A1",    "CP_LIMSEL L1",
        "CP_LIM1DIS L1", "CP_LIM2DIS L1", "CP_LIM3DIS L1", "CP_JOGFD L1",   "CP_FIN L1",
        "CP_MGR1 L1",    "CP_MGR9 L1",    "CP_MGR16 L1",   "CP_SGOEN L1",   "CP_SGOX L1",
        "CP_SGOY L1",    "CP_SGOZ L1",    "CN_SSEL L1",    "CN_AUX1C L1",   "CN_AUX2C L1",
        "CN_AUX3C L1",   "SP_ROT S1",     "SP_PAR S1",     "SP_OREQ S1",    "SP_OSW S1",
        "SP_SEND S1",    "SN_NS S1",      "SN_N0 S1",      "SN_FLU S1",     "SN_SINDP S1",
        "N_SW[0]",       "N_SW[31]",      "N_SWN[4]",      "N_SWP[4]",      "N_P00",
        "N_P07",         "N_P70",         "N_P77",         "N_PDW1",        "N_PDW32",
        "N_PDB1",        "N_PDB32",       "AP_SYNCR A6",   "AP_MIXR A3",    "AN_MIXA A3",
        "AP_SPRPNR A3",  "CP_NOWT L2",    "CN_WTNG L2",    "CP_EGBRRQ L1",  "CP_TMREN L1",
        "CP_OFFSNO L1",  "CP_ACTT L1",    "CN_MGZNO L1",   "CN_POTNO L1",   "SN_TLNL S1",
        "SP_ACTT S1",    "MINT L1",       "CP_NOWT[2]",    "AP_SYNCR[A6]",  "BLKSKIP1 L1",
        "BLKSKIP3 L2",   "M01STOP L1",    "AUXEND L1",     "SWITCH1 L1",    "TAPPING L1",
        "M5517 L1",      "INT1 L1",       "INT4 L1",       "M5024 L1",      "M5027 L1",
        "ACTLIM2 L1",    "M5052 L1",      "M5008 L1",      "M5010 L1",      "MACHMOVE L1"};
    for (const char* name : names)
        EXPECT_TRUE(parse_signal(name)) << name << ": " << parse_signal(name).diagnosis().text();
}

TEST(SignalWords, AliasesAndBracketsMeanTheSameSlot) {
    EXPECT_EQ(parse_signal("AP_OPNA A3")->slot(), signals::ap_opnr(3));
    EXPECT_EQ(parse_signal("m5517 l2")->slot(), signals::tapping(2));
    EXPECT_EQ(parse_signal("CP_NOWT[2]")->slot(), signals::cp_nowt(2));
    // the manual counts switches from 1 and flags from 0
    EXPECT_EQ(parse_signal("N_SW[4]")->slot(), signals::n_sw(5));
    EXPECT_EQ(parse_signal("N_P35")->slot(), signals::n_p00() + 3 * 8 + 5);
    EXPECT_EQ(parse_signal("N_PDW3")->slot(), signals::n_pdw1() + 2);
    EXPECT_EQ(parse_signal("N_PDB3")->slot(), signals::n_pdb1() + 4);
}

TEST(SignalWords, EveryRowIsFoundUnderItsOwnNameAndSlotsAreDistinct) {
    std::set<std::pair<SignalWriter, std::uint32_t>> used;
    for (const SignalRow& row : signal_rows()) {
        std::string words(row.name);
        if (row.elements)
            words += "[" + std::to_string(row.first) + "]";
        else if (row.scope != SignalScope::Global)
            words += "[1]";
        const auto found = parse_signal(words);
        ASSERT_TRUE(found) << words;
        EXPECT_TRUE(used.insert({row.writer, found->slot()}).second) << words;
    }
}

TEST(SignalWords, AMisspellingIsAnsweredWithTheNearestName) {
    const std::pair<const char*, const char*> rows[] = {{"CN_WTGN L1", "CN_WTNG"},
                                                        {"AP_SYNC A3", "AP_SYNCR"},
                                                        {"TAPING L1", "TAPPING"},
                                                        {"N_SV[4]", "N_SW"},
                                                        {"BLOCKSKIP1 L1", "BLKSKIP1"}};
    for (const auto& [words, meant] : rows) {
        const auto signal = parse_signal(words);
        ASSERT_FALSE(signal) << words;
        EXPECT_EQ(signal.diagnosis().alarm, Alarm::SignalUnknown);
        EXPECT_NE(signal.diagnosis().text().find(std::string("nearest: ") + meant + ")"),
                  std::string::npos)
            << signal.diagnosis().text();
    }
    const auto nothing = parse_signal("QQQQQQQQQQQQ");
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.diagnosis().text().find("nearest"), std::string::npos);
}

TEST(SignalWords, AWrongScopeSaysWhatIsPossible) {
    for (const char* words : {"N_SW", "N_SW[32]", "N_SW[-1]", "N_SW[]", "N_SW[4", "N_SW L1",
                              "CN_WTNG", "CN_WTNG[0]", "CN_WTNG[17]", "CN_WTNG A1", "CN_WTNG 1",
                              "CN_WTNG L", "PLC_ALARM L1", "N_P00[1]", "SP_ROT S99999999999999"}) {
        const auto signal = parse_signal(words);
        ASSERT_FALSE(signal) << words;
        EXPECT_EQ(signal.diagnosis().alarm, Alarm::SignalScope) << words;
    }
}

}  // namespace
}  // namespace polyturn::supervisor
