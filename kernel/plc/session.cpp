#include "kernel/plc/session.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "ipc/memory/segment.hpp"
#include "ipc/model/files/replace_file.hpp"
#include "kernel/plc/cycle_watch.hpp"

namespace polyturn::plc {

namespace {

constexpr std::chrono::milliseconds kTimeout{10'000};
// how often a PLC without work looks for a stop or a new kernel
constexpr std::int64_t kLookRoundUs = 100'000;
constexpr int kSpins = 200;

bool another_kernel(const std::string& instance, std::uint64_t generation) {
    const auto kernel = PeerSegment<KernelSegment>::attach(instance);
    return kernel && (*kernel)->header.generation != generation;
}

// A file of another size belongs to another PLC: it is left alone, and the PLC begins afresh.
void put_back(const std::string& path, std::span<std::byte> state) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file || static_cast<std::size_t>(file.tellg()) != state.size()) return;
    std::vector<char> bytes(state.size());
    file.seekg(0);
    if (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        std::memcpy(state.data(), bytes.data(), bytes.size());
}

void keep(const std::string& path, std::span<const std::byte> state) {
    if (state.empty()) return;
    const auto kept =
        text::replace_file(path, {reinterpret_cast<const char*>(state.data()), state.size()});
    if (!kept) fmt::print(stderr, "polyturn-plc: {}\n", kept.diagnosis().text());
}

}  // namespace

Result<SessionEnd> run_session(const std::string& instance, BuilderPlc& plc,
                               const std::atomic<bool>& stop, const std::string& retained) {
    bool keeps = false;
    PlcMemory memory;
    auto kernel_segment = PeerSegment<KernelSegment>::attach(instance, 0, kTimeout);
    if (!kernel_segment) return kernel_segment.diagnosis();
    const KernelSegment& kernel = **kernel_segment;
    const std::uint64_t generation = kernel.header.generation;
    {
        auto store = PeerSegment<StoreSegment>::attach(instance, 0, kTimeout);
        if (!store) return store.diagnosis();
        const auto parameters = std::make_unique<params::Table>();
        while (!(*store)->parameters.read(*parameters)) sleep_ms(1);
        // P3: constant since the segment was published (the order is stronger than needed)
        const double tick_s =
            static_cast<double>(kernel.tick_ns.load(std::memory_order_acquire)) * 1e-9;
        memory.open(retained.empty()
                        ? std::string{}
                        : (std::filesystem::path(retained).parent_path() / "plc.memory").string(),
                    params::bit(*parameters, params::n1274_plc_prgconfig, 0));
        if (auto ready = plc.init(*parameters, tick_s, memory); !ready) return ready.diagnosis();
        keeps = !retained.empty() && params::bit(*parameters, params::n1274_plc_prgconfig, 1);
        if (keeps) put_back(retained, plc.retained());
    }
    auto own = OwnSegment<PlcSegment>::create(instance, generation);
    if (!own) return own.diagnosis();
    PlcSegment& segment = **own;
    segment.fast_plan = plc.fast_plan();
    own->publish();

    const auto inputs = std::make_unique<PlcInputs>();
    const auto outputs = std::make_unique<PlcOutputs>();
    PlcFastInputs fast_inputs{};
    PlcFastOutputs fast_outputs{};
    const bool has_fast = plc.fast_plan().writes != 0;
    std::uint64_t done = 0, fast_version = 0, version = 0, turns = 0;
    bool waits = false;  // inputs of a cycle have been read and are not worked off
    // P3: a flag, announces nothing
    while (!stop.load(std::memory_order_relaxed)) {
        const std::uint32_t rung = kernel.plc_bell.seen();
        bool worked = false;
        if (const std::uint64_t newest = has_fast ? kernel.plc_fast.version() : 0;
            newest != fast_version && kernel.plc_fast.read(fast_inputs)) {
            fast_version = newest;
            cycle_watch::begin(++turns);
            plc.fast(fast_inputs, fast_outputs);
            cycle_watch::end();
            fast_outputs.count = fast_inputs.count;
            segment.fast.write(fast_outputs);
            // P1: the outputs, then their count
            segment.fast_count.store(fast_outputs.count, std::memory_order_release);
            segment.bell.ring();
            worked = true;
        }
        if (const std::uint64_t newest = kernel.plc_inputs.version();
            newest != version && kernel.plc_inputs.read(*inputs)) {
            version = newest;
            waits = inputs->cycle != done;
        }
        // The fast task of the same tick is sent behind the cycle's inputs and comes first: one
        // order, however this process is woken.
        if (waits && (!has_fast || fast_inputs.tick >= inputs->tick)) {
            waits = false;
            cycle_watch::begin(++turns);
            memory.begin_cycle();
            plc.cycle(*inputs, *outputs);
            cycle_watch::end();
            done = outputs->cycle = inputs->cycle;
            segment.outputs.write(*outputs);
            // P1: the outputs, then their cycle
            segment.cycle.store(done, std::memory_order_release);
            segment.bell.ring();
            memory.end_cycle();
            worked = true;
        }
        if (worked) continue;
        kernel.plc_bell.wait(rung, kLookRoundUs, kSpins);
        if (kernel.plc_bell.seen() == rung && another_kernel(instance, generation))
            return SessionEnd::NewKernel;
    }
    if (keeps) keep(retained, plc.retained());
    return SessionEnd::Asked;
}

}  // namespace polyturn::plc
