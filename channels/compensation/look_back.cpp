#include "channels/compensation/look_back.hpp"

#include "ipc/diagnosis/assert.hpp"

namespace polyturn::channels::compensation {
namespace {

constexpr double kSame = 1e-6;  // mm: the paths only touch at an end

bool at_an_end(const Element& a, const Element& b, Vec point) {
    for (const Vec end : {a.start, a.end, b.start, b.end})
        if (length(point - end) < kSame) return true;
    return false;
}

}  // namespace

void LookBack::begin_block(const Element& programmed) {
    if (blocks_ == 0) return;
    open_ = true;
    ++block_;
    programmed_.push_back(programmed);
    programmed_.back().nose = 0;
}

void LookBack::move(const Move& m, const BlockContext& at) {
    if (!open_) {
        let_out();
        out_->move(m, at);
        return;
    }
    PT_ASSERT(pieces_.empty() || pieces_.back().block <= block_, "L1 pieces in their order");
    pieces_.push_back({m, at, block_, {}});
}

void LookBack::aux(const Aux& a, const BlockContext& at) {
    if (a.drained) let_out();
    if (holds())
        behind().aux(a, at);
    else
        out_->aux(a, at);
}

void LookBack::alarm(const Diagnosis& diagnosis, const BlockContext& at) {
    // what lies before the fault is driven
    if (diagnosis.severity() == Severity::Error) let_out();
    out_->alarm(diagnosis, at);
}

void LookBack::let_out() {
    let_out_before(block_ + 1);
    PT_ASSERT(pieces_.empty(), "L1 all before it has left");
    programmed_.clear();
    open_ = false;
}

void LookBack::let_out_before(std::uint64_t block) {
    while (!pieces_.empty() && pieces_.front().block < block) {
        Piece piece = std::move(pieces_.front());
        pieces_.pop_front();
        out_->move(piece.move, piece.at);
        piece.behind.pass_on(*out_);
    }
}

// The nose's path itself: an element without a nose.
Element LookBack::path_of(const Move& m) const {
    const Vec start{m.machine_start[p_], m.machine_start[q_]}, end{m.machine[p_], m.machine[q_]};
    return is_arc(m) ? arc(start, end, {m.centre_p, m.centre_q}, m.sweep) : line(start, end);
}

// Do both pass a point, besides those where one of them begins or ends?
bool LookBack::cross(const Piece& a, const Piece& b) const {
    const auto goes = [&](const Move& m) {
        return (m.moved & (1u << p_ | 1u << q_)) != 0 && !m.through;
    };
    if (!goes(a.move) || !goes(b.move)) return false;
    const Element one = path_of(a.move), other = path_of(b.move);
    const Crossings points = crossings(one, other);
    for (int i = 0; i < points.count; ++i)
        if (on_nose_path(one, points.at[i]) && on_nose_path(other, points.at[i]) &&
            !at_an_end(one, other, points.at[i]))
            return true;
    return false;
}

// Blocks that begin where the other ends do not cross there.
bool LookBack::cross_as_programmed(std::uint64_t a, std::uint64_t b) const {
    if (a == b) return false;
    const std::uint64_t first = block_ + 1 - programmed_.size();
    const Element &one = programmed_[a - first], &other = programmed_[b - first];
    const Crossings points = crossings(one, other);
    for (int i = 0; i < points.count; ++i)
        if (on_nose_path(one, points.at[i]) && on_nose_path(other, points.at[i]) &&
            !at_an_end(one, other, points.at[i]))
            return true;
    return false;
}

std::optional<BlockContext> LookBack::end_block() {
    if (!open_) return std::nullopt;
    open_ = false;
    std::size_t newest = pieces_.size();
    while (newest > 0 && pieces_[newest - 1].block == block_) --newest;
    for (std::size_t b = newest; b < pieces_.size(); ++b)
        for (std::size_t a = 0; a + 1 < b; ++a) {  // two pieces in succession meet anyway
            if (!cross(pieces_[a], pieces_[b]) || cross_as_programmed(pieces_[a].block, block_))
                continue;
            const BlockContext fault = pieces_[a].at;
            let_out_before(pieces_[a].block);
            forget();
            return fault;
        }
    // The next one is compared with blocks_ + 2 before it, but its neighbour.
    if (block_ > blocks_ + 1) let_out_before(block_ - blocks_ - 1);
    while (programmed_.size() > blocks_ + 2u) programmed_.pop_front();
    return std::nullopt;
}

}  // namespace polyturn::channels::compensation
