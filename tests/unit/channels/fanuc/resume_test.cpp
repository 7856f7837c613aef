// Reading ahead and coming back: whatever block a channel returns to, what follows is what followed the first time.
#include <gtest/gtest.h>

#include "../play.hpp"

namespace polyturn::channels::testing {
namespace {

constexpr std::string_view kPrograms[] = {
    "O1\nG98 F100\nG0 X10. Z5.\nG1 Z-5.\nX12.\nX14. Z-7.\nG2 X20. Z-10. R3.\nG0 X50.\nM30\n",
    "G0 X10. Z0 T0101\nX12.\nT0202\nX14.\nS500 M3\nG99 G1 X5. F0.1\nZ-3.\nG32 Z-9. F1.\nZ-12.\nG0 X30.\nM30\n",
    "#100=1\nWHILE[#100 LE 4]DO1\nG0 X#100\n#100=#100+1\nEND1\n#500=#100*2\nG0 Z#500\nG10 P1 X5.\n#101=#2001\nM30\n",
    "G0 X1.\nM98 P20002\nG65 P3 A2. L2\nX9.\nM30\nO2\nU1.\n#101=#101+1\nM99\nO3\n#1=#1+1\nG0 Z#1\nM99\n",
    "G66 P2 A1.\nG0 X5.\nX6. ; Z3.\nG67\nX7.\nM30\nO2\nG1 G98 W-#1 F50\nM99\n",
    "G50 X50. Z20.\nG98 F80\nG90 X40. Z-5.\nX38.\nX36.\nG55 G0 X50.\nM30\n",
    "%\nO7\nG0 C30.\nC400.\nH-50.\nG17\nG83 Z-9. R-1. Q2000 F20 G98\nG80\nM30\n%\n",
};

class SerialSink final : public Sink {
public:
    explicit SerialSink(EventScene scene) : events_(scene, text_, true, 0) {}
    std::vector<std::pair<std::uint64_t, std::string>> events;

    void move(const Move& m, const BlockContext& at) override { events_.move(m, at), take(at); }
    void dwell(const Dwell& d, const BlockContext& at) override { events_.dwell(d, at), take(at); }
    void aux(const Aux& a, const BlockContext& at) override { events_.aux(a, at), take(at); }
    void spindle(const Spindle& s, const BlockContext& at) override { events_.spindle(s, at), take(at); }
    void wait(const Wait& w, const BlockContext& at) override { events_.wait(w, at), take(at); }
    void variable(const Variable& v, const BlockContext& at) override { events_.variable(v, at), take(at); }
    void offset(const OffsetWrite& o, const BlockContext& at) override { events_.offset(o, at), take(at); }
    void message(std::string_view t, const BlockContext& at) override { events_.message(t, at), take(at); }
    void stop(const Stop& s, const BlockContext& at) override { events_.stop(s, at), take(at); }
    void part(double c, const BlockContext& at) override { events_.part(c, at), take(at); }
    void alarm(const Diagnosis& d, const BlockContext& at) override { events_.alarm(d, at), take(at); }
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}

private:
    void take(const BlockContext& at) {
        if (!text_.empty()) events.emplace_back(at.serial, text_);
        text_.clear();
    }
    std::string text_;
    EventSink events_;
};

// Reads `ahead` blocks, goes back to block `back` (0: never), reads to the end.
std::vector<std::pair<std::uint64_t, std::string>> run(std::string_view text, std::uint64_t ahead, std::uint64_t back) {
    const auto table = lathe({"N0107 A5=3", "N0108 A5=360"});
    MachineView view = make_machine_view(*table, 1);
    view.store->offsets[1].wear[0] = 0.5;
    const text::Setup setup;
    ProgramFiles files;
    SerialSink sink({&view, &files, Dialect::Fanuc});
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(text, "t");
    const auto interpreter = make_fanuc(view, sink, port, files);
    EXPECT_TRUE(interpreter->start(*main).ok());
    interpreter->keep_resume_states(true);
    bool went_back = back == 0;
    for (int steps = 0; steps < 2000; ++steps) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier) interpreter->barrier_done();
        if (!went_back && interpreter->core().at.serial >= ahead) {
            went_back = true;
            while (!sink.events.empty() && sink.events.back().first >= back) sink.events.pop_back();
            EXPECT_TRUE(interpreter->resume_at(back));
            continue;
        }
        if (step == Step::Ended || step == Step::Failed) break;
    }
    return sink.events;
}

TEST(ResumeState, LeadsToTheSameEventsFromEveryBlock) {
    for (const std::string_view program : kPrograms) {
        SCOPED_TRACE(std::string(program));
        const auto straight = run(program, 0, 0);
        ASSERT_FALSE(straight.empty());
        EXPECT_EQ(straight.back().second.find("alarm"), std::string::npos) << straight.back().second;
        const std::uint64_t blocks = straight.back().first;
        for (std::uint64_t back = 1; back <= blocks; ++back)
            for (std::uint64_t ahead = back; ahead <= blocks; ahead += 1 + ahead / 8) {
                const auto again = run(program, ahead, back);
                ASSERT_EQ(again, straight) << "from block " << ahead << " back to " << back;
            }
    }
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
