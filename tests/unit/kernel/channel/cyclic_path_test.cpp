// The cyclic path: no allocation, no system call, the same result every time.
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "tests/unit/kernel/rig.hpp"

// Every new of this program comes through here, so that free() is the matching delete.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace {
std::atomic<bool> g_forbidden{false};
std::atomic<std::uint64_t> g_offences{0};
void* take(std::size_t size) {
    if (g_forbidden.load(std::memory_order_relaxed))
        g_offences.fetch_add(1, std::memory_order_relaxed);
    void* memory = std::malloc(size ? size : 1);
    if (!memory) std::abort();
    return memory;
}
}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    if (g_forbidden.load(std::memory_order_relaxed))
        g_offences.fetch_add(1, std::memory_order_relaxed);
    void* memory = std::aligned_alloc(static_cast<std::size_t>(alignment),
                                      (size + static_cast<std::size_t>(alignment) - 1) /
                                          static_cast<std::size_t>(alignment) *
                                          static_cast<std::size_t>(alignment));
    if (!memory) std::abort();
    return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace polyturn::kernel {
namespace {

// Two turrets cutting, with a wait, M codes, a thread and a hold among it.
void load(TickRig& rig) {
    rig.push(1, rig.spindle(1, 800));
    rig.push(1, rig.aux(1, 'M', 3));
    for (unsigned l = 1; l <= 2; ++l) {
        for (int i = 0; i < 20; ++i)
            rig.push(l, rig.line(l, {1.0 + 0.1 * i, i % 2 ? 3.0 : -4.0}, 60,
                                 i % 5 ? 0u : static_cast<std::uint32_t>(kExactStop)));
        rig.push(l, rig.wait(l, 500, 0b11));
        rig.push(l, rig.dwell(l, 0.05));
    }
    PathRecord thread =
        rig.line(2, {0, -20}, 0, kThread | kThreadEnd | kOverrideLocked | kExactStop);
    thread.feed_mode = static_cast<std::uint8_t>(FeedMode::Thread);
    thread.lead = 1.5;
    rig.push(2, thread);
    rig.push(2, rig.line(2, {30, 20}, 200, kRapid));
    rig.push(2, rig.stop(2, StopReason::M30));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.start(2);
    rig.command(CommandKind::FeedHold, 1, 1, 700);
    rig.command(CommandKind::CycleStart, 1, 1, 900);
    rig.command(CommandKind::FeedOverride, 2, 0.7, 1200);
}

TEST(CyclicPath, DoesNotAllocate) {
    TickRig rig([](params::Table&, RunOptions& o) { o.trace_every = 1; });
    load(rig);
    rig.plc_program = TickRig::lathe;
    for (int i = 0; i < 12'000; ++i) {
        g_forbidden = true;
        rig.machine->tick();
        g_forbidden = false;
        rig.serve();  // the other processes may do what they like
    }
    EXPECT_EQ(g_offences.load(), 0u);
    EXPECT_EQ(rig.state(2), ChannelState::Ended);
}

// Every system call but futex (doorbells), writing the verdict and leaving kills the process: the
// child lives or it does not.
TEST(CyclicPath, EntersTheSystemOnlyForItsDoorbells) {
    TickRig rig;
    load(rig);
    rig.run(50);  // pages touched
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        sock_filter filter[] = {
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_futex, 1, 0),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        };
        const sock_fprog program{sizeof filter / sizeof filter[0], filter};
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
            prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
            _exit(77);
        for (int i = 0; i < 3000; ++i) rig.machine->tick();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77) GTEST_SKIP() << "no seccomp here";
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << "killed by signal " << WTERMSIG(status);
}

TEST(CyclicPath, IsTheSameEveryTime) {
    std::vector<TraceSample> traces[2];
    for (auto& trace : traces) {
        TickRig rig([](params::Table&, RunOptions& o) { o.trace_every = 1; });
        load(rig);
        rig.on_tick = [&] {
            const auto head = rig.kernel->trace.head.load();
            for (auto i = rig.supervisor->trace_tail.tail.load(); i < head; ++i)
                trace.push_back(rig.kernel->trace.slot(i));
            rig.supervisor->trace_tail.tail.store(head);
        };
        rig.run_until_idle();
    }
    ASSERT_EQ(traces[0].size(), traces[1].size());
    ASSERT_GT(traces[0].size(), 1000u);
    for (std::size_t i = 0; i < traces[0].size(); ++i)
        ASSERT_EQ(std::memcmp(&traces[0][i], &traces[1][i], sizeof(TraceSample)), 0)
            << "sample " << i;
}

}  // namespace
}  // namespace polyturn::kernel
