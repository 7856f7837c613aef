// Blocks of memory that a PLC reads and writes by itself and that outlive it: the MR and MW
// commands of N1274 (nct_parameters_part1 13). They lie in one file beside the machine's store,
// which is replaced whole behind a cycle that wrote: by a thread of its own, for a disk may take
// longer than a cycle. What several cycles write meanwhile goes to the disk together.
//
//   MRW 0   a read is done at once, one in a cycle; a second one in the same cycle is a PLC
//           timeout: it is refused and said
//   MRW 1   reads are queued: any number in a cycle, and each is answered in the next one
#pragma once
#include <bitset>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace polyturn::plc {

class PlcMemory {
public:
    static constexpr std::uint32_t kBlocks = 256;
    static constexpr std::size_t kLongest = 4096;

    // path: empty: nothing is kept. A file that cannot be read as one of these is reported on
    // stderr and replaced by the first write. Called once.
    void open(std::string path, bool queued);
    void begin_cycle() noexcept;
    void end_cycle();
    // As in plc_api.h.
    int read(std::uint32_t block, void* to, std::size_t size) noexcept;
    int write(std::uint32_t block, const void* from, std::size_t size) noexcept;
    std::uint64_t timeouts() const noexcept { return timeouts_; }

private:
    void load();
    std::string image() const;
    void keep(const std::stop_token& stop);
    std::string path_;
    bool queued_ = true, dirty_ = false, told_ = false;
    unsigned reads_ = 0;  // of this cycle
    std::uint64_t timeouts_ = 0;
    std::vector<std::vector<std::byte>> blocks_ = std::vector<std::vector<std::byte>>(kBlocks);
    std::bitset<kBlocks> asked_, ready_;

    // of `wanted_`, between the cycle and the disk's thread
    std::mutex lock_;
    std::condition_variable_any store_changes_;
    std::optional<std::string> wanted_;  // the newest content that is not on the disk
    std::jthread disk_;                  // last: it ends first, with everything kept
};

}  // namespace polyturn::plc
