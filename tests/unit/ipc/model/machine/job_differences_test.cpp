// What a job brings beside its programs, against what the controller has.
#include "ipc/model/machine/store/job_differences.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/store/apply_setup.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace {

using namespace polyturn;

TEST(JobDifferences, ComparesEveryZeroOfTheJobWithTheEnteredOne) {
    const LoadedMachine loaded = load_machine({});
    ASSERT_TRUE(loaded.ok());
    const MachineConfig machine = derive_machine_config(*loaded.table);
    const auto store = std::make_unique<ChannelStore>();
    clear_channel_store(*store);
    store->zeros[*work_zero_row("G55") * kChannelAxes + find_axis(machine, 1, "Z")->slot] = -20;
    text::Job job;
    job.zeros[1]["G54"]["Z"] = -150;
    job.zeros[1]["G55"]["Z"] = -20;
    job.zeros[1]["G54"]["Q"] = 1;
    job.zeros[9]["G54"]["Z"] = 0;
    const auto found = job_zeros(job, {}, machine, [&](unsigned) { return store.get(); });
    ASSERT_EQ(found.size(), 4u);
    for (const JobZero& one : found) {
        SCOPED_TRACE(one.system + " " + one.axis);
        EXPECT_EQ(one.same(), one.channel == 1 && one.system == "G55");
        EXPECT_EQ(std::isnan(one.entered), one.axis == "Q" || one.channel == 9)
            << "no such axis, no such channel";
    }
    EXPECT_FALSE(job_zeros(job, {}, machine, [](unsigned) { return nullptr; }).front().same())
        << "nothing is known";
}

// As `run` takes them: what the setup file names stands before the job.
TEST(JobDifferences, ASetupFilesZerosStandBeforeTheJobs) {
    const LoadedMachine loaded = load_machine({});
    ASSERT_TRUE(loaded.ok());
    const MachineConfig machine = derive_machine_config(*loaded.table);
    const auto store = std::make_unique<ChannelStore>();
    clear_channel_store(*store);
    text::Job job;
    job.zeros[1]["G54"]["Z"] = -150;
    text::Setup setup;
    setup.channels[1].work["G54"]["Z"] = -120;
    setup.channels[1].work["G54"]["X"] = 0;
    const auto found = job_zeros(job, setup, machine, [&](unsigned) { return store.get(); });
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(found[0].axis == "X" && found[0].same());
    EXPECT_TRUE(found[1].axis == "Z" && !found[1].same());
    EXPECT_DOUBLE_EQ(found[1].wanted, -120);
}

TEST(JobDifferences, ComparesEveryValueThatTheSetupFileNames) {
    const LoadedMachine loaded = load_machine({});
    ASSERT_TRUE(loaded.ok());
    const MachineConfig machine = derive_machine_config(*loaded.table);
    const auto store = std::make_unique<ChannelStore>();
    clear_channel_store(*store);
    std::vector<Diagnosis> wrong;
    const text::Setup setup = text::parse_setup(
        "[channel.1.offset.3]\ngeometry = { X = 38.12, Z = 27.05, R = 0.2, T = 3 }\n"
        "wear = { X = 0.04 }\n[channel.1.offset.5]\n"
        "geometry = { Z = 0.0 }\n[channel.9.offset.1]\n"
        "geometry = { X = 0.0 }\n",
        "a.setup.toml", wrong);
    ASSERT_TRUE(wrong.empty());
    const auto compared = [&] {
        return job_offsets(setup, machine, [&](unsigned) { return store.get(); });
    };
    auto found = compared();
    ASSERT_EQ(found.size(), 3u);
    EXPECT_TRUE(found[0].channel == 1 && found[0].number == 3 && found[0].values.size() == 5 &&
                !found[0].same());
    EXPECT_TRUE(found[1].number == 5 && found[1].same()) << "what it does not name is not compared";
    EXPECT_FALSE(found[2].same()) << "no such channel";
    apply_setup(setup, machine, 1, *store, wrong);
    EXPECT_TRUE(compared()[0].same());
    store->offsets[3].wear[0] = 0.05;
    found = compared();
    EXPECT_FALSE(found[0].same());
    for (const JobOffset::Value& one : found[0].values)
        EXPECT_EQ(one.same(), !one.wear) << one.name;
    EXPECT_DOUBLE_EQ(found[0].values.back().entered, 0.05);
    EXPECT_TRUE(std::isnan(
        job_offsets(setup, machine, [](unsigned) { return nullptr; })[0].values[0].entered))
        << "nothing is known";
}

TEST(JobDifferences, AnotherMachineHasOtherValues) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("job_differences_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder / "a");
    std::filesystem::create_directories(folder / "b");
    std::filesystem::create_directories(folder / "c");
    std::ofstream(folder / "a/machine.params") << "N0304 A1=10000\n";
    std::ofstream(folder / "b/machine.params") << "N0304 A1=11000\n";
    std::ofstream(folder / "c/machine.params") << "N0304 A1=10000\n";
    const std::string running = (folder / "a/machine").string();
    const auto other = [&](const std::string& named) {
        text::Job job;
        job.machine = named;
        return for_another_machine(job, running);
    };
    EXPECT_FALSE(other(""));
    EXPECT_FALSE(other((folder / "a").string()));
    EXPECT_FALSE(other((folder / "a/machine.params").string()));
    EXPECT_TRUE(other((folder / "b").string()));
    EXPECT_FALSE(other((folder / "c").string())) << "a copy";
    EXPECT_TRUE(other((folder / "nowhere").string()));
    std::filesystem::remove_all(folder);
}

}  // namespace
