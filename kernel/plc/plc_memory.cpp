#include "kernel/plc/plc_memory.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "kernel/plc/plc_api.h"

namespace polyturn::plc {
namespace {
constexpr char kMagic[8] = {'P', 'T', 'P', 'L', 'C', 'M', '1', '\n'};   // then for each block: number, length (u32 each), bytes
}  // namespace

void PlcMemory::open(std::string path, bool queued) {
    *this = {};
    path_ = std::move(path);
    queued_ = queued;
    // A write copies into what is there: nothing is allocated in a cycle.
    for (auto& block : blocks_) block.reserve(kLongest);
    if (!path_.empty()) load();
}

void PlcMemory::load() {
    std::ifstream file(path_, std::ios::binary);
    if (!file) return;
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const auto damaged = [&] {
        fmt::print(stderr, "polyturn-plc: {}: no memory of a PLC, or not whole; it begins empty\n", path_);
        for (auto& block : blocks_) block.clear();
    };
    if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) return damaged();
    for (std::size_t at = sizeof kMagic; at < bytes.size();) {
        std::uint32_t head[2];
        if (bytes.size() - at < sizeof head) return damaged();
        std::memcpy(head, bytes.data() + at, sizeof head);
        at += sizeof head;
        if (head[0] >= kBlocks || head[1] > kLongest || bytes.size() - at < head[1]) return damaged();
        const auto* from = reinterpret_cast<const std::byte*>(bytes.data() + at);
        blocks_[head[0]].assign(from, from + head[1]);
        at += head[1];
    }
}

// Whole or not at all: the old file stays until the new one is complete.
void PlcMemory::save() const {
    const std::string fresh = path_ + ".new";
    {
        std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
        file.write(kMagic, sizeof kMagic);
        for (std::uint32_t n = 0; n < kBlocks; ++n) {
            if (blocks_[n].empty()) continue;
            const std::uint32_t head[2] = {n, static_cast<std::uint32_t>(blocks_[n].size())};
            file.write(reinterpret_cast<const char*>(head), sizeof head);
            file.write(reinterpret_cast<const char*>(blocks_[n].data()), static_cast<std::streamsize>(blocks_[n].size()));
        }
        if (!file.flush()) return;
    }
    std::error_code none;
    std::filesystem::rename(fresh, path_, none);
}

void PlcMemory::begin_cycle() noexcept {
    reads_ = 0;
    ready_ = asked_;
    asked_.reset();
}

void PlcMemory::end_cycle() {
    if (timeouts_ && !told_) {
        told_ = true;
        fmt::print(stderr, "polyturn-plc: PLC timeout: more than one memory read in a cycle while N1274 #0 is 0\n");
    }
    if (dirty_ && !path_.empty()) save();
    dirty_ = false;
}

int PlcMemory::read(std::uint32_t block, void* to, std::size_t size) noexcept {
    if (block >= kBlocks || blocks_[block].size() != size) return POLYTURN_PLC_MEMORY_NONE;
    if (queued_) {
        if (!ready_[block]) return asked_[block] = true, POLYTURN_PLC_MEMORY_QUEUED;
        ready_[block] = false;
    } else if (reads_++ > 0) {
        return ++timeouts_, POLYTURN_PLC_MEMORY_TIMEOUT;
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
