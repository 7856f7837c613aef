// polyturn-plc as a process, beside a kernel and a store that this test plays: answers, exit, and
// what each fault of a builder's PLC ends in.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "ipc/memory/segment.hpp"
#include "tests/places.hpp"

namespace polyturn::plc {
namespace {

class PlcProcess : public ::testing::Test {
protected:
    void SetUp() override {
        instance_ = "test-plc-" + std::to_string(getpid());
        auto kernel = OwnSegment<KernelSegment>::create(instance_, 7);
        auto store = OwnSegment<StoreSegment>::create(instance_, 7);
        ASSERT_TRUE(kernel && store);
        kernel_ = std::move(*kernel);
        store_ = std::move(*store);
        params::set_defaults((*store_).parameters.draft());
        (*store_).parameters.publish();
        (*kernel_).tick_ns = 1'000'000;
        kernel_.publish();
        store_.publish();
    }
    void TearDown() override {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
        remove_instance(instance_);
    }
    void start(const std::string& library, const std::string& retained = {}) {
        child_ = fork();
        ASSERT_GE(child_, 0);
        if (child_ == 0) {
            const std::string program = std::string(kProgramFolder) + "/polyturn-plc";
            execl(program.c_str(), program.c_str(), "--instance", instance_.c_str(), "--library",
                  library.c_str(), retained.empty() ? nullptr : "--retained", retained.c_str(),
                  nullptr);
            _exit(127);
        }
    }
    void attach() {
        // The one of this process: a dead one may have left its segment.
        for (int i = 0; i < 1000; ++i, sleep_ms(10)) {
            auto plc = PeerSegment<PlcSegment>::attach(instance_, 0, std::chrono::seconds(10));
            ASSERT_TRUE(plc) << plc.diagnosis().text();
            plc_ = std::move(*plc);
            if (plc_->header.writer_pid == child_) return;
        }
        FAIL() << "the PLC has made no segment";
    }
    // Sends the next inputs; true when they were answered.
    bool cycle() {
        KernelSegment& kernel = *kernel_;
        PlcInputs& in = kernel.plc_inputs.draft();
        in = inputs;
        in.cycle = ++cycle_;
        in.tick = static_cast<std::int64_t>(10 * cycle_);
        kernel.plc_inputs.publish();
        kernel.plc_bell.ring();
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (plc_->cycle.load() != cycle_) {
            if (waitpid(child_, &status_, WNOHANG) == child_) {
                child_ = 0;
                return false;
            }
            if (std::chrono::steady_clock::now() > until) return false;
            std::this_thread::yield();
        }
        return plc_->outputs.read(outputs) && outputs.cycle == cycle_;
    }
    bool dies() {
        for (int i = 0; i < 1000; ++i) {
            if (child_ > 0 && waitpid(child_, &status_, WNOHANG) == child_) child_ = 0;
            if (child_ == 0) return true;
            sleep_ms(10);
        }
        return false;
    }

    std::string instance_;
    OwnSegment<KernelSegment> kernel_;
    OwnSegment<StoreSegment> store_;
    PeerSegment<PlcSegment> plc_;
    PlcInputs inputs{};
    PlcOutputs outputs{};
    std::uint64_t cycle_ = 0;
    pid_t child_ = -1;
    int status_ = 0;
};

TEST_F(PlcProcess, AnswersEachCycleAndEndsWhenAsked) {
    start(std::string(kProgramFolder) + "/liblathe_plc.so");
    attach();
    inputs.signal[signals::n_machine_on()] = 1;
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(cycle());
    inputs.signal[signals::cn_mcode(2)] = 8;
    inputs.signal[signals::cn_mstr(2)] = 1;
    ASSERT_TRUE(cycle());
    EXPECT_EQ(outputs.signal[signals::cp_mfin(2)], 1);
    EXPECT_EQ(outputs.output[8], 1) << "coolant of L2";
    EXPECT_EQ(plc_->header.generation, 7U);
    kill(child_, SIGTERM);
    ASSERT_TRUE(dies());
    EXPECT_TRUE(WIFEXITED(status_) && WEXITSTATUS(status_) == 0);
}

TEST_F(PlcProcess, BuilderExampleWorks) {
    start(std::string(kProgramFolder) + "/minimal_plc.so");
    attach();
    ASSERT_TRUE(cycle());
    inputs.signal[signals::cn_mcode(1)] = 8;
    inputs.signal[signals::cn_mstr(1)] = 1;
    ASSERT_TRUE(cycle());
    EXPECT_EQ(outputs.signal[signals::cp_mfin(1)], 1);
    EXPECT_EQ(outputs.output[0], 1);
}

// A PLC is started twice beside a store; what it finds the second time.
class PlcKeeps : public PlcProcess {
protected:
    void TearDown() override {
        PlcProcess::TearDown();
        std::filesystem::remove_all(folder_);
    }
    void life(std::int64_t n1274, int cycles = 3) {
        std::filesystem::create_directories(folder_);
        // a draft is not what was published last
        params::set_defaults((*store_).parameters.draft());
        params::put((*store_).parameters.draft(), params::n1274_plc_prgconfig, n1274);
        (*store_).parameters.publish();
        inputs = {};
        outputs = {};
        cycle_ = 0;
        (*kernel_).plc_inputs.write(PlcInputs{});
        plc_ = {};
        start(std::string(kProgramFolder) + "/keeping_plc.so", folder_ + "/plc.retained");
        attach();
        for (int i = 0; i < cycles; ++i) {
            ASSERT_TRUE(cycle());
            first_ = i == 0 ? outputs : first_;
        }
        kill(child_, SIGTERM);
        ASSERT_TRUE(dies());
        EXPECT_TRUE(WIFEXITED(status_) && WEXITSTATUS(status_) == 0);
    }
    int starts() const { return std::count(outputs.output.begin(), outputs.output.begin() + 8, 1); }
    int counted() const {
        return std::count(outputs.output.begin() + 16, outputs.output.begin() + 24, 1);
    }
    std::string folder_ = (std::filesystem::temp_directory_path() /
                           ("polyturn-plc-keeps-" + std::to_string(getpid())))
                              .string();
    PlcOutputs first_{};
};

TEST_F(PlcKeeps, WhatItNamesOverPowerOffWhileN1274NvfIsOn) {
    life(3);
    EXPECT_EQ(starts(), 1);
    life(3);
    EXPECT_EQ(starts(), 2);
    life(1);  // NVF 0: the program must save by itself
    EXPECT_EQ(starts(), 1);
    life(3);  // what was kept is still what the last life with NVF left
    EXPECT_EQ(starts(), 3);
}

TEST_F(PlcKeeps, MemoryThatItReadsAndWritesItselfAtOnceOneInACycleOrQueued) {
    life(0);  // nothing was written yet: both blocks are missing
    EXPECT_EQ(counted(), 1);
    life(0);  // MRW 0: block 7 at once; block 8 in the same cycle is a timeout
    EXPECT_EQ(counted(), 2);
    EXPECT_EQ(first_.output[30], 1);
    EXPECT_EQ(first_.output[31], 0);
    EXPECT_EQ(first_.output[32], 1);
    life(1);  // MRW 1: queued, both in the next cycle
    EXPECT_EQ(counted(), 3);
    EXPECT_EQ(first_.output[16 + 2], 0) << "not yet in the cycle that asks";
    EXPECT_EQ(first_.output[30] + first_.output[31] + outputs.output[32], 0);
}

TEST_F(PlcProcess, FastTaskAnswersEveryTickAndComesBeforeTheCycleOfItsTick) {
    start(std::string(kProgramFolder) + "/fast_plc.so");
    attach();
    const PlcFastPlan& plan = plc_->fast_plan;
    ASSERT_EQ(plan.reads, 2u);
    ASSERT_EQ(plan.writes, 2u);
    EXPECT_EQ(plan.read[0], kFastInput + 3);
    EXPECT_EQ(plan.read[1], signals::an_move(1));
    EXPECT_EQ(plan.write[0], signals::sp_osw(2));
    KernelSegment& kernel = *kernel_;
    const auto tick = [&](std::uint64_t count, std::int64_t at, std::int32_t in) {
        PlcFastInputs& fast = kernel.plc_fast.draft();
        fast.count = count;
        fast.tick = at;
        fast.value[0] = in;
        fast.value[1] = 0;
        kernel.plc_fast.publish();
        kernel.plc_bell.ring();
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (plc_->fast_count.load() != count && std::chrono::steady_clock::now() < until)
            std::this_thread::yield();
        PlcFastOutputs out;
        EXPECT_TRUE(plc_->fast.read(out));
        return out;
    };
    for (std::uint64_t n = 1; n <= 25; ++n) {
        if (n % 10 == 0) {  // a cycle's inputs come first, and wait for the task of their tick
            PlcInputs& in = kernel.plc_inputs.draft();
            in.cycle = n / 10;
            in.tick = static_cast<std::int64_t>(n);
            kernel.plc_inputs.publish();
            kernel.plc_bell.ring();
            sleep_ms(20);
            EXPECT_EQ(plc_->cycle.load(), n / 10 - 1);
        }
        const PlcFastOutputs out = tick(n, static_cast<std::int64_t>(n), n % 3 == 0);
        EXPECT_EQ(out.value[0], n % 3 == 0);
        EXPECT_EQ(out.value[1], static_cast<std::int32_t>(n));
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (n % 10 == 0 && plc_->cycle.load() != n / 10 &&
               std::chrono::steady_clock::now() < until)
            std::this_thread::yield();
    }
    ASSERT_TRUE(plc_->outputs.read(outputs));
    EXPECT_EQ(outputs.cycle, 2u);
    EXPECT_EQ(outputs.output[0], 0) << "20 runs before the second cycle";
    EXPECT_EQ(outputs.output[1], 1);
}

struct Fault {
    const char* library;
    bool signal;
    int number;
};
class PlcFault : public PlcProcess, public ::testing::WithParamInterface<Fault> {};

TEST_P(PlcFault, EndsTheProcessAndTheLastOutputsStayWhole) {
    start(std::string(kProgramFolder) + "/" + GetParam().library);
    attach();
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(cycle());
    EXPECT_FALSE(cycle());
    ASSERT_TRUE(dies());
    EXPECT_EQ(WIFSIGNALED(status_), GetParam().signal);
    EXPECT_EQ(GetParam().signal ? WTERMSIG(status_) : WEXITSTATUS(status_), GetParam().number);
    ASSERT_TRUE(plc_->outputs.read(outputs));
    EXPECT_EQ(outputs.cycle, 100U);
    EXPECT_EQ(outputs.output[0], 1);
}
INSTANTIATE_TEST_SUITE_P(Builders, PlcFault,
                         ::testing::Values(Fault{"crash_plc.so", true, SIGSEGV},
                                           Fault{"endless_plc.so", false, 3},
                                           Fault{"scribble_plc.so", true, SIGSEGV}));

TEST_F(PlcProcess, PlcThatDoesNotStartIsRefusedWithExitStatus2) {
    for (const char* library : {"unready_plc.so", "old_plc.so", "nowhere_plc.so"}) {
        SCOPED_TRACE(library);
        start(std::string(kProgramFolder) + "/" + library);
        ASSERT_TRUE(dies());
        EXPECT_TRUE(WIFEXITED(status_) && WEXITSTATUS(status_) == 2) << status_;
    }
}

TEST_F(PlcProcess, FollowsToANewKernel) {
    start(std::string(kProgramFolder) + "/liblathe_plc.so");
    attach();
    ASSERT_TRUE(cycle());
    auto next = OwnSegment<KernelSegment>::create(instance_, 8);
    ASSERT_TRUE(next);
    (**next).tick_ns = 1'000'000;
    next->publish();
    kernel_ = std::move(*next);
    for (int i = 0; i < 500 && plc_->header.generation != 8; ++i) {
        sleep_ms(10);
        auto plc = PeerSegment<PlcSegment>::attach(instance_);
        if (plc) plc_ = std::move(*plc);
    }
    ASSERT_EQ(plc_->header.generation, 8U);
    cycle_ = 0;
    EXPECT_TRUE(cycle());
}

}  // namespace
}  // namespace polyturn::plc
