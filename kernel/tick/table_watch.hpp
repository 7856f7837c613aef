// Error tables that are imported while the machine runs. A thread of its own looks at
// machine.compensation (real time only; a virtual run keeps the tables it began with), reads and
// checks it, and hands it to the cyclic thread, which takes it when all axes are at standstill. The
// new values then fade in like every compensation value.
//
// A table that does not fit the parameters is refused as a whole: the active table remains, and the
// operator is notified.
#pragma once
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ipc/model/compensation/compensation_tables.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class TableWatch {
public:
    TableWatch(std::string file, const StoreSegment& store, Core& core);
    void run(const std::atomic<bool>& stop);
    // Once: true when a new table was handed over or refused. run() does it again and again.
    bool look();

private:
    struct Stamp {
        bool there = false;
        std::filesystem::file_time_type when{};
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };
    Stamp stamp() const;

    std::string file_;
    const StoreSegment& store_;
    Core& core_;
    Stamp seen_, settled_;
    // the cyclic thread looks at the last one it has taken
    std::vector<std::unique_ptr<CompensationTables>> handed_;
};

}  // namespace polyturn::kernel
