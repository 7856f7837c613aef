// G10 L3 ... G11: what a program says of tool life groups is handed on step by step, and what it
// says wrongly is told.
#include <gtest/gtest.h>

#include <sstream>

#include "../play.hpp"
#include "../quiet_sink.hpp"

namespace polyturn::channels::testing {
namespace {

// The steps as short lines: "all", "forget 2", "open 1 uses 30", "tool 1 3/5" (station 3, offset
// 5).
class Steps final : public QuietSink {
public:
    std::ostringstream text;
    void life_group(const LifeGroup& g, const BlockContext&) override {
        switch (g.step) {
            case LifeGroupStep::ForgetAll:
                text << "all\n";
                break;
            case LifeGroupStep::Forget:
                text << "forget " << g.group << "\n";
                break;
            case LifeGroupStep::Open:
                text << "open " << g.group << (g.kind == LifeKind::Minutes ? " minutes " : " uses ")
                     << g.life << "\n";
                break;
            case LifeGroupStep::Tool:
                text << "tool " << g.group << " " << g.station << "/" << g.offset << "\n";
                break;
        }
    }
    void move(const Move&, const BlockContext&) override { text << "move\n"; }
    void aux(const Aux& a, const BlockContext&) override { text << "aux " << a.text << "\n"; }
    void alarm(const Diagnosis& d, const BlockContext&) override {
        text << "alarm " << alarm_number(d.alarm, Dialect::Fanuc) << " line " << d.place.line
             << " column " << d.place.column << "\n";
    }
};

std::string steps_of(std::string_view program) {
    const auto table = lathe({});
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    Steps steps;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(program, "test.nc");
    if (!main) return "no text";
    const auto interpreter = make_language("fanuc", view, steps, port, files);
    (void)interpreter->start(*main).ok();
    interpreter->core().start_at_machine(view.start);
    for (int n = 0; n < 1'000; ++n) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier)
            interpreter->barrier_done();
        else if (step != Step::Continue)
            break;
    }
    return steps.text.str();
}

TEST(LifeGroups, AreHandedOnInTheOrderOfTheProgram) {
    EXPECT_EQ(steps_of("G10 L3\nP1 L30\nT0101\nN7 T0305\nP12 L15.5 Q2\nT1204\nG11\nT0202\nM30\n"),
              "all\nopen 1 uses 30\ntool 1 1/1\ntool 1 3/5\n"
              "open 12 minutes 15.5\ntool 12 12/4\naux T0202\n");
    EXPECT_EQ(steps_of("G10 L3 P1\nP2 L8 Q1\nT0909\nG11\nM30\n"), "open 2 uses 8\ntool 2 9/9\n");
    EXPECT_EQ(steps_of("G10 L3 P2\nP2\nP5\nG11\nM30\n"), "forget 2\nforget 5\n");
}

TEST(LifeGroups, WrongBlocksAreDiagnosedAtTheirPlace) {
    struct Row {
        std::string_view program, end;
    };
    const Row rows[] = {
        {"G10 L3 P3\nM30\n", "alarm PT1508 line 1 column 8\n"},
        {"G10 L3\nT0101\n", "alarm 025 line 2 column 1\n"},  // of no group
        {"G10 L3\nP1 L30 T0101\n", "alarm 025 line 2 column 8\n"},
        {"G10 L3\nP1\n", "alarm PT1508 line 2 column 1\n"},  // no life
        {"G10 L3\nP0 L5\n", "alarm PT1508 line 2 column 1\n"},
        {"G10 L3\nP1 L0\n", "alarm PT1508 line 2 column 4\n"},
        {"G10 L3\nP1 L5 Q3\n", "alarm PT1508 line 2 column 7\n"},
        {"G10 L3\nP1 L5\nT0133\n", "alarm 030 line 3 column 1\n"},
        {"G10 L3\nP1 L5\nT0001\n", "alarm PT1508 line 3 column 1\n"},
        {"G10 L3\nG0 X5.\n", "alarm 009 line 2 column 1\n"},
        {"G10 L3\nM8\n", "alarm 009 line 2 column 1\n"},
        {"G10 L3 P2\nP1 L5\n", "alarm 009 line 2 column 4\n"},
        {"G10 L3 P2\nT0101\n", "alarm 025 line 2 column 1\n"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.program));
        const std::string steps = steps_of(row.program);
        const std::size_t alarm = steps.find("alarm");
        EXPECT_EQ(alarm == std::string::npos ? steps : steps.substr(alarm), row.end);
    }
}

}  // namespace
}  // namespace polyturn::channels::testing
