// In front of the record sink: numbers the results of each block, and lets a block that was held in
// the middle go on with other offsets (architecture 5.6).
//
// A block is interpreted again from its beginning, with the values that hold now. Of what it
// causes, the parts that have been executed are left out; the part in which the path was held goes
// on from the axes' position:
//
//   before   A------------P- - - - - - >B         P  held
//   now      A'- - - - - -Q------------>B'        Q  the point of the new path nearest to P
//                         ^
//                         P                       P to Q is a move at the feed of the block
//                                                 (a rapid goes from P to B' at once)
//
// Invariant: a part that has not begun is driven whole, from its new beginning on.
#pragma once
#include "channels/machine_view.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels {

class ResumeSink final : public Sink {
public:
    ResumeSink(const MachineView& view, Sink& next) : view_(&view), next_(&next) {}

    // What comes now is read again. The path was held in part `part` of the block `serial` (0:
    // behind everything that was read), `begun`: within it. `here`: drives; `left_at`: where the
    // program was left, when the axes have moved since.
    void go_back(std::uint64_t serial, std::uint32_t part, bool begun, const AxisValues& here,
                 const AxisValues& left_at);

    void move(const Move& m, const BlockContext& at) override;
    void dwell(const Dwell& d, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->dwell(d, c); });
    }
    void aux(const Aux& a, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->aux(a, c); });
    }
    void spindle(const Spindle& s, const BlockContext& at) override;
    void wait(const Wait& w, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->wait(w, c); });
    }
    void variable(const Variable& v, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->variable(v, c); });
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->offset(o, c); });
    }
    void message(std::string_view text, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->message(text, c); });
    }
    void stop(const Stop& s, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->stop(s, c); });
    }
    void part(double count, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->part(count, c); });
    }
    void alarm(const Diagnosis& d, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->alarm(d, c); });
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->interrupts(i, c); });
    }
    void print(std::string_view text, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->print(text, c); });
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->parameter(line, c); });
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->tool_write(w, c); });
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->life_group(g, c); });
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        pass(at, [&](const BlockContext& c) { next_->signal(name, value, c); });
    }
    // no part: whether there is one may change
    void barrier(const BlockContext& at) override { next_->barrier(at); }
    void block_end(const BlockContext& at) override { next_->block_end(at); }

private:
    // The number of this part in `at_`; false: it has been executed.
    bool counts(const BlockContext& at);
    template <class Call>
    void pass(const BlockContext& at, Call&& call) {
        if (counts(at)) call(at_);
    }
    void enter(const Move& move);
    void step_to(const AxisValues& point, const Move& of);

    const MachineView* view_;
    Sink* next_;
    BlockContext at_;
    std::uint64_t serial_ = 0;  // of the block whose parts are counted
    std::uint32_t part_ = 0;
    std::uint64_t skip_serial_ = 0;  // of this block parts before skip_part_ are left out
    std::uint32_t skip_part_ = 0;
    bool begun_ = false;
    // the next move begins at here_, wherever the program thinks it does
    bool entering_ = false;
    AxisValues here_{}, left_at_{};
};

}  // namespace polyturn::channels
