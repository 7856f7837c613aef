// A synchronized action: a condition and what is done when it holds (sinumerik_part3 8).
//
//   ID=2 WHENEVER $A_IN[1]==1 DO $A_OUT[3]=1 M8
//   ~~~~ ~~~~~~~~ ~~~~~~~~~~~    ~~~~~~~~~~~~~~
//   id   when     condition      action
//
// The channel looks at its conditions where one output block ends and the next begins; both texts
// are read again each time.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace polyturn::channels::sinumerik {

struct SynchronizedAction {
    // no keyword, WHEN, WHENEVER, FROM, EVERY
    enum class When : std::uint8_t { Always, Once, Whenever, From, Edge };
    unsigned id = 0;         // 0: of the next output block only
    bool is_static = false;  // IDS: outlives its program
    When when = When::Always;
    std::string text;                             // the line
    std::size_t condition_at = 0, action_at = 0;  // bytes
    std::uint32_t line = 0;
    bool deletes_travel = false;  // DELDTG: looked at along the way, too
    // a way ended where its condition began to hold: so it holds there
    bool has_cut = false;
    bool locked = false;       // LOCK
    bool held_before = false;  // the condition, when it was looked at last
    bool began = false;        // From: it has held once; Once: it is done
    unsigned looks = 0;        // id 0: 1 at the beginning of its block, 2 at its end

    // The condition holds or not now: must the action be done?
    bool is_due(bool holds) {
        ++looks;
        const bool edge = holds && !held_before;
        held_before = holds;
        switch (when) {
            case When::Always:
                return id != 0 || looks == 1;
            case When::Once:
                if (!holds || began) return false;
                return began = true;
            case When::Whenever:
                return holds;
            case When::From:
                return began = began || holds;
            case When::Edge:
                return edge;
        }
        return false;
    }
    bool is_over() const { return (id == 0 && looks >= 2) || (when == When::Once && began); }
};

}  // namespace polyturn::channels::sinumerik
