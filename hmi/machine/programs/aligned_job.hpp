// The synchronised view of a job: blocks of the channels beside each other, as they come between
// two rendezvous; a rendezvous is a bridge that all of its channels reach in the same row.
//
//   row   L1      L2
//    0    N10     N10        blocks: as they stand in RunChannel::blocks
//    1    N20      .
//    2    ==== M500 ====     a rendezvous: the wait of one of its channels, and who comes to it
//
// Only numbers are kept: a row is looked at with the channels of now, which a new run may have
// changed meanwhile.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "hmi/machine/programs/dry_run.hpp"

namespace polyturn::hmi {

class AlignedJob {
public:
    struct Row {
        std::size_t first = 0;   // of its blocks
        unsigned channel = 0;    // of a rendezvous: whose wait it is; 0: blocks
        std::size_t wait = 0;    // of that channel
        std::uint32_t here = 0;  // who comes to it; bit 0: L1
        bool comes(unsigned number) const { return (here >> (number - 1) & 1u) != 0; }
    };
    void build(const std::map<unsigned, RunChannel>& channels);
    const std::vector<Row>& rows() const { return rows_; }
    // Nothing: the channel has no block in this row.
    const RunLine* line(const std::map<unsigned, RunChannel>& channels, const Row& row,
                        unsigned channel) const;
    const RunWait* wait(const std::map<unsigned, RunChannel>& channels, const Row& row) const;

private:
    std::vector<unsigned> order_;  // of the channels in a row
    std::vector<Row> rows_;
    std::vector<std::uint32_t> blocks_;  // number in RunChannel::blocks, from 1; 0: none
};

}  // namespace polyturn::hmi
