#include "channels/cycles/thread_section.hpp"

#include <cmath>
#include <numbers>

#include "channels/cycles/cycle_moves.hpp"
#include "channels/cycles/thread_passes.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSameThread = 1e-9;  // mm

// How far pass k (from 1) begins aside: towards the cut or against it, as a share of depth *
// tan(angle).
double side_of(const ThreadSection& t, int k) {
    const bool odd = k % 2 == 1;
    switch (t.entry) {
        case 0:
            return 0.0;
        case 1:
            return 1.0;
        case 2:
            return odd ? 0.0 : 1.0;
        case 3:
            return -1.0;
        case 4:
            return odd ? 0.0 : -1.0;
        case 5:
            return odd ? 1.0 : -1.0;
        default:
            break;
    }
    if (t.angle_deg == 0.0) return 0.0;
    return t.angle_deg > 0 || odd ? 1.0 : -1.0;
}

class Threading {
public:
    Threading(CycleMoves& moves, const ThreadSection& t) : moves_(&moves), t_(&t) {
        s0_ = t.face ? t.start.x : t.start.z;
        h0_ = t.face ? t.start.z : t.start.x;
        s1_ = t.face ? t.end.x : t.end.z;
        h1_ = t.face ? t.end.z : t.end.x;
        way_ = s1_ >= s0_ ? 1.0 : -1.0;
        away_ = t.depth > 0 ? 1.0 : -1.0;
        slope_ = (h1_ - h0_) / (s1_ - s0_);
    }

    bool run(const std::vector<double>& depths) {
        for (int start = 0; start < t_->starts; ++start) {
            call_.lead = t_->lead;
            call_.lead_change = t_->lead_change;
            call_.by_axis = true;
            call_.axis = static_cast<std::uint8_t>(t_->face ? moves_->x() : moves_->z());
            call_.start_angle = std::fmod(t_->spindle_deg + start * 360.0 / t_->starts, 360.0);
            if (call_.start_angle < 0) call_.start_angle += 360.0;
            for (std::size_t k = 0; k <= depths.size(); ++k) {
                const bool last = k == depths.size();
                const double depth = last ? std::fabs(t_->depth) : depths[k];
                const bool straight = last && t_->finishing < 0;
                // L0: the previous pass once more, on its side (9.9.1)
                const bool again = last && t_->finishing == 0 && k > 0;
                const double aside =
                    straight ? 0.0
                             : side_of(*t_, static_cast<int>(k) + (again ? 0 : 1)) * depth *
                                   std::tan(std::fabs(t_->angle_deg) * std::numbers::pi / 180.0);
                if (!pass(depth, aside)) return false;
            }
        }
        return true;
    }

private:
    Point point(double s, double h) const { return t_->face ? Point{h, s} : Point{s, h}; }
    double surface(double s) const { return h0_ + slope_ * (s - s0_); }
    bool rapid(double s, double h) { return moves_->rapid(point(s, h)); }
    bool thread(double s, double h) {
        const Point here = moves_->here();
        const double from = t_->face ? here.x : here.z;
        if (std::fabs(s - from) <= kSameThread) return true;
        return moves_->thread(point(s, h), call_);
    }

    bool pass(double depth, double aside) {
        const double clear = t_->safety * away_, d = -away_ * depth;
        const double begin = s0_ + way_ * aside;
        // held in the thread: out as far as the safety level, along by the way of the exit
        if (t_->exit != 0.0) {
            const auto x = static_cast<std::int8_t>(moves_->x()),
                       z = static_cast<std::int8_t>(moves_->z());
            call_.withdraw_axis = {t_->face ? z : x, t_->face ? x : z, -1};
            call_.withdraw = {clear - d, way_ * std::fabs(t_->exit), 0.0};
        }
        if (!rapid(s0_, h0_ + clear)) return false;
        if (t_->run_in) {
            // Into the part along one slope, so that the deepest pass needs just one lead.
            const double grow = t_->lead * depth / std::fabs(t_->depth);
            if (!rapid(begin, surface(begin))) return false;
            const double in = begin + way_ * grow;
            if (!thread(in, surface(in) + d)) return false;
            if (t_->exit == 0.0) {
                const double out = s1_ - way_ * grow;
                if (!thread(out, surface(out) + d) || !thread(s1_, h1_)) return false;
                return back(clear);
            }
        } else if (!rapid(begin, surface(begin) + d)) {
            return false;
        }
        const double leave = s1_ - way_ * std::fabs(t_->exit);
        if (!thread(leave, surface(leave) + d)) return false;
        if (t_->exit > 0 && !thread(s1_, h1_ + clear)) return false;
        if (t_->exit < 0 && !thread(s1_, h1_)) return false;
        return back(clear);
    }

    // Out to the safety level, then along the section to the approach point.
    bool back(double clear) {
        PathState& path = moves_->core().path;
        const bool before = path.exact_stop_mode;
        path.exact_stop_mode = t_->square_corners;
        const bool good = rapid(s1_, h1_ + clear) && rapid(s0_, h0_ + clear);
        path.exact_stop_mode = before;
        return good;
    }

    CycleMoves* moves_;
    const ThreadSection* t_;
    ThreadCall call_;
    double s0_, h0_, s1_, h1_, way_, away_, slope_;
};

}  // namespace

std::vector<double> section_depths(const ThreadSection& t) {
    std::vector<double> depths;
    const double rough = std::fabs(t.depth) - std::fabs(t.finishing);
    double depth = 0.0;
    for (int n = 1; depth < rough - kSameThread; ++n) {
        if (n > kMostThreadPasses) return {};
        const double step = t.first > 0
                                ? std::fmax(t.first * (std::sqrt(static_cast<double>(n)) -
                                                       std::sqrt(static_cast<double>(n - 1))),
                                            t.least)
                                : -t.first;
        depth = std::fmin(depth + step, rough);
        depths.push_back(depth);
    }
    return depths;
}

bool cut_thread_section(Core& core, const ThreadSection& t) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const double length = std::fabs(t.face ? t.end.x - t.start.x : t.end.z - t.start.z);
    if (length <= kSameThread)
        return core.fail(Alarm::CycleValueIllegal, t.face ? 'Q' : 'R', t.face ? "Q" : "R");
    const std::vector<double> depths = section_depths(t);
    if (depths.empty() && std::fabs(t.depth) > std::fabs(t.finishing))
        return core.fail(Alarm::CycleValueIllegal, 'B', "B", t.first);
    return Threading(moves, t).run(depths);
}

}  // namespace polyturn::channels::cycles
