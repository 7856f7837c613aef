// Reading ahead and coming back: whatever block a channel returns to, what follows is what followed
// the first time.
#include <gtest/gtest.h>

#include "../resume_rig.hpp"

namespace polyturn::channels::testing {
namespace {

constexpr std::string_view kPrograms[] = {
    "O1\nG98 F100\nG0 X10. Z5.\nG1 Z-5.\nX12.\nX14. Z-7.\nG2 X20. Z-10. R3.\nG0 X50.\nM30\n",
    "G0 X10. Z0 T0101\nX12.\nT0202\nX14.\nS500 M3\n"
    "G99 G1 X5. F0.1\nZ-3.\nG32 Z-9. F1.\nZ-12.\n"
    "G0 X30.\nM30\n",
    "#100=1\nWHILE[#100 LE 4]DO1\nG0 X#100\n#100=#100+1\n"
    "END1\n#500=#100*2\nG0 Z#500\nG10 P1 X5.\n"
    "#101=#2001\nM30\n",
    "G0 X1.\nM98 P20002\nG65 P3 A2. L2\nX9.\n"
    "M30\nO2\nU1.\n#101=#101+1\nM99\nO3\n#1=#1+1\n"
    "G0 Z#1\nM99\n",
    "G66 P2 A1.\nG0 X5.\nX6. ; Z3.\nG67\nX7.\nM30\nO2\nG1 G98 W-#1 F50\nM99\n",
    "G50 X50. Z20.\nG98 F80\nG90 X40. Z-5.\nX38.\nX36.\nG55 G0 X50.\nM30\n",
    "%\nO7\nG0 C30.\nC400.\nH-50.\nG17\nG83 Z-9. R-1. Q2000 F20 G98\nG80\nM30\n%\n",
};

TEST(ResumeState, LeadsToTheSameEventsFromEveryBlock) {
    for (const std::string_view program : kPrograms)
        expect_same_events_from_every_block("fanuc", program);
}

TEST(ResumeState, IsForgottenOnceTheBlockIsExecuted) {
    const auto table = lathe({});
    MachineView view = make_machine_view(*table, 1);
    const text::Setup setup;
    ProgramFiles files;
    std::string text;
    EventSink sink({&view, &files, Dialect::Fanuc}, text, true, '\n');
    CheckPort port(setup, 1, true);
    const auto main = files.open_text("G0 X1.\nX2.\nX3.\nX4.\nM30\n", "t");
    const auto interpreter = make_fanuc(view, sink, port, files);
    ASSERT_TRUE(interpreter->start(*main).ok());
    interpreter->keep_resume_states(true);
    for (int k = 0; k < 4; ++k) interpreter->step();
    interpreter->executed(3);
    EXPECT_FALSE(interpreter->resume_at(2));
    EXPECT_FALSE(interpreter->resume_at(9));
}

}  // namespace
}  // namespace polyturn::channels::testing
