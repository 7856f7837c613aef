// Detects that the nose crosses its own path a few blocks later. The block between two neighbours
// is checked by its vectors (interference.hpp); a hollow of several blocks that is narrower than
// the nose shows only here (N1404: nct_parameters_part1 15.3).
//
//      N    \            / N+3        the nose's path along N and along N+3 crosses itself at X,
//            \          /             though the programmed one does not: what lies between cannot
//             \        /              be cut
//             '.  X   .'
//               '. .'                 alarm:   N and all behind it are not driven
//               .' '.                 correct: N ends at X, N+3 begins there
//              / N+1 \  N+2
//
// A sink behind the compensator. It holds back the moves of `blocks` + 2 contour blocks until the
// block behind them is known.
//
// Invariants
//   L1  Calls leave in the order in which they came. One that the machine must come to lets out
//       everything before it; so does a move that belongs to no contour block (approach, retract,
//       axes outside the plane): no crossing is searched for across it.
//   L2  With `blocks` 0 nothing is ever held.
#pragma once
#include <cstdint>
#include <deque>
#include <optional>

#include "channels/compensation/element.hpp"
#include "channels/compensation/held_calls.hpp"

namespace polyturn::channels::compensation {

class LookBack final : public Sink {
public:
    void open(Sink& out) { out_ = &out; }
    void configure(unsigned p, unsigned q, unsigned blocks) {
        p_ = p;
        q_ = q;
        blocks_ = blocks;
    }
    // Around the moves of a contour block, given as it is programmed.
    void begin_block(const Element& programmed);
    // Nothing: all is well. Else the block that cannot be driven; those before it have left, it and
    // what follows is forgotten.
    std::optional<BlockContext> end_block();
    void let_out();
    void forget() {
        pieces_.clear();
        programmed_.clear();
        open_ = false;
    }
    bool holds() const { return !pieces_.empty(); }

    void move(const Move&, const BlockContext&) override;
    void dwell(const Dwell& d, const BlockContext& at) override {
        if (holds())
            behind().dwell(d, at);
        else
            out_->dwell(d, at);
    }
    void aux(const Aux& a, const BlockContext& at) override;
    void spindle(const Spindle& s, const BlockContext& at) override {
        if (holds())
            behind().spindle(s, at);
        else
            out_->spindle(s, at);
    }
    void wait(const Wait& w, const BlockContext& at) override {
        let_out();
        out_->wait(w, at);
    }
    void variable(const Variable& v, const BlockContext& at) override {
        if (holds())
            behind().variable(v, at);
        else
            out_->variable(v, at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        if (holds())
            behind().offset(o, at);
        else
            out_->offset(o, at);
    }
    void message(std::string_view text, const BlockContext& at) override {
        if (holds())
            behind().message(text, at);
        else
            out_->message(text, at);
    }
    void print(std::string_view text, const BlockContext& at) override {
        if (holds())
            behind().print(text, at);
        else
            out_->print(text, at);
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        if (holds())
            behind().parameter(line, at);
        else
            out_->parameter(line, at);
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        if (holds())
            behind().tool_write(w, at);
        else
            out_->tool_write(w, at);
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        if (holds())
            behind().life_group(g, at);
        else
            out_->life_group(g, at);
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        if (holds())
            behind().signal(name, value, at);
        else
            out_->signal(name, value, at);
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        if (holds())
            behind().interrupts(i, at);
        else
            out_->interrupts(i, at);
    }
    void part(double count, const BlockContext& at) override {
        if (holds())
            behind().part(count, at);
        else
            out_->part(count, at);
    }
    void stop(const Stop& s, const BlockContext& at) override {
        let_out();
        out_->stop(s, at);
    }
    void alarm(const Diagnosis&, const BlockContext&) override;
    void barrier(const BlockContext& at) override {
        let_out();
        out_->barrier(at);
    }
    void block_end(const BlockContext& at) override {
        if (holds())
            behind().block_end(at);
        else
            out_->block_end(at);
    }

private:
    struct Piece {
        Move move;
        BlockContext at;
        std::uint64_t block;
        HeldCalls behind;
    };
    HeldCalls& behind() { return pieces_.back().behind; }
    Element path_of(const Move& m) const;
    void let_out_before(std::uint64_t block);
    bool cross(const Piece& a, const Piece& b) const;
    bool cross_as_programmed(std::uint64_t a, std::uint64_t b) const;

    Sink* out_ = nullptr;
    unsigned p_ = 0, q_ = 1, blocks_ = 0;
    bool open_ = false;
    std::uint64_t block_ = 0;  // number of the newest
    std::deque<Piece> pieces_;
    std::deque<Element> programmed_;  // of the blocks held, the newest last
};

}  // namespace polyturn::channels::compensation
