// Nose-radius compensation for every language: a sink between the channel's state and the real
// sink. It holds back one block until the next one determines its end, and passes on the motion of
// the nose.
//
//   programmed move -> held block a  --(next block b)-->  vectors at the corner a/b -> check of a
//   -> a is delivered
//                      calls behind it wait with it                                   b is held
//
//   delivered point = programmed point + V + r*e
//
//   V  offset vector of the nose centre (corner.hpp)
//   e  direction from the nose centre to the imaginary tip, r the radius of the nose
//
// Invariants
//   I1  Calls are delivered in the order in which they came; those that came behind a held block
//   are made at its end
//       vector, so a function between two blocks acts at the corner.
//   I2  A block whose end vector cannot be made, or that would be driven backwards, is not
//   delivered, nor anything behind it. I3  Behind a call that the machine must come to (HeldCalls)
//   nothing is delivered before resume(): blocks are read on
//       meanwhile only as far as the held one needs.
//   I4  closed(): nothing is held and no vector is left, the compensator may be taken out of the
//   chain.
#pragma once
#include <optional>
#include <vector>

#include "channels/compensation/corner.hpp"
#include "channels/compensation/held_calls.hpp"
#include "channels/compensation/look_back.hpp"
#include "channels/compensation/options.hpp"

namespace polyturn::channels::compensation {

class Compensator final : public Sink {
public:
    struct Fault {
        Alarm alarm{};
        bool this_block = false;  // the block that is being interpreted; else `at` says
        BlockContext at;
    };

    // p, q: indices of the plane's axes.
    void open(Sink& out, unsigned p, unsigned q, const Options& options);
    bool closed() const;
    // while off
    void configure(unsigned p, unsigned q, const Options& options) {
        p_ = p;
        q_ = q;
        set_options(options);
    }
    void set_options(const Options& options);
    bool off() const { return state_ == State::Off && !held_; }

    // --- what the block says, before its move
    void select(int side);  // +1 left, -1 right of the path
    void cancel() {
        cancel_ = true;
        wish_set_ = false;
    }
    void cancel_towards(Vec wish) {
        cancel_ = true;
        wish_ = wish;
        wish_set_ = length(wish) > 0;
    }
    // radius may be negative: the sides change places. tip: from nose centre to imaginary tip, mm.
    // offset_step: how much of the next move is another tool offset.
    void nose(double radius, Vec tip, bool has_offset, Vec offset_step = {});
    void zero_distance() { zero_ = true; }  // plane axes are named and do not move
    // G53, reference: the next move leaves the vector behind
    void suspend();
    // the held block ends at its normal: nothing is known of what follows
    void settle();
    // A cycle of moves that must not be compensated one by one: its moves go as they are
    // programmed, or shifted by the vector that holds at its beginning; compensation goes on behind
    // it.
    enum class Bypass : std::uint8_t { None, Plain, Shifted };
    void bypass(Bypass how);
    void resume_at_vector() {
        if (state_ == State::Armed) state_ = State::Resuming;
    }
    void drop_vector();  // G50: the held block ends where it is programmed
    // The block has been interpreted. counts: it is one of the blocks without movement where it
    // made none.
    void block_done(bool counts);

    // --- barriers
    bool halted() const { return halted_; }
    void resume();
    bool holds_block() const { return held_; }
    bool holds() const { return held_ || !ready_.empty() || look_back_.holds(); }
    bool holds_moves_back();  // of the path, behind the call that the machine must come to
    void ensure_halt(const BlockContext& at);
    // What has been delivered is executed first; the held block stays held.
    void halt_before_held(const BlockContext& at);
    // of the axes from what is programmed; nothing is held
    Vec displacement() const { return displacement_; }
    bool displaced() const { return displacement_.p != 0 || displacement_.q != 0; }

    bool failed() const { return failed_; }
    const Fault& fault() const { return fault_; }

    // --- Sink
    void move(const Move&, const BlockContext&) override;
    void dwell(const Dwell& d, const BlockContext& at) override {
        queue().dwell(d, at);
        pump();
    }
    void aux(const Aux& a, const BlockContext& at) override {
        queue().aux(a, at);
        pump();
    }
    void spindle(const Spindle& s, const BlockContext& at) override {
        queue().spindle(s, at);
        pump();
    }
    void wait(const Wait& w, const BlockContext& at) override {
        queue().wait(w, at);
        pump();
    }
    void variable(const Variable& v, const BlockContext& at) override {
        queue().variable(v, at);
        pump();
    }
    void offset(const OffsetWrite& o, const BlockContext& at) override {
        queue().offset(o, at);
        pump();
    }
    void message(std::string_view text, const BlockContext& at) override {
        queue().message(text, at);
        pump();
    }
    void print(std::string_view text, const BlockContext& at) override {
        queue().print(text, at);
        pump();
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        queue().parameter(line, at);
        pump();
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        queue().tool_write(w, at);
        pump();
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        queue().life_group(g, at);
        pump();
    }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        queue().signal(name, value, at);
        pump();
    }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        queue().interrupts(i, at);
        pump();
    }
    void stop(const Stop&, const BlockContext&) override;
    void part(double count, const BlockContext& at) override {
        queue().part(count, at);
        pump();
    }
    void alarm(const Diagnosis&, const BlockContext&) override;
    void barrier(const BlockContext&) override;
    void block_end(const BlockContext& at) override {
        queue().block_end(at);
        pump();
    }

private:
    enum class State : std::uint8_t {
        Off,
        Armed,  // the next block in the plane begins compensation
        On,
        Resuming,  // the next block goes straight to the vector at its end
        Leaving,   // G40 without movement: the next block takes the vector back
    };
    enum class Role : std::uint8_t { Begin, Resume, Contour };
    struct Held {
        Move move;
        BlockContext at;
        Element element;
        Vec tip;  // mm
        Role role = Role::Contour;
        bool slow_begin = false, slow_end = false;  // at an inner corner that asks for less feed
    };

    // An element before a held one that may be too short: it is not known yet where it ends, nor
    // which one follows it.
    struct Before {
        Held held;
        Vectors end;  // seen from its own programmed end, as it looks now
        HeldCalls trailing;
        // from its programmed end to the start of what follows it now: what was left out
        Vec gap;
        unsigned left_out;  // so many elements
    };

    HeldCalls& queue() { return held_ ? trailing_ : ready_; }
    void pump();
    bool in_plane(const Move& m) const;
    Vec begins_at(const Move& m) const;
    Vec contour_start(const Move& m) const;
    Element element_of(const Move& m) const;
    Element from_nose(Element e) const;
    Element to_nose(Element e) const;
    void hold(const Move& m, const BlockContext& at, Role role);
    void contour_block(const Move& m, const BlockContext& at);
    void cancel_block(const Move& m, const BlockContext& at);
    void shift(Move& m) const { shift(m, displacement_); }
    void shift(Move& m, Vec by) const;
    void add_nose(Move& m, Vec by) const {
        m.nose[p_] = by.p;
        m.nose[q_] = by.q;
    }
    void straight_to_programmed(const Move& m, const BlockContext& at);
    bool finish(Vectors end);
    void finish_at_programmed();
    bool held_rapid() const {
        return held_ && block_.role == Role::Begin && block_.move.kind == MoveKind::Rapid;
    }
    Vectors before_rapid() const;
    // short_elements.cpp
    bool release_before();
    bool may_be_short(const Element& next) const;
    bool waits(const Element& next, const CornerResult& corner) const;
    bool leave_out_short(const Element& next, CornerResult& corner, Vec& gap, unsigned& left_out);
    bool begin_beyond_short(const Element& next, CornerResult& corner, Vec& gap);
    bool leave_short_last(const Move& m, bool& left);
    void drop_held();
    void follow(Vec gap);
    bool slow_corner(const Held& a, const Move& next_move, const Element& next) const;
    void leave_in_place();
    bool fail(Alarm alarm, bool this_block, const BlockContext& at);
    // one move in the plane from here_ to `to`
    void go(const Held& b, Vec to, bool by_arc, Vec about, double overshoot = 0.0);
    void go_element(const Held& b, Vec to, bool as_line);
    // the straight move m becomes a polynomial that touches the contour where it begins (entering)
    // or ends
    void touch(Move& m, Vec dir, double curvature, bool entering) const;
    double path_curvature(const Element& e, double radius) const;
    void go_corner(const Held& b, const Vectors& vectors, unsigned from, unsigned to, Vec corner,
                   Vec tip);
    void deliver(const Move& m, const BlockContext& at);

    Sink* out_ = nullptr;
    LookBack look_back_;  // between this and the machine: out_ is its sink, or it
    unsigned p_ = 0, q_ = 1;
    Options options_;
    State state_ = State::Off;
    bool held_ = false, halted_ = false, failed_ = false;
    Held block_;                  // when held_
    std::vector<Before> before_;  // in succession, the newest last; block_ follows them
    // of the contour, left out: the approach ends where an element meets what lengthens this one
    std::optional<Element> first_;
    bool constant_ = false;  // the last moves were only shifted
    // where the next (or the held) block begins; at[0] has been reached
    Vectors start_ = Vectors::one({});
    HeldCalls trailing_, ready_;
    Vec here_;  // machine, while a block is made
    Vec displacement_;
    Fault fault_;

    int side_ = 1;
    double nose_ = 0.0;  // not negative
    int nose_sign_ = 1;
    Vec tip_;  // mm
    bool has_offset_ = false;
    Vec offset_step_;  // of the move that comes
    bool repeated_ = false, cancel_ = false, wish_set_ = false, suspended_ = false;
    Vec wish_;
    Bypass bypass_ = Bypass::None;
    // Entry::Smooth, Curved: the element that approach or retract is tangential to
    std::optional<Element> touches_;
    bool moved_ = false, zero_ = false;  // in this block
    bool selected_ = false;              // G41, G42 in this block
    bool in_place_ = false;              // compensation begins at the tool's position
    bool settled_ = false;               // the last element ended without knowing the next
    unsigned idle_blocks_ = 0;
};

}  // namespace polyturn::channels::compensation
