#include "kernel/plc/plc_memory.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "ipc/model/files/replace_file.hpp"
#include "kernel/plc/plc_api.h"

namespace polyturn::plc {
namespace {
// then for each block: number, length (u32 each), bytes
constexpr char kMagic[8] = {'P', 'T', 'P', 'L', 'C', 'M', '1', '\n'};
}  // namespace

void PlcMemory::open(std::string path, bool queued) {
    path_ = std::move(path);
    queued_ = queued;
    // A write copies into what is there: nothing is allocated in a cycle.
    for (auto& block : blocks_) block.reserve(kLongest);
    if (path_.empty()) return;
    load();
    disk_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
}

void PlcMemory::load() {
    std::ifstream file(path_, std::ios::binary);
    if (!file) return;
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const auto damaged = [&] {
        fmt::print(stderr, "polyturn-plc: {}: no memory of a PLC, or not whole; it begins empty\n",
                   path_);
        for (auto& block : blocks_) block.clear();
    };
    if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
        return damaged();
    for (std::size_t at = sizeof kMagic; at < bytes.size();) {
        std::uint32_t head[2];
        if (bytes.size() - at < sizeof head) return damaged();
        std::memcpy(head, bytes.data() + at, sizeof head);
        at += sizeof head;
        if (head[0] >= kBlocks || head[1] > kLongest || bytes.size() - at < head[1])
            return damaged();
        const auto* from = reinterpret_cast<const std::byte*>(bytes.data() + at);
        blocks_[head[0]].assign(from, from + head[1]);
        at += head[1];
    }
}

std::string PlcMemory::image() const {
    std::string bytes(kMagic, sizeof kMagic);
    for (std::uint32_t n = 0; n < kBlocks; ++n) {
        if (blocks_[n].empty()) continue;
        const std::uint32_t head[2] = {n, static_cast<std::uint32_t>(blocks_[n].size())};
        bytes.append(reinterpret_cast<const char*>(head), sizeof head);
        bytes.append(reinterpret_cast<const char*>(blocks_[n].data()), blocks_[n].size());
    }
    return bytes;
}

// A disk error is reported once, and the write is repeated every second.
void PlcMemory::keep(const std::stop_token& stop) {
    bool told = false;
    std::unique_lock hold(lock_);
    while (true) {
        store_changes_.wait(hold, stop, [&] { return wanted_.has_value(); });
        if (!wanted_) return;  // asked to stop, and everything is kept
        std::string bytes = std::move(*wanted_);
        wanted_.reset();
        hold.unlock();
        const auto kept = text::replace_file(path_, bytes);
        if (!kept && !std::exchange(told, true))
            fmt::print(stderr, "polyturn-plc: {}\n", kept.diagnosis().text());
        hold.lock();
        if (!kept && !wanted_ && !stop.stop_requested()) {
            wanted_ = std::move(bytes);
            (void)store_changes_.wait_for(hold, stop, std::chrono::seconds(1),
                                          [] { return false; });
        }
    }
}

void PlcMemory::begin_cycle() noexcept {
    reads_ = 0;
    ready_ = asked_;
    asked_.reset();
}

void PlcMemory::end_cycle() {
    if (timeouts_ && !told_) {
        told_ = true;
        fmt::print(stderr,
                   "polyturn-plc: PLC timeout: more than one memory read in a cycle while "
                   "N1274 #0 is 0\n");
    }
    if (std::exchange(dirty_, false) && !path_.empty()) {
        {
            const std::lock_guard hold(lock_);
            wanted_ = image();
        }
        store_changes_.notify_all();
    }
}

int PlcMemory::read(std::uint32_t block, void* to, std::size_t size) noexcept {
    if (block >= kBlocks || blocks_[block].size() != size) return POLYTURN_PLC_MEMORY_NONE;
    if (queued_) {
        if (!ready_[block]) {
            asked_[block] = true;
            return POLYTURN_PLC_MEMORY_QUEUED;
        }
        ready_[block] = false;
    } else if (reads_++ > 0) {
        ++timeouts_;
        return POLYTURN_PLC_MEMORY_TIMEOUT;
    }
    std::memcpy(to, blocks_[block].data(), size);
    return POLYTURN_PLC_MEMORY_DONE;
}

int PlcMemory::write(std::uint32_t block, const void* from, std::size_t size) noexcept {
    if (block >= kBlocks || size == 0 || size > kLongest) return POLYTURN_PLC_MEMORY_NONE;
    const auto* bytes = static_cast<const std::byte*>(from);
    blocks_[block].assign(bytes, bytes + size);
    dirty_ = true;
    return POLYTURN_PLC_MEMORY_DONE;
}

}  // namespace polyturn::plc
