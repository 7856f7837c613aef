// Groups of elements that are determined together, and all their solutions.
//
// A group grows element by element until it has as many equations as unknowns and they are
// independent. Its roots are searched by Levenberg-Marquardt from many places (the same ones each
// time); what points the wrong way or is no root is dropped, equal roots are one. Cost: a group of
// four arcs has 16 unknowns; 160 beginnings take a few milliseconds. Weakness: a root that no
// beginning leads to is not found; tests/unit/hmi/contour compares with closed formulas and with
// contours that are known.
#include <algorithm>
#include <cmath>

#include "hmi/contour/equations.hpp"

namespace polyturn::contour {
namespace {

constexpr std::size_t kMostTogether = 4, kMostSolutions = 8;
constexpr double kFitsMm = 0.002;  // given data are rounded to three decimals
constexpr double kExactMm = 1e-6;
constexpr double kSameMm = 1e-4;

struct Root {
    Eigen::VectorXd u;
    double error = 0.0;
    bool isolated = false;
};

Eigen::MatrixXd jacobian(const Group& group, const Eigen::VectorXd& u) {
    Eigen::MatrixXd out(group.equations(), group.unknowns());
    const double step = 1e-6 * group.size();
    for (int k = 0; k < group.unknowns(); ++k) {
        Eigen::VectorXd up = u, down = u;
        up[k] += step;
        down[k] -= step;
        out.col(k) = (group.residuals(up) - group.residuals(down)) / (2 * step);
    }
    return out;
}

Root descend(const Group& group, Eigen::VectorXd u) {
    Eigen::VectorXd r = group.residuals(u);
    double damp = 1e-3;
    for (int i = 0; i < 60 && r.squaredNorm() > 1e-24; ++i) {
        const Eigen::MatrixXd j = jacobian(group, u);
        const Eigen::MatrixXd a = j.transpose() * j;
        const Eigen::VectorXd g = j.transpose() * r;
        bool better = false;
        for (int t = 0; t < 12 && !better; ++t) {
            Eigen::MatrixXd damped = a;
            damped.diagonal().array() += damp * (1.0 + a.diagonal().array());
            const Eigen::VectorXd next = u - damped.ldlt().solve(g);
            const Eigen::VectorXd rest = group.residuals(next);
            if (rest.allFinite() && rest.squaredNorm() < r.squaredNorm()) {
                better = true;
                const double gain = rest.squaredNorm() / r.squaredNorm();
                u = next;
                r = rest;
                damp = std::max(1e-15, damp * 0.1);
                // it has settled where nothing is true
                if (gain > 1 - 1e-9 && r.norm() > kFitsMm) return {u, r.norm(), false};
            } else {
                damp = std::min(1e8, damp * 8);
            }
        }
        if (!better) break;
    }
    return {u, r.size() ? r.cwiseAbs().maxCoeff() : 0.0, false};
}

bool independent(const Group& group, const Eigen::VectorXd& u) {
    const Eigen::MatrixXd j = jacobian(group, u);
    if (j.rows() < j.cols()) return false;
    const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(j).singularValues();
    return s.size() > 0 && s[s.size() - 1] > 1e-5 * std::max(1.0, s[0]);
}

double length_of(const std::vector<Piece>& pieces) {
    double out = 0.0;
    for (const Piece& piece : pieces)
        out += piece.kind == Kind::Line
                   ? std::hypot(piece.to.z - piece.from.z, piece.to.x - piece.from.x)
                   : piece.radius * piece.sweep * M_PI / 180;
    return out;
}

struct Found {
    std::vector<std::vector<Piece>> solutions;
    bool any_root = false;  // something is true, but not determined
};

Found search(const Group& group) {
    Found found;
    std::vector<Eigen::VectorXd> roots;
    double allowed = kFitsMm;
    // more only while nothing has been found
    const unsigned beginnings = group.unknowns() <= 4 ? 80u : 200u, most = 6 * beginnings;
    for (unsigned seed = 1;
         seed <= (roots.empty() ? most : beginnings) && roots.size() < kMostSolutions; ++seed) {
        const Root root = descend(group, group.begin(seed));
        if (root.error > allowed || !group.fits(root.u)) continue;
        found.any_root = true;
        // what fits nearly is none beside what fits
        if (root.error < kExactMm && allowed > kExactMm) {
            allowed = kExactMm;
            roots.clear();
        }
        if (std::any_of(roots.begin(), roots.end(), [&](const Eigen::VectorXd& other) {
                return (other - root.u).cwiseAbs().maxCoeff() <
                       kSameMm * std::max(1.0, group.size() * 0.01);
            }))
            continue;
        if (!independent(group, root.u)) return {{}, true};
        roots.push_back(root.u);
    }
    for (const Eigen::VectorXd& root : roots) {
        auto pieces = group.pieces(root);
        const bool whole = std::all_of(pieces.begin(), pieces.end(), [](const Piece& p) {
            return p.kind == Kind::Line || (p.sweep > 1e-3 && p.sweep < 360 - 1e-3);
        });
        if (whole) found.solutions.push_back(std::move(pieces));
    }
    // The shortest first: what is meant most often.
    std::stable_sort(
        found.solutions.begin(), found.solutions.end(),
        [](const auto& a, const auto& b) { return length_of(a) < length_of(b) - 1e-6; });
    return found;
}

}  // namespace

double direction_at_start(const Piece& p) {
    if (p.kind == Kind::Line)
        return norm360(std::atan2(p.to.x - p.from.x, p.to.z - p.from.z) * 180 / M_PI);
    return norm360(std::atan2(p.from.x - p.centre.x, p.from.z - p.centre.z) * 180 / M_PI +
                   (p.kind == Kind::ArcCcw ? 90 : -90));
}
double direction_at_end(const Piece& p) {
    if (p.kind == Kind::Line) return direction_at_start(p);
    return norm360(std::atan2(p.to.x - p.centre.x, p.to.z - p.centre.z) * 180 / M_PI +
                   (p.kind == Kind::ArcCcw ? 90 : -90));
}

bool Solved::complete() const {
    return std::all_of(states.begin(), states.end(),
                       [](State state) { return state == State::Known; });
}

Solved solve(const Contour& contour) {
    Solved out;
    const std::size_t count = contour.elements.size();
    out.states.assign(count, State::Open);
    out.missing.assign(count, 0);
    Point from = contour.start;
    std::optional<double> before;
    std::size_t first = 0;
    while (first < count) {
        if (first == 0 && contour.elements[0].tangent) {
            out.states[0] = State::NothingBefore;
            return out;
        }
        bool done = false;
        for (std::size_t last = first; last < count && last < first + kMostTogether && !done;
             ++last) {
            const Group group(contour, first, last, from, before);
            out.missing[last] = std::max(0, group.unknowns() - group.equations());
            if (group.equations() < group.unknowns()) continue;
            Found found = search(group);
            // true, but not enough: the next one must tell more
            if (found.solutions.empty() && found.any_root) {
                out.missing[last] = std::max(1, out.missing[last]);
                continue;
            }
            done = true;
            if (found.solutions.empty()) {
                for (std::size_t i = first; i <= last; ++i) out.states[i] = State::Contradiction;
                (void)add_transitions(contour, out.pieces, out.states);
                return out;
            }
            const int wanted = contour.elements[last].solution,
                      many = static_cast<int>(found.solutions.size());
            const auto chosen = static_cast<std::size_t>(((wanted % many) + many) % many);
            for (std::size_t i = first; i <= last; ++i) {
                out.states[i] = State::Known;
                out.missing[i] = 0;
            }
            out.pieces.insert(out.pieces.end(), found.solutions[chosen].begin(),
                              found.solutions[chosen].end());
            from = out.pieces.back().to;
            before = direction_at_end(out.pieces.back());
            if (many > 1) out.choices.push_back({first, last, std::move(found.solutions), chosen});
            first = last + 1;
        }
        if (!done) break;  // open to its end
    }
    (void)add_transitions(contour, out.pieces, out.states);
    return out;
}

}  // namespace polyturn::contour
