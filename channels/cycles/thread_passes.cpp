#include "channels/cycles/thread_passes.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "channels/cycles/cycle_moves.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSamePass = 1e-9;  // mm
double tan_deg(double angle) { return std::tan(angle * std::numbers::pi / 180.0); }

}  // namespace

void withdraw_to(ThreadCall& call, unsigned x_place, double clear, double from, double to) {
    if (call.own_withdrawal || call.withdraw_axis[0] >= 0) return;
    const double a = clear - from, b = clear - to;
    if (a * b <= 0.0) return;
    call.withdraw_axis[0] = static_cast<std::int8_t>(x_place);
    call.withdraw[0] = std::fabs(a) < std::fabs(b) ? a : b;
}

std::vector<double> thread_depths(const ThreadPasses& cycle) {
    std::vector<double> depths;
    const double rough = cycle.height - cycle.allowance;
    double depth = 0.0;
    for (int k = 1; depth < rough - kSamePass; ++k) {
        if (k > kMostThreadPasses) return {};
        const double step = cycle.first * (std::sqrt(static_cast<double>(k)) -
                                           std::sqrt(static_cast<double>(k - 1)));
        depth = std::fmin(depth + std::fmax(step, cycle.least), rough);
        depths.push_back(depth);
    }
    for (int n = 0; n < cycle.finishing; ++n) depths.push_back(cycle.height);
    return depths;
}

bool cut_thread(Core& core, const ThreadPasses& cycle) {
    const auto refuse = [&](char letter, double value) {
        return core.fail(Alarm::CycleValueIllegal, letter, std::string(1, letter), value);
    };
    if (!(cycle.height > 0)) return refuse(cycle.height_letter, cycle.height);
    if (!(cycle.first > 0)) return refuse(cycle.first_letter, cycle.first);
    if (cycle.allowance < 0 || cycle.allowance > cycle.height) return refuse('R', cycle.allowance);
    if (cycle.tool_angle_deg < 0 || cycle.tool_angle_deg > 120)
        return refuse('A', cycle.tool_angle_deg);
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const Point start = moves.here();
    const double length = cycle.end.z - start.z;
    if (std::fabs(length) <= kSamePass) return refuse('Z', cycle.end.z);
    const double way = std::copysign(1.0, length);           // of the cut
    const double out = start.x >= cycle.end.x ? 1.0 : -1.0;  // away from the work
    // A start point inside the thread would drive rapid through the work.
    if (out * (start.x - cycle.end.x - cycle.taper) < cycle.height - kSamePass ||
        out * (start.x - cycle.end.x) < cycle.height - kSamePass)
        return refuse(cycle.height_letter, cycle.height);
    const std::vector<double> depths = thread_depths(cycle);
    if (depths.empty()) return refuse(cycle.first_letter, cycle.first);
    const double flank = tan_deg(cycle.tool_angle_deg / 2);
    if (std::fabs(length) - cycle.height * flank <= kSamePass) return refuse('Z', cycle.end.z);
    const double run_out = std::fmin(cycle.chamfer, std::fabs(length) - cycle.height * flank);
    for (const double depth : depths) {
        const double z = start.z + way * depth * flank;
        // at the end of the thread
        const double x_end = cycle.end.x + out * (cycle.height - depth);
        // X falls by the taper over the length
        const double slope = cycle.taper / length;
        const auto x_at = [&](double at) { return x_end + slope * (cycle.end.z - at); };
        if (!moves.rapid({z, start.x}) || !moves.rapid({z, x_at(z)})) return false;
        const double leave = cycle.end.z - way * run_out;
        ThreadCall pass = cycle.thread;
        withdraw_to(pass, moves.x(), start.x, x_at(z), x_at(leave));
        if (std::fabs(leave - z) > kSamePass && !moves.thread({leave, x_at(leave)}, pass))
            return false;
        if (run_out > kSamePass) {
            ThreadCall call = pass;  // the lead still counts along Z
            call.by_axis = true;
            call.axis = static_cast<std::uint8_t>(moves.z());
            const double lift = std::fmin(run_out * tan_deg(cycle.chamfer_angle_deg),
                                          std::fabs(start.x - x_at(leave)));
            if (!moves.thread({cycle.end.z, x_at(leave) + out * lift}, call)) return false;
        }
        if (!moves.rapid({cycle.end.z, start.x}) || !moves.rapid(start)) return false;
    }
    return true;
}

}  // namespace polyturn::channels::cycles
