#include "ipc/kinematics/kinematics.hpp"

#include <algorithm>
#include <numbers>

#include "ipc/kinematics/five_axis.hpp"
#include "ipc/kinematics/polar.hpp"

namespace polyturn {
namespace {

constexpr double kDeg = 180.0 / std::numbers::pi;
constexpr double kAnywhere = 1e9;  // mm: a map that is the same everywhere

using std::atan2;
using std::sqrt;

double sense_of(const Kinematics& k) noexcept { return k.value[1] < 0 ? -1.0 : 1.0; }

template <class T>
T near_turn(T degrees, double turn) noexcept {  // by whole turns
    return degrees + T(std::round((turn - value_of(degrees)) / 360.0) * 360.0);
}

void turn_of(const Branch& b, double& turn) noexcept { turn = b.turn; }
void turn_of(const Branch& b, Jet& turn) noexcept { turn = Jet(b.turn, b.rate, 0, 0); }

template <class T>
bool polar(const Kinematics& k, const Branch& branch, const std::array<T, kMaxRoles>& path,
           std::array<T, kMaxRoles>& axes) noexcept {
    const T u = path[0] - T(k.centre[0]), v = path[1] - T(k.centre[1]);
    const double d = k.value[0];
    if (branch.side == SideOfPole::Through) {
        T turn, sine, cosine;
        turn_of(branch, turn);
        sincos((turn - T(k.centre[1])) * T(sense_of(k) / kDeg), sine, cosine);
        axes[0] = T(k.centre[0]) + u * cosine + v * sine;
        axes[1] = turn;
        return true;
    }
    const T square = u * u + v * v - T(d * d);
    if (!(value_of(square) > 0)) return false;
    T x = sqrt(square);
    if (branch.side == SideOfPole::Negative) x = T(0.0) - x;
    // atan2(v, u) - atan2(d, x) as one angle: their difference is the direction of (u + i v)(x - i
    // d).
    const T c = atan2(v * x - u * T(d), u * x + v * T(d)) * T(kDeg * sense_of(k));
    axes[0] = T(k.centre[0]) + x;
    axes[1] = near_turn(T(k.centre[1]) + c, branch.turn);
    return true;
}

template <class T>
bool map(const Kinematics& k, const Branch& branch, const std::array<T, kMaxRoles>& path,
         std::array<T, kMaxRoles>& axes) noexcept {
    switch (kind_of(k)) {
        case KinematicsKind::Polar:
            return polar(k, branch, path, axes);
        case KinematicsKind::Cylinder:
            axes[0] = T(k.centre[0]) + (path[0] - T(k.centre[0])) * T(kDeg / k.value[0]);
            return true;
        case KinematicsKind::Inclined: {
            const T x = path[0] - T(k.centre[0]);
            axes[0] = T(k.centre[0]) + x * T(1.0 / std::cos(k.value[0]));
            axes[1] = path[1] - (k.value[1] != 0 ? T(k.value[2]) : x * T(std::tan(k.value[0])));
            return true;
        }
        case KinematicsKind::FiveAxis: {
            const auto linear =
                five_axis::linear_axes<T>(k, {path[0], path[1], path[2]}, path[3], path[4]);
            axes = {linear[0], linear[1], linear[2], path[3], path[4]};
            return true;
        }
        case KinematicsKind::None:
            break;
    }
    axes = path;
    return true;
}

// At s. The rotary axis of a line through the pole ends in the direction of its end, or opposite.
Branch branch_of(const PathRecord& r, const Kinematics& k, double s) noexcept {
    Branch branch{r.turn, static_cast<SideOfPole>(r.side)};
    if (branch.side != SideOfPole::Through || !(r.length > 0)) return branch;
    SlotVector end{};
    std::copy(r.end.begin(), r.end.end(), end.begin());
    branch.rate = (turn_through_pole(k, r.turn, role_values(r, k, end)) - r.turn) / r.length;
    branch.turn += branch.rate * std::clamp(s, 0.0, r.length);
    return branch;
}

}  // namespace

std::size_t role_count(KinematicsKind kind) noexcept {
    switch (kind) {
        case KinematicsKind::Polar:
        case KinematicsKind::Inclined:
            return 2;
        case KinematicsKind::Cylinder:
            return 1;
        case KinematicsKind::FiveAxis:
            return 5;
        case KinematicsKind::None:
            break;
    }
    return 0;
}

bool same(const Kinematics& a, const Kinematics& b) noexcept {
    return a.kind == b.kind && a.axis == b.axis && a.centre == b.centre && a.sign == b.sign &&
           a.shift == b.shift && a.value == b.value;
}

bool to_axes(const Kinematics& k, const Branch& branch, const RoleValues& path,
             RoleValues& axes) noexcept {
    return map(k, branch, path, axes);
}
bool to_axes(const Kinematics& k, const Branch& branch, const RoleJets& path,
             RoleJets& axes) noexcept {
    return map(k, branch, path, axes);
}

void to_path(const Kinematics& k, const RoleValues& axes, RoleValues& path) noexcept {
    path = axes;
    switch (kind_of(k)) {
        case KinematicsKind::Polar: {
            const double x = axes[0] - k.centre[0],
                         angle = (axes[1] - k.centre[1]) * sense_of(k) / kDeg, c = std::cos(angle),
                         s = std::sin(angle);
            path[0] = k.centre[0] + x * c - k.value[0] * s;
            path[1] = k.centre[1] + x * s + k.value[0] * c;
            return;
        }
        case KinematicsKind::Cylinder:
            path[0] = k.centre[0] + (axes[0] - k.centre[0]) * k.value[0] / kDeg;
            return;
        case KinematicsKind::Inclined: {
            const double x = (axes[0] - k.centre[0]) * std::cos(k.value[0]);
            path[0] = k.centre[0] + x;
            path[1] = axes[1] + (k.value[1] != 0 ? k.value[2] : x * std::tan(k.value[0]));
            return;
        }
        case KinematicsKind::FiveAxis: {
            const auto tip = five_axis::tip(k, {axes[0], axes[1], axes[2]}, axes[3], axes[4]);
            std::copy(tip.begin(), tip.end(), path.begin());
            return;
        }
        case KinematicsKind::None:
            return;
    }
}

double reach(const Kinematics& k, const RoleValues& path) noexcept {
    if (kind_of(k) != KinematicsKind::Polar) return kAnywhere;
    const double u = path[0] - k.centre[0], v = path[1] - k.centre[1];
    return std::sqrt(std::max(0.0, u * u + v * v - k.value[0] * k.value[0]));
}

std::array<std::size_t, kMaxRoles> slots_of(const PathRecord& r, const Kinematics& k) noexcept {
    std::array<std::size_t, kMaxRoles> slots;
    slots.fill(kMaxPathAxes);
    const std::size_t roles = role_count(kind_of(k));
    for (std::size_t i = 0; i < roles; ++i)
        for (std::size_t s = 0; s < r.axis_count; ++s)
            if (r.axis[s] == k.axis[i]) slots[i] = s;
    return slots;
}

RoleValues role_values(const PathRecord& r, const Kinematics& k,
                       const SlotVector& position) noexcept {
    const auto slots = slots_of(r, k);
    RoleValues values{};
    for (std::size_t i = 0; i < kMaxRoles; ++i)
        values[i] = slots[i] < kMaxPathAxes ? position[slots[i]]
                    : i < k.centre.size()   ? k.centre[i]
                                            : 0.0;
    return values;
}

bool drives_at(const PathRecord& r, const Kinematics* k, double s, SlotVector& drives) noexcept {
    position_at(r, s, drives);
    if (r.transform == 0) return true;
    if (!k) return false;
    const auto slots = slots_of(r, *k);
    RoleValues axes{};
    if (!to_axes(*k, branch_of(r, *k, s), role_values(r, *k, drives), axes)) return false;
    for (std::size_t i = 0; i < kMaxRoles; ++i) {
        if (slots[i] == kMaxPathAxes) continue;
        const double drive = routed(*k, i, axes[i]);
        if (!std::isfinite(drive)) return false;
        drives[slots[i]] = drive;
    }
    return true;
}

bool drive_derivatives_at(const PathRecord& r, const Kinematics* k, double s,
                          PathDerivatives& out) noexcept {
    derivatives_at(r, s, out);
    if (r.transform == 0) return true;
    if (!k) return false;
    SlotVector position;
    position_at(r, s, position);
    const auto slots = slots_of(r, *k);
    const RoleValues here = role_values(r, *k, position);
    RoleJets path, axes;
    for (std::size_t i = 0; i < kMaxRoles; ++i)
        path[i] = slots[i] == kMaxPathAxes ? Jet(here[i])
                                           : Jet(here[i], out.first[slots[i]], out.second[slots[i]],
                                                 out.third[slots[i]]);
    if (!to_axes(*k, branch_of(r, *k, s), path, axes)) return false;
    for (std::size_t i = 0; i < kMaxRoles; ++i) {
        if (slots[i] == kMaxPathAxes) continue;
        out.first[slots[i]] = k->sign[i] * axes[i].first();
        out.second[slots[i]] = k->sign[i] * axes[i].second();
        out.third[slots[i]] = k->sign[i] * axes[i].third();
        if (!std::isfinite(axes[i].third())) return false;
    }
    return true;
}

}  // namespace polyturn
