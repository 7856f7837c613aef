// The positions at which a program can go on when pushed records are discarded (architecture 5.6;
// see Language::resume_at).
//
// A point is noted for each block. What a plain move changes (positions) lies in the point itself;
// everything else lies in a full state that all points share until a block changes more than
// positions, so that a long contour costs a few words a block. What blocks have written into
// variables and tables comes back from the languages' undo logs, not from here.
//
//   blocks   N10 G1 F..   N20 X..   N30 X..   N40 M8   N50 X..
//   points      o           o         o         o        o
//   states      S1          S2 ------ S2 ------ S2       S3
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "channels/state/core.hpp"
#include "channels/text/line_source.hpp"

namespace polyturn::channels {

// State: what a language keeps beside the Core's path. It has a member `path` (PathState).
template <class State>
class ResumePoints {
public:
    struct Point {
        std::uint64_t serial = 0;
        TextPosition position;
        // byte in the line, where a language goes on inside of one
        std::size_t column = 0;
        AxisValues programmed{}, machine{};
        decltype(PathState::last_travel) last_travel{};
        // a block before it may be held back: no place to go on from
        bool compensated = false;
        std::shared_ptr<const State> state;
    };

    void clear() { points_.clear(); }

    // Before block `serial` acts. `changed`: the block before was more than a plain move; cleared.
    // `make` returns the full state.
    template <class Make>
    void note(const Core& core, std::uint64_t serial, TextPosition position, std::size_t column,
              bool& changed, Make&& make) {
        if (changed || points_.empty()) {
            auto state = std::make_shared<State>(make());
            state->path = core.path;
            latest_ = std::move(state);
            changed = false;
        }
        points_.push_back({serial, position, column, core.path.programmed, core.path.machine,
                           core.path.last_travel, core.reads_ahead(), latest_});
    }

    // Blocks before `serial` are done for good; the newest point stays.
    void executed(std::uint64_t serial) {
        while (points_.size() > 1 && points_.front().serial < serial) points_.pop_front();
    }

    const Point* find(std::uint64_t serial) const {
        for (auto point = points_.rbegin(); point != points_.rend() && point->serial >= serial;
             ++point)
            if (point->serial == serial) return &*point;
        return nullptr;
    }

    // May the program go on before block `serial`? No under a transformation: its barrier would
    // have to be repeated.
    bool may_go_back(const Core& core, std::uint64_t serial) const {
        const Point* point = find(serial);
        return point && !point->compensated && !core.transformed();
    }

    // Takes the Core back to before block `serial` and forgets what came behind; nothing: the
    // program cannot go on there. The language puts back its own part of the state.
    // `within_compensation`: also where blocks were held back; compensation is off then, and the
    // caller begins it again.
    std::optional<Point> back_to(Core& core, std::uint64_t serial,
                                 bool within_compensation = false) {
        while (!points_.empty() && points_.back().serial > serial) points_.pop_back();
        if (points_.empty() || points_.back().serial != serial ||
            (points_.back().compensated && !within_compensation))
            return std::nullopt;
        Point point = std::move(points_.back());
        points_.pop_back();
        core.compensation_reset();
        core.path = point.state->path;
        core.path.programmed = point.programmed;
        core.path.machine = point.machine;
        core.path.last_travel = point.last_travel;
        core.forget_pending();
        core.at.tool = core.path.tool.ref;
        return point;
    }

private:
    std::deque<Point> points_;
    std::shared_ptr<const State> latest_;
};

}  // namespace polyturn::channels
