// store.witness: what the store has acknowledged, in a file of its own, so that a log which was
// deleted, cut or damaged is noticed.
//
//   commit on disk -> witness on disk -> answer      the file may be ahead of the witness (killed
//                                                    in between), never behind it
//
// Two halves, written in turn: a half that power cut in two leaves the other one whole.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "toolmgmt/durability/store_files.hpp"

namespace polyturn::toolmgmt {

struct Witness {
    std::uint64_t store = 0;    // number of the store, the same in its table «promise»
    std::uint64_t commits = 0;  // acknowledged ones
    std::uint64_t stamp = 0;    // of the newest of them
    std::uint64_t users = 0;    // digest of all users; 0: there have never been any
    std::uint64_t unfit = 0;    // 1: data were lost and nobody has confirmed it; see `why`
    std::array<char, 256> why{};
};

class WitnessFile {
public:
    static constexpr const char* kName = "store.witness";
    enum class State : std::uint8_t { Missing, Damaged, Good };

    explicit WitnessFile(const std::string& folder) : path_(folder + "/" + kName) {}
    // Reads what is there; after Good, now() is the newest half that is whole.
    State read();
    const Witness& now() const { return now_; }
    // On disk when it returns true. Makes the file where it is missing or damaged.
    bool write(const Witness& next);

private:
    std::string path_;
    Witness now_;
    std::uint64_t turn_ = 0;  // counts writes: the half is turn_ & 1
    OpenFile file_;
};

}  // namespace polyturn::toolmgmt
