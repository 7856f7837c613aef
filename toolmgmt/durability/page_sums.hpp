// store.sums: a check sum of each page of the main file, as it is when the log has been folded in.
// It is written before the log is folded in, so whatever is killed in between: a page is as the
// sums say, or the log holds it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toolmgmt/durability/log_pages.hpp"

namespace polyturn::toolmgmt {

std::uint64_t page_sum(std::uint32_t page, std::string_view content);

struct PageSums {
    static constexpr const char* kName = "store.sums";
    enum class State : std::uint8_t { Missing, Damaged, Good };

    std::uint64_t store = 0;  // its number, as in Witness
    std::uint32_t page_size = 0;
    std::vector<std::uint64_t> sums;  // [0] is page 1

    State read(const std::string& folder);
    [[nodiscard]] bool write(const std::string& folder) const;  // on disk when it returns true
    // What they are once the log is folded in.
    void fold(const LogPages& log);
    // Of the whole content of a main file.
    void take(std::string_view file, std::uint32_t size);
    // The first page (from 1) of the main file that is neither as the sums say nor in the log; 0:
    // all are.
    std::uint32_t damaged(std::string_view file, const LogPages& log) const;
};

}  // namespace polyturn::toolmgmt
