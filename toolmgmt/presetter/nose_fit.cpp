#include "toolmgmt/presetter/nose_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolmgmt/presetter/robust_line.hpp"

namespace polyturn::presetter {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr int kRounds = 60;
constexpr double kTukey = 4.685;
constexpr double kMostOutliers = 0.3;
constexpr double kLeastCoverage = 0.6;  // of the nose's arc that must be seen
// points that share their error: smoothing and blur spread it
constexpr double kNeighbours = 4;

Diagnosis refused(std::string why) {
    return Diagnosis{Alarm::PresetterImage, {}, {}, std::move(why)};
}

enum class Where : std::uint8_t { Arc, Plus, Minus };

// Distance from the model, outwards positive, and its derivatives.
double residual(const Vector5& q, const Point& p, Vector5& gradient, Where& where) {
    const double vx = p.x - q[0], vy = p.y - q[1], length = std::hypot(vx, vy);
    const double phi = std::remainder(std::atan2(vy, vx) - q[3], 2 * std::numbers::pi);
    if (std::fabs(phi) <= q[4] && length > 1e-12) {
        where = Where::Arc;
        gradient << -vx / length, -vy / length, -1, 0, 0;
        return length - q[2];
    }
    const double side = phi > 0 ? 1 : -1, angle = q[3] + side * q[4];
    const double nx = std::cos(angle), ny = std::sin(angle), turn = -vx * ny + vy * nx;
    where = side > 0 ? Where::Plus : Where::Minus;
    gradient << -nx, -ny, -1, turn, side * turn;
    return vx * nx + vy * ny - q[2];
}

double scale_of(std::vector<double> residuals) {
    for (double& one : residuals) one = std::fabs(one);
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return 1.4826 * *middle;
}

// Lines through both ends of the contour, where the flanks are; the nose lies where they would
// meet.
Result<Vector5> first_guess(const std::vector<Point>& points, double pixel) {
    const std::size_t third = points.size() * 35 / 100;
    const std::vector<Point> begin(points.begin(),
                                   points.begin() + static_cast<std::ptrdiff_t>(third)),
        end(points.end() - static_cast<std::ptrdiff_t>(third), points.end());
    auto a = robust_line(begin, 1.5 * pixel), b = robust_line(end, 1.5 * pixel);
    if (!a || !b) return refused("no straight flanks are seen on both sides of a tip");
    // Outwards: a tip is convex, so the other flank lies on the inner side.
    double apart = 0;
    const auto inwards = [&](Line& line, const std::vector<Point>& other) {
        double sum = 0;
        for (const Point& p : other) sum += line.distance(p) / static_cast<double>(other.size());
        if (sum > 0) {
            line.nx = -line.nx;
            line.ny = -line.ny;
            line.d = -line.d;
        }
        apart = std::max(apart, std::fabs(sum));
    };
    inwards(*a, end);
    inwards(*b, begin);
    const double cross = a->nx * b->ny - a->ny * b->nx, dot = a->nx * b->nx + a->ny * b->ny;
    const double half = 0.5 * std::atan2(std::fabs(cross), dot);
    if (half < 0.09 || (std::fabs(cross) < 0.17 && apart < 8 * pixel))
        return refused(
            "it shows one straight edge and no tip: the tip is cut off, or not in the picture");
    if (half > 1.5) return refused("two edges run side by side: show one corner alone");
    const Point meet{(a->d * b->ny - b->d * a->ny) / cross, (b->d * a->nx - a->d * b->nx) / cross};
    double bx = a->nx + b->nx, by = a->ny + b->ny;
    const double length = std::hypot(bx, by);
    bx /= length;
    by /= length;
    double nearest = 1e300;
    for (const Point& p : points)
        nearest = std::min(nearest, std::hypot(p.x - meet.x, p.y - meet.y));
    const double r = std::max(nearest / (1 / std::cos(half) - 1), 0.2 * pixel);
    Vector5 q;
    q << meet.x - bx * r / std::cos(half), meet.y - by * r / std::cos(half), r, std::atan2(by, bx),
        half;
    return q;
}

}  // namespace

Result<Nose> fit_nose(const std::vector<Point>& points, double pixel) {
    const Result<Vector5> guess = first_guess(points, pixel);
    if (!guess) return guess.diagnosis();
    Vector5 q = *guess;
    std::vector<double> residuals(points.size()), weights(points.size());
    Vector5 gradient;
    Where where{};
    double damping = 1e-3, scale = 0;
    Matrix5 normal;
    const auto cost_of = [&](const Vector5& at) {
        double sum = 0;
        for (const Point& p : points) {
            const double u = residual(at, p, gradient, where) / (kTukey * scale);
            sum += std::fabs(u) < 1 ? 1 - std::pow(1 - u * u, 3) : 1.0;
        }
        return sum;
    };
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < points.size(); ++i)
            residuals[i] = residual(q, points[i], gradient, where);
        scale = std::max(scale_of(residuals), 0.02 * pixel);
        normal.setZero();
        Vector5 right = Vector5::Zero();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double e = residual(q, points[i], gradient, where), u = e / (kTukey * scale);
            weights[i] = std::fabs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
            normal += weights[i] * gradient * gradient.transpose();
            right -= weights[i] * e * gradient;
        }
        const double before = cost_of(q);
        bool better = false;
        double moved = 0;
        for (int trial = 0; trial < 8 && !better; ++trial) {
            Matrix5 damped = normal;
            damped.diagonal() *= 1 + damping;
            const Vector5 step = damped.ldlt().solve(right);
            Vector5 next = q + step;
            next[2] = std::max(next[2], 1e-3 * pixel);
            next[4] = std::clamp(next[4], 0.05, 1.55);
            if (!next.allFinite() || cost_of(next) > before) {
                damping *= 8;
                continue;
            }
            better = true;
            damping = std::max(damping / 6, 1e-9);
            moved = (next - q).head<3>().norm();
            q = next;
        }
        if (!better || moved < 1e-6 * pixel) break;
    }
    Nose out;
    out.x = q[0];
    out.y = q[1];
    out.r = q[2];
    out.points_to = std::remainder(q[3], 2 * std::numbers::pi);
    out.half = q[4];
    double sum = 0, weight = 0;
    std::size_t good = 0, plus = 0, minus = 0;
    normal.setZero();
    for (const Point& p : points) {
        const double e = residual(q, p, gradient, where), u = e / (kTukey * scale);
        if (std::fabs(u) >= 1) continue;
        ++good;
        (where == Where::Arc ? out.on_arc : where == Where::Plus ? plus : minus) += 1;
        const double w = (1 - u * u) * (1 - u * u);
        sum += w * e * e;
        weight += w;
        normal += w * gradient * gradient.transpose();
    }
    out.outliers = 1 - static_cast<double>(good) / static_cast<double>(points.size());
    if (weight <= 0 || plus < 20 || minus < 20)
        return refused("it is cut off: both flanks and the tip must be seen");
    out.deviation = std::sqrt(sum / weight);
    if (out.outliers > kMostOutliers)
        return refused("the edge is chipped or dirty: " +
                       std::to_string(static_cast<int>(std::lround(100 * out.outliers))) +
                       " % of it does not fit a tip");
    const double expected = 2 * out.half * out.r / pixel;
    if (expected > 8 && static_cast<double>(out.on_arc) < kLeastCoverage * expected)
        return refused("it is cut off, or the tip is broken: only " +
                       std::to_string(static_cast<int>(
                           std::lround(100 * static_cast<double>(out.on_arc) / expected))) +
                       " % of the nose is seen");
    out.covariance =
        normal.ldlt().solve(Matrix5::Identity()) * out.deviation * out.deviation * kNeighbours;
    return out;
}

}  // namespace polyturn::presetter
