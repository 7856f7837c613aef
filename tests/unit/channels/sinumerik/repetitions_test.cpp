// Repetitions ask the machine anew: a subprogram that runs several times (L10 P3), a section
// (REPEAT) and a loop see what an input says then, not what it said the first time.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "../play.hpp"
#include "../quiet_sink.hpp"

namespace polyturn::channels::testing {
namespace {

// Barriers that a program waits at.
unsigned barriers_of(const std::string& program, const std::string& subprogram) {
    const auto table = lathe({});
    MachineView view = make_machine_view(*table, 1);
    ProgramFiles files;
    files.add_library(subprogram);
    QuietSink sink;
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(program, "test.nc");
    const auto language = make_language("sinumerik", view, sink, port, files);
    EXPECT_TRUE(language->start(*main).ok());
    language->core().start_at_machine(view.start);
    unsigned count = 0;
    for (int steps = 0; steps < 10'000; ++steps) {
        const Step step = language->step();
        if (step == Step::AtBarrier) {
            ++count;
            language->barrier_done();
        } else if (step != Step::Continue)
            break;
    }
    return count;
}

TEST(SinumerikRepetitions, AskTheMachineAnew) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("L10_" + std::to_string(::getpid())) / "L10.SPF";
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "R1=R1+$A_IN[1]\nM17\n";
    EXPECT_EQ(barriers_of("L10 P4\nM30\n", file),
              barriers_of("AA: R1=R1+$A_IN[1]\nENDLABEL:\nREPEAT AA P=3\nM30\n", file))
        << "one for each repetition";
    EXPECT_EQ(barriers_of("L10 P4\nM30\n", file), 3u);
    EXPECT_EQ(barriers_of("L10\nM30\n", file), 0u) << "a cycle start is a barrier";
    std::filesystem::remove_all(file.parent_path());
}

}  // namespace
}  // namespace polyturn::channels::testing
