// A sink that takes everything and says nothing: tests and benches override what they look at.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::testing {

struct QuietSink : Sink {
    void move(const Move&, const BlockContext&) override {}
    void dwell(const Dwell&, const BlockContext&) override {}
    void aux(const Aux&, const BlockContext&) override {}
    void spindle(const Spindle&, const BlockContext&) override {}
    void wait(const Wait&, const BlockContext&) override {}
    void variable(const Variable&, const BlockContext&) override {}
    void offset(const OffsetWrite&, const BlockContext&) override {}
    void message(std::string_view, const BlockContext&) override {}
    void stop(const Stop&, const BlockContext&) override {}
    void part(double, const BlockContext&) override {}
    void alarm(const Diagnosis&, const BlockContext&) override {}
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}
};

}  // namespace polyturn::channels::testing
