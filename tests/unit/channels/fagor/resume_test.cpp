// Reading ahead and coming back in the language fagor.
#include <gtest/gtest.h>

#include "../resume_rig.hpp"

namespace polyturn::channels::testing {
namespace {

constexpr std::string_view kPrograms[] = {
    "G152\nG00 X10 Z5\nG01 Z-5 F100\nX12\nX14 Z-7\nG02 X20 Z-10 R8\nG00 X50\nM30\n",
    "G152\n(P100=1)\nN1 (P100=P100+1)\nG01 XP100 F50\n"
    "(IF (P100 LT 4) GOTO N1)\n(TOX3=P100, PLCR2=7)\n"
    "T3 D3\nX1\n(P101=PLCR2)\nM30\n",
    "G152\nG00 X20 Z0\n(A=4)\n(CALL 71)\n(PCALL 72, A9)\n"
    "(MCALL 73, B2)\nX30 N2\n(MDOFF)\nX40\nM30\n"
    "(SUB 71)\n(A=A+2)\n(RET)\n(SUB 72)\n(A=1)\n"
    "(RET)\n(SUB 73)\n(P105=P105+1)\n(RET)\n",
    "G152\n(OPEN P5)\n(WRITE G01 X3 F10)\n(EXEC P5)\n"
    "(OPEN P5, A)\n(WRITE X4)\n(EXEC P5)\nG54\n"
    "G92 X0\nG00 X1\nN1 G91 X1\nN2 Z1\n(RPT N1, N2) N2\n"
    "M30\n",
    "G151\nS500 M3\nG95 G00 X60 Z10 F0.2\nG81 X30 Z0 Q54 R-24 C4 D1 L0.5 H0.1\n"
    "G83 X0 Z0 I6 B2 D1\nG68 X20 Z0 C5 D1 L0.4 S10 E11\n"
    "X70\nM30\nN10 G01 X20 Z-15\nN11 X50 Z-20\n",
};

TEST(FagorResumeState, LeadsToTheSameEventsFromEveryBlock) {
    for (const std::string_view program : kPrograms)
        expect_same_events_from_every_block("fagor", program);
}

}  // namespace
}  // namespace polyturn::channels::testing
