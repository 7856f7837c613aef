#include "channels/compensation/held_calls.hpp"

namespace polyturn::channels::compensation {

bool HeldCalls::halts(const Call& call) {
    if (const Aux* aux = std::get_if<Aux>(&call.what)) return aux->drained;
    if (const Stop* stop = std::get_if<Stop>(&call.what))
        return stop->asked && (stop->reason == StopReason::M00 || stop->reason == StopReason::M01);
    if (const Wait* wait = std::get_if<Wait>(&call.what)) return wait->act != Wait::Act::Arrive;
    return std::holds_alternative<Barrier>(call.what);
}

bool HeldCalls::will_halt() const {
    for (const Call& call : calls_)
        if (halts(call)) return true;
    return false;
}

void HeldCalls::make(Call& call, Sink& to) {
    struct Maker {
        Call& call;
        Sink& to;
        void operator()(Move& m) { to.move(m, call.at); }
        void operator()(Dwell& d) { to.dwell(d, call.at); }
        void operator()(Aux& a) {
            a.text = call.text;
            a.name = call.second;
            to.aux(a, call.at);
        }
        void operator()(Spindle& s) { to.spindle(s, call.at); }
        void operator()(Wait& w) {
            w.marker = call.text;
            to.wait(w, call.at);
        }
        void operator()(Variable& v) {
            v.name = call.text;
            v.text = call.second;
            to.variable(v, call.at);
        }
        void operator()(OffsetWrite& o) {
            o.table = call.text;
            o.axis = call.second;
            o.zero_name = call.third;
            to.offset(o, call.at);
        }
        void operator()(ToolWrite& w) {
            w.field = call.text;
            w.text = call.second;
            to.tool_write(w, call.at);
        }
        void operator()(LifeGroup& g) { to.life_group(g, call.at); }
        void operator()(Message&) { to.message(call.text, call.at); }
        void operator()(Print&) { to.print(call.text, call.at); }
        void operator()(Parameter&) { to.parameter(call.text, call.at); }
        void operator()(Signal& s) { to.signal(call.text, s.value, call.at); }
        void operator()(Interrupts& i) { to.interrupts(i, call.at); }
        void operator()(Stop& s) { to.stop(s, call.at); }
        void operator()(Part& p) { to.part(p.count, call.at); }
        void operator()(Barrier&) { to.barrier(call.at); }
        void operator()(BlockEnd&) { to.block_end(call.at); }
        void operator()(std::function<void()>& told) { told(); }
    };
    std::visit(Maker{call, to}, call.what);
}

void HeldCalls::append(HeldCalls& more) {
    for (Call& call : more.calls_) calls_.push_back(std::move(call));
    more.calls_.clear();
}

bool HeldCalls::pass_on(Sink& to) {
    while (!calls_.empty()) {
        Call call = std::move(calls_.front());
        calls_.pop_front();
        make(call, to);
        if (halts(call)) return true;
    }
    return false;
}

void HeldCalls::pass_on_before_halt(Sink& to) {
    while (!calls_.empty() && !halts(calls_.front())) {
        make(calls_.front(), to);
        calls_.pop_front();
    }
    calls_.clear();
}

}  // namespace polyturn::channels::compensation
