// Every order of keys, alarms and arrivals with two and with three channels, breadth first until no
// new state is found: the board of waits and the groups of restarts, used as Machine and
// ChannelRunner use them, against the rules in plain words.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "kernel/waits/restart_groups.hpp"
#include "tests/unit/kernel/waits/plain_meetings.hpp"

namespace polyturn::kernel {
namespace {

// What Machine::run_channels and ChannelRunner do with the two, and nothing else of them.
struct Kernel {
    struct Channel {
        enum State { Reset, Runs, Stops } state = Reset;
        bool held = false, waits = false, judged = false, refused = false, complete = false;
        enum { None, Searching, AtBlock } restart = None;
        std::uint32_t group = 0;
        std::uint64_t run = 0;
    };
    WaitBoard board;
    RestartGroups groups;
    std::array<Channel, 3> c{};
    unsigned count = 2;
    std::int64_t now = 0;

    RestartFate fate(unsigned l) const {
        const Channel& a = c[l];
        if (a.state == Channel::Reset) return RestartFate::Reset;
        if (a.state == Channel::Stops) return RestartFate::Alarm;
        return a.restart == Channel::Searching ? RestartFate::Searching
               : a.restart == Channel::AtBlock ? RestartFate::AtBlock
                                               : RestartFate::Started;
    }
    void reset(unsigned l) {
        board.leave(l);
        const std::uint64_t run = c[l].run + 1;
        c[l] = {};
        c[l].run = run;
    }
    void alarm(unsigned l) {
        c[l].state = Channel::Stops;
        c[l].held = c[l].waits = false;
    }
    void refuse(const RestartGroups::Refusal& refusal) {
        for (unsigned l = 0; l < count; ++l)
            if (refusal.back >> l & 1u) {
                reset(l);
                c[l].refused = true;
            }
    }
    void judge() {
        if (!groups.any()) return;
        groups.judge(
            now, 1000, [&](unsigned l) { return fate(l); },
            [&](const RestartGroups::Refusal& refusal) { refuse(refusal); });
        for (unsigned l = 0; l < count; ++l) c[l].complete = groups.complete(l);
    }
    void begin(unsigned l) {
        ++c[l].run;
        c[l].state = Channel::Runs;
    }
    void start(unsigned l) {
        judge();
        Channel& a = c[l];
        if (a.state == Channel::Reset && !a.refused)
            begin(l);
        else if (a.state == Channel::Runs && a.restart == Channel::AtBlock && a.complete &&
                 !a.refused) {
            board.take_search(l);
            a.restart = Channel::None;
        } else if (a.state == Channel::Runs)
            a.held = false;
    }
    void restart(unsigned set) {
        for (unsigned l = 0; l < count; ++l) {
            if (!(set >> l & 1u)) continue;
            const RestartGroups::Asked asked = groups.ask(l, set, now);
            if (asked.over) continue;
            if (c[l].state != Channel::Reset) {
                refuse(groups.refused(asked, l));
                continue;
            }
            c[l].refused = false;
            c[l].restart = Channel::Searching;
            c[l].group = asked.id;
            board.begin_search(l);
            begin(l);
            groups.began(asked, l);
        }
    }
    void arrive(unsigned l, int code, unsigned set) {
        const bool searches = c[l].restart == Channel::Searching;
        board.arrive(l, code, set, c[l].run,
                     searches ? WaitPhase{WaitKind::Search, c[l].group} : WaitPhase{});
        c[l].waits = true;
        c[l].judged = false;
    }
    void end(unsigned l) {
        ++c[l].run;
        c[l].state = Channel::Reset;
        c[l].held = false;
    }
    void tick() {
        ++now;
        judge();
        for (unsigned l = 0; l < count; ++l)
            board.tell(
                l, {c[l].run, c[l].state == Channel::Runs, false, c[l].state == Channel::Reset});
        const ChannelSet released = board.release(0);
        for (unsigned l = 0; l < count; ++l)
            if (released >> l & 1u) c[l].waits = false;
        for (unsigned l = 0; l < count; ++l) {
            if (!c[l].waits || c[l].state != Channel::Runs) continue;
            if (!c[l].judged) {
                c[l].judged = true;
                if (board.judge(l, 0).fault != WaitBoard::Fault::None) {
                    alarm(l);
                    continue;
                }
            }
            const ChannelSet missing = board.missing(l, 0);
            for (unsigned k = 0; k < count; ++k)
                if ((missing >> k & 1u) && c[l].restart == Channel::Searching &&
                    c[k].restart == Channel::AtBlock) {
                    alarm(l);
                    break;
                }
        }
        judge();
    }
};

struct Both {
    Kernel kernel;
    Model plain;

    void settle(unsigned newcomer = kMaxChannels) {
        plain.settle(newcomer);
        for (int t = 0; t < 5; ++t) kernel.tick();
        for (unsigned k = 0; k < plain.c.size(); ++k)
            plain.c[k].complete = plain.c[k].at_block && plain.all_at_block(k);
    }
    // What both are, with nothing in it that only counts on.
    std::string key() const {
        std::string out;
        std::map<unsigned, char> group;
        for (unsigned l = 0; l < plain.c.size(); ++l) {
            const Model::Channel& a = plain.c[l];
            const Kernel::Channel& b = kernel.c[l];
            if (b.restart != Kernel::Channel::None)
                group.emplace(b.group, static_cast<char>('a' + group.size()));
            const WaitBoard::Arrival& at = kernel.board.at(l);
            for (const int n :
                 {static_cast<int>(a.where), int{a.held}, int{a.searches}, int{a.at_block},
                  int{a.complete}, int{a.not_meant}, a.code, static_cast<int>(a.set),
                  static_cast<int>(a.together), static_cast<int>(b.state), int{b.held},
                  int{b.waits}, int{b.judged}, int{b.refused}, int{b.complete},
                  static_cast<int>(b.restart), int{kernel.board.counts(l)}, at.here ? at.code : 0,
                  at.here ? static_cast<int>(at.set) : 0})
                out += static_cast<char>(n);
            out += b.restart != Kernel::Channel::None ? group[b.group] : '-';
        }
        return out + (kernel.groups.any() ? '1' : '0');
    }
    std::string differs() const {
        for (unsigned l = 0; l < plain.c.size(); ++l) {
            const Model::Channel& a = plain.c[l];
            const Kernel::Channel& b = kernel.c[l];
            const bool same = static_cast<int>(a.where) == static_cast<int>(b.state) &&
                              (a.where != Model::Runs ||
                               ((a.code != Model::kNone) == b.waits && a.held == b.held &&
                                a.searches == (b.restart == Kernel::Channel::Searching) &&
                                a.at_block == (b.restart == Kernel::Channel::AtBlock))) &&
                              (a.where != Model::Reset || a.not_meant == b.refused);
            if (same) continue;
            std::ostringstream out;
            out << "L" << l + 1 << ": the kernel " << b.state << " waits " << b.waits << " held "
                << b.held << " restart " << b.restart << " refused " << b.refused << "; the rules "
                << a.where << " code " << a.code << " held " << a.held << " searches " << a.searches
                << " at block " << a.at_block << " not meant " << a.not_meant;
            return out.str();
        }
        return {};
    }
};

struct Event {
    std::string name;
    // False: it is not possible just now.
    std::function<bool(Both&)> act;
};

std::vector<Event> events_of(unsigned count) {
    std::vector<Event> out;
    const unsigned all = (1u << count) - 1;
    for (unsigned l = 0; l < count; ++l) {
        const std::string who = " L" + std::to_string(l + 1);
        out.push_back({"start" + who, [l](Both& both) {
                           Model::Channel& a = both.plain.c[l];
                           both.kernel.start(l);
                           if (a.where == Model::Reset && !a.not_meant) {
                               a.where = Model::Runs;
                               a.held = false;
                           } else if (a.where == Model::Runs && a.at_block && a.complete) {
                               a.at_block = false;
                               a.together = 0;
                           } else if (a.where == Model::Runs)
                               a.held = false;
                           both.settle();
                           return true;
                       }});
        for (const int code : {500, 501, Model::kEnd})
            out.push_back({"arrive " + std::to_string(code) + who, [l, code, all](Both& both) {
                               Model::Channel& a = both.plain.c[l];
                               if (a.where != Model::Runs || a.code != Model::kNone || a.held ||
                                   a.at_block)
                                   return false;
                               a.code = code;
                               a.set = a.searches ? a.together : all;
                               both.kernel.arrive(l, code, a.set);
                               both.settle(l);
                               return true;
                           }});
        out.push_back({"reset" + who, [l](Both& both) {
                           both.kernel.reset(l);
                           both.plain.leave(l, Model::Reset);
                           both.plain.c[l].not_meant = false;
                           both.settle();
                           return true;
                       }});
        out.push_back({"alarm" + who, [l](Both& both) {
                           if (both.plain.c[l].where != Model::Runs) return false;
                           both.kernel.alarm(l);
                           both.plain.leave(l, Model::Stops);
                           both.settle();
                           return true;
                       }});
        out.push_back({"hold" + who, [l](Both& both) {
                           Model::Channel& a = both.plain.c[l];
                           if (a.where != Model::Runs || a.restarts() || a.held) return false;
                           a.held = both.kernel.c[l].held = true;
                           both.settle();
                           return true;
                       }});
        out.push_back({"end" + who, [l](Both& both) {
                           const Model::Channel& a = both.plain.c[l];
                           if (a.where != Model::Runs || a.code != Model::kNone || a.held ||
                               a.restarts())
                               return false;
                           both.kernel.end(l);
                           both.plain.leave(l, Model::Reset);
                           both.settle();
                           return true;
                       }});
        out.push_back({"at block" + who, [l](Both& both) {
                           Model::Channel& a = both.plain.c[l];
                           if (!a.searches || a.code != Model::kNone) return false;
                           a.searches = false;
                           a.at_block = true;
                           both.kernel.c[l].restart = Kernel::Channel::AtBlock;
                           both.settle();
                           return true;
                       }});
    }
    for (unsigned set = 1; set <= all; ++set)
        out.push_back({"restart " + std::to_string(set), [set, count](Both& both) {
                           both.kernel.restart(set);
                           unsigned begun = 0;
                           for (unsigned k = 0; k < count; ++k) {
                               if (!(set >> k & 1u)) continue;
                               Model::Channel& a = both.plain.c[k];
                               if (a.where == Model::Reset) {
                                   a.where = Model::Runs;
                                   a.searches = true;
                                   a.held = a.not_meant = false;
                                   a.together = set;
                                   begun |= 1u << k;
                                   continue;
                               }
                               for (unsigned b = 0; b < count; ++b)
                                   if (begun >> b & 1u) {
                                       both.plain.end(b, Model::Reset);
                                       both.plain.c[b].not_meant = true;
                                   }
                               break;
                           }
                           both.settle();
                           return true;
                       }});
    return out;
}

struct Searched {
    std::size_t states = 0, steps = 0;
    unsigned depth = 0;
    bool closed = false;  // no event leads to a state that was not seen
    std::string difference;
};

Searched search(unsigned count, std::size_t most_states) {
    struct Node {
        std::size_t from = 0;
        std::string event;
        unsigned depth = 0;
    };
    Both first;
    first.kernel.count = count;
    first.plain.c.resize(count);
    first.settle();
    std::vector<Node> nodes{{}};
    std::map<std::string, std::size_t> seen{{first.key(), 0}};
    std::deque<std::pair<std::size_t, Both>> open;
    open.emplace_back(0, first);
    const std::vector<Event> events = events_of(count);
    Searched out;
    while (!open.empty() && nodes.size() < most_states) {
        const auto [at, from] = std::move(open.front());
        open.pop_front();
        for (const Event& event : events) {
            Both to = from;
            if (!event.act(to)) continue;
            ++out.steps;
            if (std::string difference = to.differs(); !difference.empty()) {
                std::string way = event.name;
                for (std::size_t n = at; n != 0; n = nodes[n].from)
                    way = nodes[n].event + "; " + way;
                out.difference = way + "\n" + difference;
                return out;
            }
            if (!seen.emplace(to.key(), nodes.size()).second) continue;
            nodes.push_back({at, event.name, nodes[at].depth + 1});
            out.depth = nodes.back().depth;
            open.emplace_back(nodes.size() - 1, std::move(to));
        }
    }
    out.states = nodes.size();
    out.closed = open.empty();
    return out;
}

TEST(MeetingsSearch, EveryOrderOfTwoChannelsDoesWhatThePlainRulesSay) {
    const Searched all = search(2, 1'000'000);
    EXPECT_TRUE(all.difference.empty()) << all.difference;
    EXPECT_TRUE(all.closed);
    std::cout << all.states << " states, " << all.steps << " steps, depth " << all.depth << '\n';
}

TEST(MeetingsSearch, EveryOrderOfThreeChannelsDoesWhatThePlainRulesSay) {
    const Searched all = search(3, 150'000);
    EXPECT_TRUE(all.difference.empty()) << all.difference;
    std::cout << all.states << " states, " << all.steps << " steps, depth " << all.depth
              << (all.closed ? ", closed" : "") << '\n';
}

}  // namespace
}  // namespace polyturn::kernel
