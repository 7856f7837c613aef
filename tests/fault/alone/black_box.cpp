// A reader of the shared image that outlives the supervisor: it holds the kernel's memory until
// that has ended, then writes down what the scope has recorded, tick by tick, to the very last one.
//
//   black_box INSTANCE OUT.csv      prints a line `slot pid` for each process and `watching` when
//                                   the first trace moves; ends behind the kernel
//
// OUT.csv: tick, then the eight traces as they were chosen (press "scope 1 command A1").
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "ipc/memory/segment.hpp"

int main(int argc, char** argv) {
    using namespace polyturn;
    if (argc != 3) {
        std::fprintf(stderr, "usage: black_box INSTANCE OUT.csv\n");
        return 2;
    }
    auto kernel = PeerSegment<KernelSegment>::attach(argv[1], 0, std::chrono::seconds(20));
    auto supervisor = PeerSegment<SupervisorSegment>::attach(argv[1], 0, std::chrono::seconds(20));
    if (!kernel || !supervisor) {
        std::fprintf(stderr, "black_box: no such controller\n");
        return 2;
    }
    const int process = static_cast<int>(syscall(SYS_pidfd_open, (*kernel)->header.writer_pid, 0));
    if (process < 0) {
        std::fprintf(stderr, "black_box: the kernel does not run\n");
        return 2;
    }
    const auto& scope = (*kernel)->scope;
    const auto moves = [&] {
        const std::uint64_t head = scope.head.load(std::memory_order_acquire);
        return head > 1 && scope.slot(head - 1).value[0] != scope.slot(head - 2).value[0];
    };
    while (!moves()) {
        pollfd end{process, POLLIN, 0};
        if (poll(&end, 1, 1) > 0) {
            std::fprintf(stderr, "black_box: the kernel has ended before anything moved\n");
            return 2;
        }
    }
    std::printf("supervisor %d\n", static_cast<int>((*supervisor)->header.writer_pid));
    for (std::size_t slot = 0; slot < kProcesses; ++slot)
        if (const int pid = (*supervisor)->processes[slot].pid; pid > 0)
            std::printf("%zu %d\n", slot, pid);
    std::puts("watching");
    std::fflush(stdout);
    pollfd end{process, POLLIN, 0};
    while (poll(&end, 1, -1) < 0 && errno == EINTR) {}

    std::FILE* out = std::fopen(argv[2], "w");
    if (!out) {
        std::perror(argv[2]);
        return 2;
    }
    const std::uint64_t head = scope.head.load(std::memory_order_acquire),
                        from = head > kScopeRing ? head - kScopeRing : 0;
    for (std::uint64_t i = from; i < head; ++i) {
        const ScopeSample& sample = scope.slot(i);
        std::fprintf(out, "%lld", static_cast<long long>(sample.tick));
        for (const double value : sample.value) std::fprintf(out, ",%.17g", value);
        std::fputc('\n', out);
    }
    return std::fclose(out) == 0 ? 0 : 2;
}
