// A Core on the test lathe (X diameter, Z, C; optionally Y), whose deliveries are kept.
#pragma once
#include <vector>

#include "../play.hpp"

namespace polyturn::channels::testing {

struct Kept {
    char what = 'm';  // m move, a aux, d dwell, e block end, b barrier, o anything else
    Move move;
    BlockContext at;
    double value = 0.0;
};

class KeepingSink final : public Sink {
public:
    std::vector<Kept> calls;
    std::vector<Kept> moves() const {
        std::vector<Kept> out;
        for (const Kept& call : calls)
            if (call.what == 'm') out.push_back(call);
        return out;
    }
    void move(const Move& m, const BlockContext& at) override { calls.push_back({'m', m, at, 0}); }
    void dwell(const Dwell& d, const BlockContext& at) override {
        calls.push_back({'d', {}, at, d.value});
    }
    void aux(const Aux& a, const BlockContext& at) override {
        calls.push_back({'a', {}, at, a.value});
    }
    void spindle(const Spindle&, const BlockContext& at) override {
        calls.push_back({'o', {}, at, 0});
    }
    void wait(const Wait&, const BlockContext& at) override { calls.push_back({'o', {}, at, 0}); }
    void variable(const Variable&, const BlockContext& at) override {
        calls.push_back({'o', {}, at, 0});
    }
    void offset(const OffsetWrite&, const BlockContext& at) override {
        calls.push_back({'o', {}, at, 0});
    }
    void message(std::string_view, const BlockContext& at) override {
        calls.push_back({'o', {}, at, 0});
    }
    void stop(const Stop&, const BlockContext& at) override { calls.push_back({'o', {}, at, 0}); }
    void part(double, const BlockContext& at) override { calls.push_back({'o', {}, at, 0}); }
    void alarm(const Diagnosis&, const BlockContext& at) override {
        calls.push_back({'o', {}, at, 0});
    }
    void barrier(const BlockContext& at) override { calls.push_back({'b', {}, at, 0}); }
    void block_end(const BlockContext& at) override { calls.push_back({'e', {}, at, 0}); }
};

struct CoreRig {
    std::unique_ptr<params::Table> table;
    MachineView view;
    text::Setup setup;
    CheckPort port{setup, 1, true};
    KeepingSink sink;
    std::unique_ptr<Core> core;
    unsigned x, y = 0, z, c;

    explicit CoreRig(bool with_y = false)
        : table(lathe(with_y
                          ? std::vector<std::string>{"N0002 A16=1", "N0100 A16=89", "N0103 A16=2"}
                          : std::vector<std::string>{})),
          view(make_machine_view(*table, 1)) {
        core = std::make_unique<Core>(view, sink, port);
        core->start_at_machine({});
        core->path.feed = 100.0;
        const auto place = [this](const char* name) {
            return static_cast<unsigned>(view.axis_by_name(name));
        };
        x = place("X");
        z = place("Z");
        c = place("C");
        if (with_y) y = place("Y");
    }
    AxisValues to(double px, double pz) const {
        AxisValues t = core->path.programmed;
        t[x] = px;
        t[z] = pz;
        return t;
    }
    bool line(double px, double pz) { return core->linear(to(px, pz)); }
    bool arc(double px, double pz, double cx, double cz, bool clockwise) {
        ArcCall call;
        call.clockwise = clockwise;
        call.centre_p = cz;
        call.centre_q = cx;
        return core->arc(to(px, pz), call);
    }
};

}  // namespace polyturn::channels::testing
