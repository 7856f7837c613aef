// Who may pass a wait, and who may start at the block of a restart, against a model of plain lines:
// the same seeded orders of keys, alarms and deaths drive it and the real machine, with 2 to 16
// channels.
#include <algorithm>
#include <random>
#include <sstream>

#include "tests/seeds.hpp"
#include "tests/unit/kernel/rig.hpp"
#include "tests/unit/kernel/waits/plain_meetings.hpp"

namespace polyturn::kernel {
namespace {

constexpr int kNone = Model::kNone, kEnd = Model::kEnd;

class Lockstep : public TickRig {
public:
    Lockstep(unsigned channels, unsigned focus)
        : TickRig([&](params::Table& t, RunOptions&) {
              for (unsigned l = 1; l <= channels; ++l) {
                  params::put(t, params::n0000_machine_group, 1, l);
                  params::put(t, params::n0604_default_spindle, 1, l);
              }
          }) {
        on_tick = [this] { answer_more(); };
        for (unsigned l = 4; l <= channels; ++l) {
            channel.push_back(std::make_unique<ChannelSegment>());
            machine->attach_channel(l - 1, *channel.back());
            machine->channel(l - 1).select(kProgram, 0);
        }
        model.c.resize(channels);
        focus_ = team_of(focus % channels, channels);
    }

    // One event, drawn and done to both; what it was.
    std::string step(std::mt19937& random) {
        const auto n = static_cast<unsigned>(model.c.size());
        unsigned newcomer = kMaxChannels;
        std::ostringstream what;
        while (what.tellp() == 0) newcomer = draw(random, what);
        // What restarted and has come to its block, or a member's end, is looked at between the
        // commands.
        model.settle(newcomer);
        run(7);
        for (unsigned k = 0; k < n; ++k)
            model.c[k].complete = model.c[k].at_block && model.all_at_block(k);
        return what.str();
    }

    // One event, if it is possible just now; who has come to a code with it.
    unsigned draw(std::mt19937& random, std::ostringstream& what) {
        const auto n = static_cast<unsigned>(model.c.size());
        // Most of it happens to one team: of many channels two would seldom come to the same code.
        unsigned l = random() % n;
        if (random() % 4)
            while (!(focus_ >> l & 1u)) l = random() % n;
        const unsigned team = team_of(l, n);
        Model::Channel& a = model.c[l];
        unsigned newcomer = kMaxChannels;
        const auto told = [&](const char* word) -> std::ostringstream& {
            what << word << " L" << l + 1 << ' ';
            return what;
        };
        switch (random() % 18) {
            case 0:
            case 1:  // a start that begins nothing is rare, and pressed all the same
                if (a.where == Model::Reset || a.at_block || a.held || random() % 8 == 0) {
                    press_start(l);
                    told("start");
                }
                break;
            case 2:
            case 3:
            case 4:
            case 5:
            case 6:
                if (a.where != Model::Runs || a.code != kNone || a.held || a.at_block) break;
                a.set = a.searches ? team & a.together : team;
                a.code = random() % 8 ? 500 : random() % 2 ? 501 : kEnd;
                push(l + 1, wait(l + 1, a.code, a.set));
                newcomer = l;
                told("arrive") << a.code;
                break;
            case 7:
                if (a.where == Model::Runs && (a.code != kNone || random() % 4 == 0)) {
                    machine->channel(l).fault(Alarm::InterlockStop, "model", 0);
                    model.leave(l, Model::Stops);
                    told("alarm");
                }
                break;
            case 8: {
                command(CommandKind::Reset, l + 1);
                if (a.where != Model::Dead) model.leave(l, Model::Reset);
                a.not_meant = a.cut_off = false;
                told("reset");
                break;
            }
            case 9:
                if (random() % 3) break;
                if (a.where != Model::Dead) {
                    command(CommandKind::ProcessDied, 0, 0, 0,
                            static_cast<std::uint32_t>(kProcessChannel) + l);
                    a.cut_off = a.cut_off || a.where == Model::Runs || a.where == Model::Stops;
                    model.leave(l, Model::Dead);
                    told("death");
                }
                break;
            case 10:
                if (a.where == Model::Dead) {
                    revive(l);
                    told("successor");
                }
                break;
            case 11:
                if (a.where == Model::Runs && !a.restarts() && !a.held) {
                    command(CommandKind::FeedHold, l + 1);
                    a.held = true;
                    told("hold");
                }
                break;
            case 12:
            case 13:
                if (a.where == Model::Reset || random() % 8 == 0) restart(random, team, what);
                break;
            case 14:
            case 15:
            case 16:
                if (a.searches && a.code == kNone) {
                    push(l + 1, stop(l + 1, StopReason::Restart));
                    a.searches = false;
                    a.at_block = true;
                    told("at block");
                } else if (a.where == Model::Runs && a.code == kNone && !a.held && !a.at_block &&
                           random() % 2) {
                    push(l + 1, stop(l + 1, StopReason::M30));
                    model.leave(l, Model::Reset);
                    told("end");
                }
                break;
            default:
                if (random() % 3 == 0) rarely(random, l, what);
        }
        return newcomer;
    }

    // The first channel that is not what the model says; empty: none.
    std::string differs() const {
        for (unsigned l = 0; l < model.c.size(); ++l) {
            const Model::Channel& a = model.c[l];
            const ChannelState is = state(l + 1);
            bool same = false;
            switch (a.where) {
                case Model::Reset:
                    same = is == ChannelState::Reset || is == ChannelState::Ended;
                    break;
                case Model::Stops:
                    same = is == ChannelState::Interrupted;
                    break;
                case Model::Dead:
                    same = is == ChannelState::Dead;
                    break;
                case Model::Runs:
                    same = is == (a.code != kNone ? ChannelState::Waiting
                                  : a.at_block    ? ChannelState::ProgramStop
                                  : a.held        ? ChannelState::Held
                                                  : ChannelState::Running);
                    break;
            }
            if (same) continue;
            std::ostringstream out;
            out << "L" << l + 1 << " is in state " << static_cast<int>(is) << "; the model: where "
                << a.where << " code " << a.code << " searches " << a.searches << " at block "
                << a.at_block << " held " << a.held;
            return out.str();
        }
        return {};
    }

    Model model;

private:
    // Who meets whom: pairs, threes, a larger team at the end. Of one team all sets are the same.
    static unsigned team_of(unsigned l, unsigned n) {
        unsigned first = 0;
        for (unsigned size = 2; first < n; size = first < 5 ? 3 : first < 10 ? 2 : 5) {
            const unsigned last = first + size + 1 >= n ? n : first + size;
            if (l < last) return ((1u << last) - 1) & ~((1u << first) - 1);
            first = last;
        }
        return 1u << l;
    }
    void press_start(unsigned l) {
        Model::Channel& a = model.c[l];
        if (a.where == Model::Reset)
            command(CommandKind::Mode, l + 1, static_cast<double>(ChannelMode::Auto));
        start(l + 1);
        if (a.where == Model::Reset && !a.not_meant)
            begin(a, false);
        else if (a.where == Model::Runs && a.at_block && a.complete) {
            a.at_block = false;
            a.together = 0;
        } else if (a.where == Model::Runs)
            a.held = false;
    }
    static void begin(Model::Channel& a, bool by_hand) {
        a.where = Model::Runs;
        a.by_hand = by_hand;
        a.cut_off = a.held = false;
    }
    void restart(std::mt19937& random, unsigned team, std::ostringstream& what) {
        unsigned set = 0;
        for (unsigned k = 0; k < model.c.size(); ++k)
            if ((team >> k & 1u) && random() % 4) set |= 1u << k;
        bool over = false;
        unsigned begun = 0;
        what << "restart " << set << ' ';
        for (unsigned k = 0; k < model.c.size(); ++k) {
            if (!(set >> k & 1u)) continue;
            // a restart does not change it
            command(CommandKind::Mode, k + 1, static_cast<double>(ChannelMode::Auto));
            command(CommandKind::Restart, k + 1, 100, 0, 0, set);
            Model::Channel& a = model.c[k];
            if (over) continue;
            if (a.where == Model::Reset) {
                begin(a, false);
                a.searches = true;
                a.not_meant = false;
                a.together = set;
                begun |= 1u << k;
                continue;
            }
            over = true;
            for (unsigned b = 0; b < model.c.size(); ++b)
                if (begun >> b & 1u) {
                    model.end(b, Model::Reset);
                    model.c[b].not_meant = true;
                }
        }
    }
    void rarely(std::mt19937& random, unsigned l, std::ostringstream& what) {
        Model::Channel& a = model.c[l];
        switch (random() % 4) {
            case 0:
                a.dry = !a.dry;
                command(CommandKind::DryRun, l + 1, a.dry);
                what << "dry run L" << l + 1 << '=' << a.dry;
                break;
            case 1:
                a.nowt = !a.nowt;
                command(CommandKind::SetSignal, 0, a.nowt, 0, signals::cp_nowt(l + 1), 1);
                what << "ignore waits L" << l + 1 << '=' << a.nowt;
                break;
            case 2:
                if (a.where != Model::Reset) break;
                command(CommandKind::Mode, l + 1, static_cast<double>(ChannelMode::Mdi));
                command(CommandKind::Mdi, l + 1, 0, 0, 0, 0, "M500 P12");
                start(l + 1);
                begin(a, true);
                what << "block by hand L" << l + 1;
                break;
            default:
                command(CommandKind::Reset);
                for (unsigned k = 0; k < model.c.size(); ++k) {
                    if (model.c[k].where != Model::Dead) model.end(k, Model::Reset);
                    model.c[k].not_meant = model.c[k].cut_off = false;
                }
                what << "reset all";
        }
    }
    void revive(unsigned l) {
        Model::Channel& a = model.c[l];
        run(3);
        gone_.push_back(std::move(channel[l]));  // events of this tick may still look at it
        channel[l] = std::make_unique<ChannelSegment>();
        kernel->events[l].head.store(0);
        machine->attach_channel(l, *channel[l]);
        machine->channel(l).select(kProgram, 0);
        a.where = Model::Reset;
        a.not_meant = false;
    }
    void answer_more() {
        for (std::size_t l = 3; l < channel.size(); ++l) {
            auto& tail = channel[l]->event_tail.tail;
            for (const auto head = kernel->events[l].head.load(); tail.load() < head;
                 tail.fetch_add(1)) {
                const ChannelEvent& event = kernel->events[l].slot(tail.load());
                if (event.kind == static_cast<std::uint32_t>(ChannelEventKind::Reset))
                    channel[l]->epoch.store(event.epoch);
                channel[l]->quiet.store(event.seq);
            }
        }
        if (log.size() > 1000) log.clear();
        for (auto& one : heard) one.clear();
    }
    unsigned focus_ = 0;
    std::vector<std::unique_ptr<ChannelSegment>> gone_;
};

void run_order(unsigned seed, unsigned channels, unsigned focus) {
    std::mt19937 random(test_seed(seed));
    Lockstep both(channels, focus);
    std::string steps;
    for (int step = 0; step < 60; ++step) {
        steps += both.step(random) + "; ";
        const std::string difference = both.differs();
        ASSERT_TRUE(difference.empty())
            << "seed " << seed << ", " << channels << " channels, focus " << focus << ", step "
            << step << ": " << steps << '\n'
            << difference;
    }
}
unsigned orders_of_env(unsigned without) {
    // more of them than each build has time for
    const char* wanted = std::getenv("POLYTURN_ORDERS");
    return wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : without;
}

TEST(MeetingsModel, TheMachineDoesWhatThePlainRulesSayInEveryOrderOfKeysAlarmsAndDeaths) {
    for (unsigned order = 0, last = orders_of_env(120); order < last && !HasFatalFailure(); ++order)
        run_order(order + 1, 2 + order % 15, order / 15);
}

}  // namespace
}  // namespace polyturn::kernel
