// Who may pass a wait, and who may start at the block of a restart, as one would say it
// (docs/design/waits.md). Knows nothing of boards, runs and groups' numbers: what the kernel does
// is compared with this.
#pragma once
#include <vector>

#include "kernel/waits/waits.hpp"

namespace polyturn::kernel {

struct Model {
    static constexpr int kNone = -1, kEnd = WaitBoard::kProgramEnd;
    enum Where { Reset, Runs, Stops, Dead };  // Stops: an alarm has
    struct Channel {
        Where where = Reset;
        bool by_hand = false, dry = false, nowt = false, held = false;
        bool searches = false, at_block = false;  // of a restart
        bool complete = false;                    // its restart was, when it was looked at last
        // its restart was refused: a start begins nothing
        bool not_meant = false;
        bool cut_off = false;  // its process died in a program
        int code = kNone;      // it stands at
        unsigned set = 0;
        // channels that restart with it and have not started; 0 none
        unsigned together = 0;
        bool restarts() const { return searches || at_block; }
    };
    std::vector<Channel> c;

    // What leads it to a code: 0 a cut, 1 a dry run, 2 a block by hand, 3 a search.
    static int kind(const Channel& a) { return a.searches ? 3 : a.by_hand ? 2 : a.dry ? 1 : 0; }
    static bool there(const Channel& a) { return a.where == Runs && a.code != kNone; }
    static bool like(const Channel& a, const Channel& b) {
        return kind(a) == kind(b) && (!a.searches || a.together == b.together);
    }
    bool met(const Channel& a, const Channel& b) const {
        if (a.code == kEnd) return !a.searches && b.where == Reset && !b.cut_off;
        return there(b) && b.code == a.code && b.set == a.set && like(a, b);
    }
    bool open(unsigned l) const {
        const Channel& a = c[l];
        if (!there(a)) return false;
        if (a.nowt) return true;
        for (unsigned k = 0; k < c.size(); ++k)
            if (k != l && (a.set >> k & 1u) && !c[k].nowt && !met(a, c[k])) return false;
        return true;
    }
    void end(unsigned l, Where where) {
        Channel& a = c[l];
        a.where = where;
        a.code = kNone;
        a.held = a.searches = a.at_block = a.by_hand = false;
        a.together = 0;
    }
    // `l` will not come to its block: nobody of its restart who has not started goes on.
    void leave(unsigned l, Where where) {
        const bool restarted = c[l].restarts();
        const unsigned with = c[l].together;
        end(l, where);
        if (!restarted) return;
        // back to reset, all of them
        if (where == Stops) {
            c[l].where = Reset;
            c[l].not_meant = true;
        }
        for (unsigned k = 0; k < c.size(); ++k)
            if (k != l && c[k].restarts() && c[k].together == with) {
                end(k, Reset);
                c[k].not_meant = true;
            }
    }
    bool all_at_block(unsigned l) const {
        for (const Channel& k : c)
            if (k.restarts() && k.together == c[l].together && !k.at_block) return false;
        return true;
    }
    // Until nothing changes any more.
    void settle(unsigned newcomer) {
        for (bool again = true; again;) {
            again = false;
            unsigned go = 0;
            for (unsigned l = 0; l < c.size(); ++l) go |= open(l) ? 1u << l : 0u;
            for (unsigned l = 0; l < c.size(); ++l)
                if (go >> l & 1u) {
                    c[l].code = kNone;
                    again = true;
                }
            // at other codes they would wait for each other for ever
            if (newcomer < c.size() && there(c[newcomer])) {
                bool circle = false;
                for (unsigned k = 0; k < c.size(); ++k)
                    circle = circle || (k != newcomer && (c[newcomer].set >> k & 1u) &&
                                        !c[k].nowt && there(c[k]) && like(c[newcomer], c[k]) &&
                                        (c[k].code != c[newcomer].code || c[k].code == kEnd));
                if (circle) {
                    leave(newcomer, Stops);
                    again = true;
                }
            }
            newcomer = kMaxChannels;
            for (unsigned l = 0; l < c.size(); ++l)
                for (unsigned k = 0; k < c.size(); ++k)
                    if (there(c[l]) && c[l].searches && c[k].at_block &&
                        c[k].together == c[l].together && (c[l].set >> k & 1u) && !c[k].nowt &&
                        !met(c[l], c[k])) {
                        leave(l, Stops);
                        again = true;
                        break;
                    }
        }
    }
};

}  // namespace polyturn::kernel
