// A sink that hands everything on to the next one: a stage between Core and the machine derives
// from it and changes only what it is there for. A new kind of statement reaches the machine
// through all of them.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels {

class ForwardingSink : public Sink {
public:
    void move(const Move& m, const BlockContext& at) override { next_->move(m, at); }
    void dwell(const Dwell& d, const BlockContext& at) override { next_->dwell(d, at); }
    void aux(const Aux& a, const BlockContext& at) override { next_->aux(a, at); }
    void spindle(const Spindle& s, const BlockContext& at) override { next_->spindle(s, at); }
    void wait(const Wait& w, const BlockContext& at) override { next_->wait(w, at); }
    void variable(const Variable& v, const BlockContext& at) override { next_->variable(v, at); }
    void offset(const OffsetWrite& o, const BlockContext& at) override { next_->offset(o, at); }
    void message(std::string_view text, const BlockContext& at) override {
        next_->message(text, at);
    }
    void stop(const Stop& s, const BlockContext& at) override { next_->stop(s, at); }
    void part(double count, const BlockContext& at) override { next_->part(count, at); }
    void alarm(const Diagnosis& d, const BlockContext& at) override { next_->alarm(d, at); }
    void interrupts(const Interrupts& i, const BlockContext& at) override {
        next_->interrupts(i, at);
    }
    void print(std::string_view text, const BlockContext& at) override { next_->print(text, at); }
    void signal(std::string_view name, double value, const BlockContext& at) override {
        next_->signal(name, value, at);
    }
    void parameter(std::string_view line, const BlockContext& at) override {
        next_->parameter(line, at);
    }
    void tool_write(const ToolWrite& w, const BlockContext& at) override {
        next_->tool_write(w, at);
    }
    void life_group(const LifeGroup& g, const BlockContext& at) override {
        next_->life_group(g, at);
    }
    void barrier(const BlockContext& at) override { next_->barrier(at); }
    void block_end(const BlockContext& at) override { next_->block_end(at); }

protected:
    explicit ForwardingSink(Sink* next) : next_(next) {}
    Sink* next_;
};

}  // namespace polyturn::channels
