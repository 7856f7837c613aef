// Calls of a Sink, stored with their own copies of all texts, and made later in the same order.
//
// A call behind which the machine must stop (a drained function, a wait, a program stop, a
// barrier) halts the passing on: what follows stays here until the machine has come to it, as run
// mode wants it.
#pragma once
#include <deque>
#include <functional>
#include <string>
#include <variant>

#include "channels/sink.hpp"

namespace polyturn::channels::compensation {

class HeldCalls {
public:
    void move(const Move& m, const BlockContext& at) { calls_.push_back({m, own(at), {}, {}, {}}); }
    void dwell(const Dwell& d, const BlockContext& at) {
        calls_.push_back({d, own(at), {}, {}, {}});
    }
    void aux(const Aux& a, const BlockContext& at) {
        calls_.push_back({a, own(at), std::string(a.text), std::string(a.name), {}});
    }
    void spindle(const Spindle& s, const BlockContext& at) {
        calls_.push_back({s, own(at), {}, {}, {}});
    }
    void wait(const Wait& w, const BlockContext& at) {
        calls_.push_back({w, own(at), std::string(w.marker), {}, {}});
    }
    void variable(const Variable& v, const BlockContext& at) {
        calls_.push_back({v, own(at), std::string(v.name), std::string(v.text), {}});
    }
    void offset(const OffsetWrite& o, const BlockContext& at) {
        calls_.push_back(
            {o, own(at), std::string(o.table), std::string(o.axis), std::string(o.zero_name)});
    }
    void message(std::string_view text, const BlockContext& at) {
        calls_.push_back({Message{}, own(at), std::string(text), {}, {}});
    }
    void print(std::string_view text, const BlockContext& at) {
        calls_.push_back({Print{}, own(at), std::string(text), {}, {}});
    }
    void parameter(std::string_view line, const BlockContext& at) {
        calls_.push_back({Parameter{}, own(at), std::string(line), {}, {}});
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) {
        calls_.push_back({w, own(at), std::string(w.field), std::string(w.text), {}});
    }
    void life_group(const LifeGroup& g, const BlockContext& at) {
        calls_.push_back({g, own(at), {}, {}, {}});
    }
    void signal(std::string_view name, double value, const BlockContext& at) {
        calls_.push_back({Signal{value}, own(at), std::string(name), {}, {}});
    }
    void interrupts(const Interrupts& i, const BlockContext& at) {
        calls_.push_back({i, own(at), {}, {}, {}});
    }
    void stop(const Stop& s, const BlockContext& at) { calls_.push_back({s, own(at), {}, {}, {}}); }
    void part(double count, const BlockContext& at) {
        calls_.push_back({Part{count}, own(at), {}, {}, {}});
    }
    void barrier(const BlockContext& at) { calls_.push_back({Barrier{}, own(at), {}, {}, {}}); }
    void block_end(const BlockContext& at) { calls_.push_back({BlockEnd{}, own(at), {}, {}, {}}); }

    // a call to a later stage
    void control(std::function<void()> told) {
        calls_.push_back({std::move(told), {}, {}, {}, {}});
    }

    bool empty() const { return calls_.empty(); }
    void clear() { calls_.clear(); }
    bool will_halt() const;
    // Gives `move` for each held move: it may be completed when the nose's place is known.
    template <class Change>
    void change_moves(Change&& change) {
        for (Call& call : calls_)
            if (Move* m = std::get_if<Move>(&call.what); m && !m->beside) change(*m);
    }
    void append(HeldCalls& more);  // takes all of them
    // Makes the calls up to and with the first that halts; true: it halted.
    bool pass_on(Sink& to);
    // Likewise, but a call that would halt is forgotten with everything behind it: an error has
    // come in between.
    void pass_on_before_halt(Sink& to);

private:
    struct Message {};
    struct Print {};
    struct Parameter {};
    struct Signal {
        double value;
    };
    struct Part {
        double count;
    };
    struct Barrier {};
    struct BlockEnd {};
    struct Call {
        std::variant<Move, Dwell, Aux, Spindle, Wait, Variable, OffsetWrite, ToolWrite, LifeGroup,
                     Message, Print, Parameter, Signal, Interrupts, Stop, Part, Barrier, BlockEnd,
                     std::function<void()>>
            what;
        BlockContext at;
        std::string text, second, third;
    };
    // Names of tools and cycles live longer than a block (tables, the store's view); texts of the
    // calls do not.
    static BlockContext own(const BlockContext& at) { return at; }
    static bool halts(const Call& call);
    static void make(Call& call, Sink& to);

    std::deque<Call> calls_;
};

}  // namespace polyturn::channels::compensation
