// Chamfers and roundings between two consecutive moves, for every language: a sink in front of
// compensation. It holds back the move that has an element at its end until the next one of the
// contour determines where it must stop.
//
//   move with corner() -> held a, calls behind it wait --(next move b)--> a shortened, element, b
//   shortened
//
// Invariants
//   I1  Calls go on in the order in which they came. The element comes directly behind a, or
//   directly before b when it
//       takes its technology from b (Call::from_next).
//   I2  Without a next move of the contour (another plane, a thread, rapid of the machine, a
//   barrier, the end) a goes on
//       as it is, without an element.
//   I3  An element that does not fit and may not be made smaller is a fault: neither a nor anything
//   behind it goes on. I4  Calls to compensation between the moves waits in the same order
//   (later()).
#pragma once
#include <functional>

#include "channels/compensation/held_calls.hpp"
#include "channels/corners/corner_element.hpp"

namespace polyturn::channels::corners {

struct Call {
    Shape shape = Shape::Rounding;
    double size = 0.0;  // mm
    // of the element, in the unit that holds; 0: that of the block it takes its technology from
    double feed = 0.0;
    // of its own block alone (FB): of the element too, where nothing above or of the next block
    // says another
    double block_feed = 0.0;
    // technology (feed, functions) of the next block instead of this one
    bool from_next = false;
    bool reduce = false;    // too large: make it smaller; else Alarm::CornerTooLarge
    bool straight = false;  // between lines only: Alarm::FagorTangential
    // no next move of the contour is a fault: Alarm::CornerWithoutNext
    bool required = false;
    unsigned idle_blocks = 3;  // blocks without motion that may stand between; more: no element
    char letter = 0;           // the word to point at
};

class CornerStage final : public Sink {
public:
    void open(Sink& down) {
        *this = CornerStage();
        down_ = &down;
    }
    void plane(unsigned p, unsigned q, AxisSet geometry) {
        p_ = p;
        q_ = q;
        geometry_ = geometry;
    }
    // at the end of the move that comes next
    void want(const Call& call) {
        want_ = call;
        wanted_ = true;
    }
    void forget_want() { wanted_ = false; }
    // of an element that takes its technology from the move that comes next
    void next_feed(double feed) { next_feed_ = feed; }
    bool wants() const { return wanted_; }
    bool holding() const { return holding_; }
    // while holding()
    void later(std::function<void()> told) { waiting_.control(std::move(told)); }
    void flush();  // the held move goes on without an element
    // something else than a contour follows: a fault where the element was asked for
    void cut_off();
    void block_done();  // the block has been interpreted

    // A move whose end only the next block gives: what comes meanwhile waits, until insert() makes
    // the move in front of it. A move that is held already stays so: the inserted one is the next
    // of its contour. `lost`: the fault where it is never made, because another move or the end
    // comes first; {}: then there was none.
    void reserve(Alarm lost, const BlockContext& at) {
        if (holding_ && !reserved_) {
            kept_ = true;
            earlier_.append(waiting_);
        }
        lost_ = lost;
        if (lost != Alarm{}) lost_at_ = at;
        holding_ = reserved_ = true;
        idle_ = 0;
        moved_ = true;
    }
    bool reserved() const { return reserved_; }
    template <class Make>
    void insert(Make&& make) {
        compensation::HeldCalls calls;
        calls.append(waiting_);
        reserved_ = false;
        holding_ = kept_;
        kept_ = false;
        waiting_.append(earlier_);
        make();
        while (!calls.empty()) calls.pass_on(*this);
    }

    bool failed() const { return failed_; }
    Alarm fault() const { return alarm_; }
    const BlockContext& fault_block() const { return held_.at; }
    char fault_letter() const { return held_.call.letter; }

    void move(const Move&, const BlockContext&) override;
    void dwell(const Dwell& d, const BlockContext& at) override {
        if (holding_)
            waiting_.dwell(d, at);
        else
            down_->dwell(d, at);
    }
    void aux(const Aux& a, const BlockContext& at) override {
        if (holding_)
            waiting_.aux(a, at);
        else
            down_->aux(a, at);
    }
    void spindle(const Spindle& s, const BlockContext& at) override {
        if (holding_)
            waiting_.spindle(s, at);
        else
            down_->spindle(s, at);
    }
    void wait(const Wait& w, const BlockContext& at) override {
        if (holding_)
            waiting_.wait(w, at);
        else
            down_->wait(w, at);
    }
    void variable(const Variable& v, const BlockContext& at) override {
        if (holding_)
            waiting_.variable(v, at);
        else
            down_->variable(v, at);
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        if (holding_)
            waiting_.offset(o, at);
        else
            down_->offset(o, at);
    }
    void message(std::string_view text, const BlockContext& at) override {
        if (holding_)
            waiting_.message(text, at);
        else
            down_->message(text, at);
    }
    void print(std::string_view text, const BlockContext& at) override {
        if (holding_)
            waiting_.print(text, at);
        else
            down_->print(text, at);
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        if (holding_)
            waiting_.parameter(line, at);
        else
            down_->parameter(line, at);
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        if (holding_)
            waiting_.tool_write(w, at);
        else
            down_->tool_write(w, at);
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        if (holding_)
            waiting_.life_group(g, at);
        else
            down_->life_group(g, at);
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        if (holding_)
            waiting_.signal(name, value, at);
        else
            down_->signal(name, value, at);
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        if (holding_)
            waiting_.interrupts(i, at);
        else
            down_->interrupts(i, at);
    }
    void part(double count, const BlockContext& at) override {
        if (holding_)
            waiting_.part(count, at);
        else
            down_->part(count, at);
    }
    void block_end(const BlockContext& at) override {
        if (holding_)
            waiting_.block_end(at);
        else
            down_->block_end(at);
    }
    void stop(const Stop&, const BlockContext&) override;
    void alarm(const Diagnosis&, const BlockContext&) override;
    void barrier(const BlockContext&) override;

private:
    struct Held {
        Move move;
        BlockContext at;
        Call call;
    };

    void take(const Move& m, const BlockContext& at);
    bool on_contour(const Move& m) const;
    Element element_of(const Move& m) const;
    void join(Move b, const BlockContext& at);
    Move element_between(const Move& a, const Move& b, const Corner& corner,
                         const Move& model) const;
    void pass_waiting();
    void fail(Alarm alarm);
    bool lose();

    Sink* down_ = nullptr;
    unsigned p_ = 0, q_ = 1;
    // axes of the workpiece system: one outside the plane that moves makes no corner
    AxisSet geometry_ = 0;
    bool holding_ = false, reserved_ = false, wanted_ = false, failed_ = false, moved_ = false;
    unsigned idle_ = 0;
    double next_feed_ = 0.0;
    Call want_;
    Held held_;  // when holding_ and not reserved_, and when kept_
    compensation::HeldCalls waiting_;
    bool kept_ = false;                // a held move is in front of the reserved one,
    compensation::HeldCalls earlier_;  // and what came between them
    Alarm lost_{};                     // of the reserved move
    BlockContext lost_at_;
    Alarm alarm_{};
};

}  // namespace polyturn::channels::corners
