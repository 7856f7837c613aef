// What stands between Core and the machine hands every kind of statement on, once and with its
// place.
#include "channels/forwarding_sink.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace polyturn::channels {
namespace {

// Writes down which statement arrived, and of which block.
struct Told final : Sink {
    std::vector<std::string> lines;
    void tell(const char* what, const BlockContext& at) {
        lines.push_back(std::string(what) + " " + std::to_string(at.line));
    }
    void move(const Move&, const BlockContext& at) override { tell("move", at); }
    void dwell(const Dwell&, const BlockContext& at) override { tell("dwell", at); }
    void aux(const Aux&, const BlockContext& at) override { tell("aux", at); }
    void spindle(const Spindle&, const BlockContext& at) override { tell("spindle", at); }
    void wait(const Wait&, const BlockContext& at) override { tell("wait", at); }
    void variable(const Variable&, const BlockContext& at) override { tell("variable", at); }
    void offset(const OffsetWrite&, const BlockContext& at) override { tell("offset", at); }
    void message(std::string_view, const BlockContext& at) override { tell("message", at); }
    void stop(const Stop&, const BlockContext& at) override { tell("stop", at); }
    void part(double, const BlockContext& at) override { tell("part", at); }
    void alarm(const Diagnosis&, const BlockContext& at) override { tell("alarm", at); }
    void interrupts(const Interrupts&, const BlockContext& at) override { tell("interrupts", at); }
    void print(std::string_view, const BlockContext& at) override { tell("print", at); }
    void signal(std::string_view, double, const BlockContext& at) override { tell("signal", at); }
    void tool_write(const ToolWrite&, const BlockContext& at) override { tell("tool", at); }
    void life_group(const LifeGroup&, const BlockContext& at) override { tell("group", at); }
    void barrier(const BlockContext& at) override { tell("barrier", at); }
    void block_end(const BlockContext& at) override { tell("block_end", at); }
};

struct Between final : ForwardingSink {
    explicit Between(Sink* next) : ForwardingSink(next) {}
};

TEST(ForwardingSink, HandsOnEveryStatement) {
    Told told;
    Between first(&told), second(&first);
    Sink& sink = second;
    BlockContext at;
    at.line = 7;
    sink.move({}, at);
    sink.dwell({}, at);
    sink.aux({}, at);
    sink.spindle({}, at);
    sink.wait({}, at);
    sink.variable({}, at);
    sink.offset({}, at);
    sink.message("", at);
    sink.stop({}, at);
    sink.part(1, at);
    sink.alarm({}, at);
    sink.interrupts({}, at);
    sink.print("", at);
    sink.signal("", 0, at);
    sink.tool_write({}, at);
    sink.life_group({}, at);
    sink.barrier(at);
    sink.block_end(at);
    EXPECT_EQ(told.lines,
              (std::vector<std::string>{"move 7", "dwell 7", "aux 7", "spindle 7", "wait 7",
                                        "variable 7", "offset 7", "message 7", "stop 7", "part 7",
                                        "alarm 7", "interrupts 7", "print 7", "signal 7", "tool 7",
                                        "group 7", "barrier 7", "block_end 7"}));
}

}  // namespace
}  // namespace polyturn::channels
