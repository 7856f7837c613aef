// Restart at a block (block search): the program is interpreted from its beginning, so that its
// state, offsets, variables and calls are what they would be; its actions before that block are
// collected here instead of being executed.
//
//   before the block   moves, dwells, messages: nothing happens. M, S, T and spindle modes: the
//                      last of each kind is kept.
//                      Variables and offsets are written. Waits for channels that restart too are
//                      replayed by the kernel; the others count as met.
//   at the block       message with everything that is to come, a stop (StopReason::Restart), then
//                      T, M, S, then the axes in the order of PT_RESTART_ORDER to where the block
//                      begins. From there on the program is as ever.
//
// M codes of one group (N1341 to N1372; M3 M4 M5 M19; M7 M8 M9) exclude each other, so only the
// last one counts; of the others the last of each number, in the order of the program. N1338 M06: a
// tool is changed by M6; the T before it is the one to load.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "channels/machine_view.hpp"
#include "channels/sink.hpp"

namespace polyturn::channels {

class RestartSink final : public Sink {
public:
    RestartSink(const MachineView& view, Sink& next);

    // From now on, until `block` of the main program; `together`: channels that restart too (bit 0
    // is channel 1).
    void search(std::int64_t block, std::uint32_t together);
    bool searching() const { return searching_; }
    std::int64_t wanted() const { return block_; }
    // With tool management: which tool a T (or a change, M6) that is passed means. It is asked, the
    // tool is not called.
    std::function<void(const Aux& code, const BlockContext& at)> look_up_tool;
    // The interpreter has done a block: it may be the one, without having caused anything.
    void block_read(const BlockContext& at) { (void)here(at); }
    // Where the program thinks a machine axis (from 0) is, while it is only interpreted.
    double position(unsigned machine_axis) const;

    void move(const Move& m, const BlockContext& at) override;
    void dwell(const Dwell& d, const BlockContext& at) override {
        if (here(at)) next_->dwell(d, at);
    }
    void aux(const Aux& a, const BlockContext& at) override;
    void spindle(const Spindle& s, const BlockContext& at) override;
    void wait(const Wait& w, const BlockContext& at) override;
    void variable(const Variable& v, const BlockContext& at) override {
        (void)here(at);
        next_->variable(v, at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        (void)here(at);
        next_->offset(o, at);
    }
    void message(std::string_view text, const BlockContext& at) override {
        if (here(at)) next_->message(text, at);
    }
    void stop(const Stop& s, const BlockContext& at) override {
        if (here(at)) next_->stop(s, at);
    }
    void part(double count, const BlockContext& at) override {
        if (here(at)) next_->part(count, at);
    }
    void alarm(const Diagnosis& d, const BlockContext& at) override {
        (void)here(at);
        next_->alarm(d, at);
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override;
    void print(std::string_view text, const BlockContext& at) override {
        if (here(at)) next_->print(text, at);
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        (void)here(at);
        next_->parameter(line, at);
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        (void)here(at);
        next_->tool_write(w, at);
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        (void)here(at);
        next_->life_group(g, at);
    }
    void signal(std::string_view name, double value, const BlockContext& at) override;
    void barrier(const BlockContext& at) override { next_->barrier(at); }
    void block_end(const BlockContext& at) override {
        if (!searching_) next_->block_end(at);
    }

private:
    struct KeptAux {
        int group = 0;  // codes of one group exclude each other
        char letter = 'M';
        double value = 0;
        std::string text;
        ToolCallBy by = ToolCallBy::Type;
        std::string name;
    };
    // the block has been reached: everything passes
    bool here(const BlockContext& at, const Move* first = nullptr);
    void arrive(const BlockContext& at, const Move* first);
    int group_of(const Aux& a) const;
    std::string shown(const AxisValues& target) const;

    const MachineView* view_;
    Sink* next_;
    bool searching_ = false;
    std::int64_t block_ = -1;
    std::uint32_t together_ = 0;
    AxisValues from_{}, position_{}, pos_{};
    bool placed_ = false;            // pos_ belongs to position_
    std::vector<KeptAux> aux_;       // in the order of the program
    std::vector<Spindle> spindles_;  // likewise
    Interrupts interrupts_;
    bool interrupts_told_ = false, by_m6_ = false, macros_too_ = false;
    std::vector<std::pair<std::string, double>> signals_;
};

}  // namespace polyturn::channels
