// The pages in SQLite's log (store.sqlite-wal) that belong to finished transactions: what the main
// file will be once the log is folded in. Format:
// https://www.sqlite.org/fileformat2.html#the_write_ahead_log
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace polyturn::toolmgmt {

struct LogPages {
    std::map<std::uint32_t, std::uint64_t> sums;  // page, from 1 -> sum of its newest content
    std::uint32_t page_size = 0;
    // of the main file afterwards; 0: the log holds nothing
    std::uint32_t pages = 0;
};

// A log that is missing, empty or incomplete at its end is none of our faults: what comes behind
// the first bad frame does not count.
LogPages read_log(const std::string& path);

}  // namespace polyturn::toolmgmt
