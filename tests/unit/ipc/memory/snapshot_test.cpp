// A snapshot's reader always gets one whole value: also when its writer is killed between any two
// stores.
#include "ipc/memory/snapshot.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <thread>

namespace polyturn {
namespace {

struct Value {
    std::array<std::uint64_t, 500> words;
    void fill(std::uint64_t seed) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i + 1 < words.size(); ++i) {
            words[i] = seed * 0x9e3779b97f4a7c15ull + i;
            sum += words[i];
        }
        words.back() = sum;
    }
    bool whole() const {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i + 1 < words.size(); ++i) sum += words[i];
        return sum == words.back();
    }
};

TEST(Snapshot, IsWholeWhenItsWriterIsKilledAtAnyMoment) {
    void* memory = mmap(nullptr, sizeof(Snapshot<Value>), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    auto& snapshot = *new (memory) Snapshot<Value>;
    snapshot.draft().fill(1);
    snapshot.publish();
    for (int round = 0; round < 100; ++round) {
        const pid_t child = fork();
        if (child == 0) {
            for (std::uint64_t seed = 2;; ++seed) {
                snapshot.draft().fill(seed);
                snapshot.publish();
            }
        }
        usleep(static_cast<useconds_t>(300 + 37 * round));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        Value value;
        ASSERT_TRUE(snapshot.read(value));
        ASSERT_TRUE(value.whole()) << "round " << round;
    }
    EXPECT_GT(snapshot.version(), 100u);
    munmap(memory, sizeof(Snapshot<Value>));
}

TEST(Snapshot, ReaderBesideABusyWriterGetsWholeValuesOrNone) {
    auto snapshot = std::make_unique<Snapshot<Value>>();
    snapshot->draft().fill(1);
    snapshot->publish();
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (std::uint64_t seed = 2; !stop; ++seed) {
            snapshot->draft().fill(seed);
            snapshot->publish();
            if (seed % 16 == 0) std::this_thread::yield();
        }
    });
    int torn = 0, read = 0;
    for (int i = 0; i < 20'000; ++i) {
        Value value;
        if (!snapshot->read(value)) continue;
        ++read;
        torn += !value.whole();
    }
    stop = true;
    writer.join();
    EXPECT_EQ(torn, 0);
    EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace polyturn
