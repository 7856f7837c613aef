// Balance cut (fanuc G68, G69 with PT_BALANCE): two turrets on opposite sides of a slender part
// begin each run of cuts together.
//
//   channel 1   ---rapid---|==cut==cut==|--rapid--|==cut==
//   channel 2   --rapid----|==cut==cut==|-rapid---|==cut==
//
// |  rendezvous of both at the first cut of a run: on the fly where the partner is there already
//
// Behind compensation, so that what is inserted there belongs to the run. What slows or holds one
// of the two does so to both while it lasts: kernel, CN_BALANCE.
#pragma once
#include "channels/forwarding_sink.hpp"
#include "ipc/image/balance.hpp"

namespace polyturn::channels {

class BalanceSink final : public ForwardingSink {
public:
    explicit BalanceSink(Sink& next) : ForwardingSink(&next) {}
    void between(unsigned channel, unsigned partner) {
        both_ = 1u << (channel - 1) | 1u << (partner - 1);
        partner_ = partner;
    }
    void restart() {
        on_ = cuts_ = false;
        serial_ = 0;
    }

    void signal(std::string_view name, double value, const BlockContext& at) override {
        if (name != "BALANCE") return next_->signal(name, value, at);
        const bool on = value != 0;
        if (on == on_) return;
        if (!on) next_->signal("CN_BALANCE", 0, at);
        next_->wait({on ? kBalanceMeeting : kBalanceEnd, on ? "G68" : "G69", both_}, at);
        if (on) next_->signal("CN_BALANCE", partner_, at);
        on_ = on;
        cuts_ = false;
    }
    void move(const Move& m, const BlockContext& at) override {
        if (on_) begin(m, at);
        next_->move(m, at);
    }
    void dwell(const Dwell& d, const BlockContext& at) override {
        cuts_ = false;
        next_->dwell(d, at);
    }
    void aux(const Aux& a, const BlockContext& at) override {
        cuts_ = false;
        next_->aux(a, at);
    }

private:
    void begin(const Move& m, const BlockContext& at) {
        // interpreted again from a point in the middle (a change in hold): the rendezvous is over
        if (at.serial < serial_) cuts_ = true;
        serial_ = at.serial;
        const bool cut = m.kind == MoveKind::Linear || m.kind == MoveKind::ArcCw ||
                         m.kind == MoveKind::ArcCcw || m.kind == MoveKind::Thread;
        if (cut && !cuts_) {
            Wait meeting{kBalanceMeeting, "G68", both_};
            meeting.flying = true;
            next_->wait(meeting, at);
        }
        cuts_ = cut;
    }
    std::uint32_t both_ = 0, partner_ = 0;
    std::uint64_t serial_ = 0;
    bool on_ = false, cuts_ = false;
};

}  // namespace polyturn::channels
