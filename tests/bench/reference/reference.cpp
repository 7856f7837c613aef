// Minimum time along a given path under the axes' velocity, acceleration and jerk: the yardstick of
// tests/bench/motion_bench. Shares no code with the planner. Separate from the normal build; needs
// Debian's coinor-libipopt-dev:
//   g++ -O2 -std=c++20 -DHAVE_CSTDDEF reference.cpp -o reference -lipopt && part_paths NAME.part |
//   ./reference > NAME.reference
//
// The path is cut into intervals of fixed length ds_i; on each of them jerk is constant. Unknown
// are speed v and acceleration a at the nodes, duration h and jerk j of the intervals:
//     v' = v + a h + j h^2/2      a' = a + j h      v h + a h^2/2 + j h^3/6 = ds       (equalities)
//     |t a + k v^2| <= A          |t j + 3 k v a + p v^3| <= J     at both ends, for each axis
//     0 <= v <= ceiling
// t, k, p: the first three derivatives of the axis' position over the path.
// Wanted: the least sum of h, from rest to rest. Solved by Ipopt with exact derivatives. What it
// finds can be driven (on the nodes exactly, between them nearly), so it is an upper bound of the
// optimum that falls as the grid gets finer.
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpTNLP.hpp>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

using namespace Ipopt;

struct Side {
    double t, k, p;
};
struct Interval {
    double ds, ceiling;
    std::vector<Side> begin, end;  // by axis
};
struct Limits {
    double a, j;
};

constexpr double kUnit = 0.01;  // seconds: all numbers near 1

class Problem : public TNLP {
public:
    Problem(std::vector<Interval> intervals, std::vector<Limits> limits)
        : path_(std::move(intervals)),
          limits_(std::move(limits)),
          n_(static_cast<Index>(path_.size())),
          axes_(static_cast<Index>(limits_.size())) {}
    double seconds = -1;

    // Order of unknowns: v a of each node, then h j of each interval.
    Index v(Index i) const { return 2 * i; }
    Index a(Index i) const { return 2 * i + 1; }
    Index h(Index i) const { return 2 * (n_ + 1) + 2 * i; }
    Index j(Index i) const { return 2 * (n_ + 1) + 2 * i + 1; }
    Index rows() const { return 3 + 4 * axes_; }

    bool get_nlp_info(Index& n, Index& m, Index& jac, Index& hess, IndexStyleEnum& style) override {
        n = 2 * (n_ + 1) + 2 * n_;
        m = rows() * n_;
        jac = n_ * (5 + 4 + 4 + axes_ * (2 * 2 + 2 * 3));
        hess = n_ * 9 + n_ * 3;
        style = C_STYLE;
        return true;
    }
    bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* low,
                         Number* high) override {
        for (Index i = 0; i < n; ++i) {
            lower[i] = -2e19;
            upper[i] = 2e19;
        }
        for (Index i = 0; i <= n_; ++i) {
            double ceiling = 1e9;
            if (i > 0) ceiling = std::min(ceiling, path_[i - 1].ceiling);
            if (i < n_) ceiling = std::min(ceiling, path_[i].ceiling);
            lower[v(i)] = 0;
            upper[v(i)] = ceiling * kUnit;
        }
        for (Index end : {Index(0), n_})
            lower[v(end)] = upper[v(end)] = lower[a(end)] = upper[a(end)] = 0;
        for (Index i = 0; i < n_; ++i) {
            lower[h(i)] = 1e-6;
            upper[h(i)] = 1e5;
        }
        for (Index i = 0; i < n_; ++i) {
            Index r = rows() * i;
            for (int e = 0; e < 3; ++e) low[r + e] = high[r + e] = 0;
            for (Index x = 0; x < axes_; ++x) {
                const double la = limits_[x].a * kUnit * kUnit,
                             lj = limits_[x].j * kUnit * kUnit * kUnit;
                for (int e = 0; e < 2; ++e) {
                    low[r + 3 + 4 * x + e] = -la;
                    high[r + 3 + 4 * x + e] = la;
                }
                for (int e = 2; e < 4; ++e) {
                    low[r + 3 + 4 * x + e] = -lj;
                    high[r + 3 + 4 * x + e] = lj;
                }
            }
        }
        (void)m;
        return true;
    }
    bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                            Number*) override {
        // A slow profile: half a sine of the ceiling.
        double length = 0, done = 0;
        for (const Interval& i : path_) length += i.ds;
        for (Index i = 0; i < n; ++i) x[i] = 0;
        std::vector<double> speed(static_cast<std::size_t>(n_) + 1);
        for (Index i = 0; i <= n_; ++i) {
            double ceiling = 1e9;
            if (i > 0) ceiling = std::min(ceiling, path_[i - 1].ceiling);
            if (i < n_) ceiling = std::min(ceiling, path_[i].ceiling);
            speed[i] = kUnit * std::min(0.3 * ceiling, 20.0) *
                           std::pow(std::sin(M_PI * done / length), 2.0 / 3) +
                       1e-4;
            x[v(i)] = speed[i];
            if (i < n_) done += path_[i].ds;
        }
        for (Index i = 0; i < n_; ++i) {
            x[h(i)] = 2 * path_[i].ds / (speed[i] + speed[i + 1]);
            x[a(i)] = (speed[i + 1] - speed[i]) / x[h(i)];
        }
        return true;
    }
    bool eval_f(Index, const Number* x, bool, Number& f) override {
        f = 0;
        for (Index i = 0; i < n_; ++i) f += x[h(i)];
        return true;
    }
    bool eval_grad_f(Index n, const Number*, bool, Number* g) override {
        for (Index i = 0; i < n; ++i) g[i] = 0;
        for (Index i = 0; i < n_; ++i) g[h(i)] = 1;
        return true;
    }
    bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
        for (Index i = 0; i < n_; ++i) {
            const double v0 = x[v(i)], a0 = x[a(i)], v1 = x[v(i + 1)], a1 = x[a(i + 1)],
                         t = x[h(i)], q = x[j(i)];
            Number* r = g + rows() * i;
            r[0] = v0 + a0 * t + q * t * t / 2 - v1;
            r[1] = a0 + q * t - a1;
            r[2] = (v0 * t + a0 * t * t / 2 + q * t * t * t / 6) / path_[i].ds - 1;
            for (Index x2 = 0; x2 < axes_; ++x2) {
                const Side &b = path_[i].begin[x2], &e = path_[i].end[x2];
                Number* s = r + 3 + 4 * x2;
                s[0] = b.t * a0 + b.k * v0 * v0;
                s[1] = e.t * a1 + e.k * v1 * v1;
                s[2] = b.t * q + 3 * b.k * v0 * a0 + b.p * v0 * v0 * v0;
                s[3] = e.t * q + 3 * e.k * v1 * a1 + e.p * v1 * v1 * v1;
            }
        }
        return true;
    }
    bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* row, Index* col,
                    Number* value) override {
        Index at = 0;
        const auto put = [&](Index r, Index c, double d) {
            if (value == nullptr) {
                row[at] = r;
                col[at] = c;
            } else
                value[at] = d;
            ++at;
        };
        for (Index i = 0; i < n_; ++i) {
            double v0 = 0, a0 = 0, v1 = 0, a1 = 0, t = 0, q = 0;
            if (value != nullptr) {
                v0 = x[v(i)];
                a0 = x[a(i)];
                v1 = x[v(i + 1)];
                a1 = x[a(i + 1)];
                t = x[h(i)];
                q = x[j(i)];
            }
            const Index r = rows() * i;
            put(r, v(i), 1);
            put(r, a(i), t);
            put(r, h(i), a0 + q * t);
            put(r, j(i), t * t / 2);
            put(r, v(i + 1), -1);
            put(r + 1, a(i), 1);
            put(r + 1, h(i), q);
            put(r + 1, j(i), t);
            put(r + 1, a(i + 1), -1);
            const double s = 1 / path_[i].ds;
            put(r + 2, v(i), t * s);
            put(r + 2, a(i), t * t / 2 * s);
            put(r + 2, h(i), (v0 + a0 * t + q * t * t / 2) * s);
            put(r + 2, j(i), t * t * t / 6 * s);
            for (Index x2 = 0; x2 < axes_; ++x2) {
                const Side &b = path_[i].begin[x2], &e = path_[i].end[x2];
                const Index k = r + 3 + 4 * x2;
                put(k, a(i), b.t);
                put(k, v(i), 2 * b.k * v0);
                put(k + 1, a(i + 1), e.t);
                put(k + 1, v(i + 1), 2 * e.k * v1);
                put(k + 2, j(i), b.t);
                put(k + 2, v(i), 3 * b.k * a0 + 3 * b.p * v0 * v0);
                put(k + 2, a(i), 3 * b.k * v0);
                put(k + 3, j(i), e.t);
                put(k + 3, v(i + 1), 3 * e.k * a1 + 3 * e.p * v1 * v1);
                put(k + 3, a(i + 1), 3 * e.k * v1);
            }
        }
        return true;
    }
    bool eval_h(Index, const Number* x, bool, Number, Index, const Number* lambda, bool, Index,
                Index* row, Index* col, Number* value) override {
        Index at = 0;
        const auto put = [&](Index r, Index c, double d) {
            if (value == nullptr) {
                row[at] = std::max(r, c);
                col[at] = std::min(r, c);
            } else
                value[at] = d;
            ++at;
        };
        for (Index i = 0; i < n_; ++i) {
            double a0 = 0, t = 0, q = 0, v0 = 0, v1 = 0;
            std::vector<double> l(static_cast<std::size_t>(rows()), 0.0);
            if (value != nullptr) {
                a0 = x[a(i)];
                t = x[h(i)];
                q = x[j(i)];
                v0 = x[v(i)];
                v1 = x[v(i + 1)];
                for (Index r = 0; r < rows(); ++r) l[r] = lambda[rows() * i + r];
            }
            const double s = 1 / path_[i].ds;
            put(a(i), h(i), l[0] + l[2] * t * s);
            put(j(i), h(i), l[0] * t + l[1] + l[2] * t * t / 2 * s);
            put(h(i), h(i), l[0] * q + l[2] * (a0 + q * t) * s);
            put(v(i), h(i), l[2] * s);
            double vv0 = 0, vv1 = 0, va0 = 0, va1 = 0;
            for (Index x2 = 0; x2 < axes_; ++x2) {
                const Side &b = path_[i].begin[x2], &e = path_[i].end[x2];
                const double* m = &l[3 + 4 * x2];
                vv0 += m[0] * 2 * b.k + m[2] * 6 * b.p * v0;
                vv1 += m[1] * 2 * e.k + m[3] * 6 * e.p * v1;
                va0 += m[2] * 3 * b.k;
                va1 += m[3] * 3 * e.k;
            }
            put(v(i), v(i), vv0);
            put(v(i + 1), v(i + 1), vv1);
            put(v(i), a(i), va0);
            put(v(i + 1), a(i + 1), va1);
        }
        while (at < n_ * 12) put(0, 0, 0);
        return true;
    }
    void finalize_solution(SolverReturn, Index, const Number*, const Number*, const Number*, Index,
                           const Number*, const Number*, Number f, const IpoptData*,
                           IpoptCalculatedQuantities*) override {
        seconds = f * kUnit;
    }

private:
    std::vector<Interval> path_;
    std::vector<Limits> limits_;
    Index n_, axes_;
};

// Reads:  axes N / limits A J (N times) / segment COUNT / COUNT rows "ds ceiling" and for each axis
// "t k p t k p" / ... / end
int main() {
    std::string word;
    std::vector<Limits> limits;
    double total = 0;
    while (std::cin >> word && word != "end") {
        if (word == "axes") {
            int count = 0;
            std::cin >> count;
            limits.resize(static_cast<std::size_t>(count));
        } else if (word == "limits") {
            for (Limits& l : limits) std::cin >> l.a >> l.j;
        } else if (word == "segment") {
            std::size_t count = 0;
            std::cin >> count;
            std::vector<Interval> intervals(count);
            for (Interval& i : intervals) {
                std::cin >> i.ds >> i.ceiling;
                for (std::size_t x = 0; x < limits.size(); ++x) {
                    Side b{}, e{};
                    std::cin >> b.t >> b.k >> b.p >> e.t >> e.k >> e.p;
                    i.begin.push_back(b);
                    i.end.push_back(e);
                }
            }
            Problem* problem = new Problem(std::move(intervals), limits);
            SmartPtr<TNLP> nlp = problem;
            SmartPtr<IpoptApplication> solver = IpoptApplicationFactory();
            solver->Options()->SetIntegerValue("print_level", 0);
            solver->Options()->SetStringValue("sb", "yes");
            solver->Options()->SetIntegerValue("max_iter", 3000);
            solver->Options()->SetNumericValue("tol", 1e-7);
            solver->Options()->SetStringValue("mu_strategy", "adaptive");
            solver->Initialize();
            const ApplicationReturnStatus status = solver->OptimizeTNLP(nlp);
            if (status != Solve_Succeeded && status != Solved_To_Acceptable_Level) {
                std::fprintf(stderr, "segment of %zu intervals: not solved (%d)\n", count,
                             static_cast<int>(status));
                return 1;
            }
            std::fprintf(stderr, "segment of %zu intervals: %.6f s\n", count, problem->seconds);
            total += problem->seconds;
        }
    }
    std::printf("%.6f\n", total);
    return 0;
}
