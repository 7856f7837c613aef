// Measured errors that are imported while the machine runs: machine.compensation is looked at by a
// thread of its own (real time only; a virtual run has the tables it began with), read and checked
// there, and handed to the cyclic thread, which takes it while all axes rest. Its values then fade
// in like everything that compensation adds.
//
// A table that does not fit the parameters is refused as a whole: the one that acts goes on, and
// the operator is told.
#pragma once
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ipc/machine/errors/compensation_tables.hpp"
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
