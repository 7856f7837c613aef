// Random contours: the nose never comes closer to the contour than its radius, and touches every
// element. The oracle measures both curves in small steps and shares nothing with compensation but
// the moves that went in and came out.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "channels/compensation/compensator.hpp"
#include "tests/property.hpp"
#include "tests/unit/channels/quiet_sink.hpp"

namespace polyturn::channels::compensation {
namespace {

struct Pt {
    double p, q;
};

// A curve piece of its own: from, to, and for an arc centre and sweep.
struct Piece {
    Pt from, to, centre{};
    double sweep = 0.0;
    Pt at(double t) const {
        if (sweep == 0.0) return {from.p + t * (to.p - from.p), from.q + t * (to.q - from.q)};
        const double r = std::hypot(from.p - centre.p, from.q - centre.q),
                     a = std::atan2(from.q - centre.q, from.p - centre.p) + t * sweep;
        return {centre.p + r * std::cos(a), centre.q + r * std::sin(a)};
    }
};

double distance(Pt a, Pt b) { return std::hypot(a.p - b.p, a.q - b.q); }

// Smallest distance of a point to a piece: steps, then a ternary search round the best one.
double distance_to(Pt x, const Piece& piece) {
    constexpr int kSteps = 60;
    int best = 0;
    for (int i = 1; i <= kSteps; ++i)
        if (distance(x, piece.at(double(i) / kSteps)) <
            distance(x, piece.at(double(best) / kSteps)))
            best = i;
    double lo = std::fmax(0.0, (best - 1.0) / kSteps), hi = std::fmin(1.0, (best + 1.0) / kSteps);
    for (int i = 0; i < 60; ++i) {
        const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        (distance(x, piece.at(a)) < distance(x, piece.at(b)) ? hi : lo) =
            distance(x, piece.at(a)) < distance(x, piece.at(b)) ? b : a;
    }
    return distance(x, piece.at((lo + hi) / 2));
}

Piece piece_of(const Move& m) {
    Piece piece{{m.machine_start[0], m.machine_start[1]}, {m.machine[0], m.machine[1]}};
    if (m.kind == MoveKind::ArcCw || m.kind == MoveKind::ArcCcw) {
        piece.centre = {m.centre_p, m.centre_q};
        piece.sweep = m.sweep;
    }
    return piece;
}

struct Recorder final : testing::QuietSink {
    std::vector<Move> moves;
    std::vector<std::int64_t> blocks;
    void move(const Move& m, const BlockContext& at) override {
        moves.push_back(m);
        blocks.push_back(at.block);
    }
};

// Numbers below `end`, evenly from the first test on.
int pick(int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); }
double draw(double low, double high) { return low + (high - low) * pick(100001) / 100000.0; }

// A contour towards -p whose heading stays within 70 degrees of that, made of lines of 8 to 20 mm
// and arcs of radius 15 to 30 mm: long enough that only neighbours can touch a nose of at most 1
// mm.
std::vector<Move> random_contour(int count) {
    std::vector<Move> moves;
    Pt here{0, 0};
    constexpr double kPi = std::numbers::pi, kWide = 70 * kPi / 180;
    double heading = 0;  // from -p, left positive
    for (int i = 0; i < count; ++i) {
        if (pick(4) != 0) heading = draw(-kWide, kWide);  // else tangential
        Move m;
        m.kind = MoveKind::Linear;
        m.machine_start[0] = here.p;
        m.machine_start[1] = here.q;
        const double a = kPi + heading;
        const Pt d{std::cos(a), std::sin(a)};
        const double sweep = draw(0.45, 1.0) * (heading > 0 ? -1 : 1);  // back towards the middle
        if (pick(2) == 0 && std::fabs(heading + sweep) < kWide) {
            const double radius = draw(15, 30), side = sweep > 0 ? 1 : -1;
            const Pt centre{here.p - side * radius * d.q, here.q + side * radius * d.p};
            const double from = std::atan2(here.q - centre.q, here.p - centre.p);
            here = {centre.p + radius * std::cos(from + sweep),
                    centre.q + radius * std::sin(from + sweep)};
            m.kind = sweep > 0 ? MoveKind::ArcCcw : MoveKind::ArcCw;
            m.plane_p = 0;
            m.plane_q = 1;
            m.centre_p = centre.p;
            m.centre_q = centre.q;
            m.sweep = sweep;
            m.radius = m.radius_end = radius;
            heading += sweep;
        } else {
            const double length = draw(8, 20);
            here = {here.p + length * d.p, here.q + length * d.q};
        }
        m.machine[0] = here.p;
        m.machine[1] = here.q;
        m.moved = 3;
        moves.push_back(m);
    }
    return moves;
}

Move line_to(Pt from, Pt to) {
    Move m;
    m.kind = MoveKind::Rapid;
    m.machine_start[0] = from.p;
    m.machine_start[1] = from.q;
    m.machine[0] = to.p;
    m.machine[1] = to.q;
    m.moved = 3;
    return m;
}

struct Ways {
    std::vector<Move> contour;
    Recorder out;
    bool failed = false;
};

Ways drive(double radius, int side, const Options& options) {
    Ways ways;
    ways.contour = random_contour(2 + pick(7));
    Compensator nose;
    nose.open(ways.out, 0, 1, options);
    const auto step = [&](const Move& m, std::int64_t block) {
        BlockContext at;
        at.block = block;
        nose.nose(radius, {}, true);
        nose.move(m, at);
        nose.block_done(true);
    };
    const Piece first = piece_of(ways.contour.front()), last = piece_of(ways.contour.back());
    const Pt a = first.at(0), a1 = first.at(1e-4), z = last.at(1), z1 = last.at(1 - 1e-4);
    // Both approach and retract in line with the contour, so that they are no corners of their own.
    nose.select(side);
    step(line_to({a.p + (a.p - a1.p) * 3e4, a.q + (a.q - a1.q) * 3e4}, a), 1);
    for (std::size_t i = 0; i < ways.contour.size(); ++i)
        step(ways.contour[i], static_cast<std::int64_t>(i) + 10);
    nose.cancel();
    step(line_to(z, {z.p + (z.p - z1.p) * 3e4, z.q + (z.q - z1.q) * 3e4}), 2);
    ways.failed = nose.failed();
    return ways;
}

void judge(const Ways& ways, double radius, bool touches) {
    std::vector<Piece> contour;
    for (const Move& m : ways.contour) contour.push_back(piece_of(m));
    std::vector<double> closest(contour.size(), 1e9);
    for (std::size_t k = 0; k < ways.out.moves.size(); ++k) {
        if (ways.out.blocks[k] < 10) continue;
        const Piece path = piece_of(ways.out.moves[k]);
        const Pt start = path.at(0), end = path.at(1);
        if (k > 0) {  // without a gap
            const Pt before = piece_of(ways.out.moves[k - 1]).at(1);
            RC_ASSERT(distance(before, start) < 1e-7);
        }
        RC_ASSERT(distance(end, path.to) < 1e-6);
        for (int i = 0; i <= 40; ++i) {
            const Pt x = path.at(i / 40.0);
            for (std::size_t e = 0; e < contour.size(); ++e) {
                const double d = distance_to(x, contour[e]);
                RC_ASSERT(d >= radius - 1e-6);
                closest[e] = std::fmin(closest[e], d);
            }
        }
    }
    for (const double d : closest) RC_ASSERT(!touches || d <= radius + 1e-6);
}

// The nose lies above a cut towards -p; the next cut turns up, so that `between` degrees stay open
// for the nose.
std::vector<Move> cut_corner(double between, bool inner, const CornerFeed& feed) {
    Options options;
    options.corner_feed = feed;
    Recorder out;
    Compensator nose;
    nose.open(out, 0, 1, options);
    const auto step = [&](Pt from, Pt to, MoveKind kind, std::int64_t block) {
        Move m = line_to(from, to);
        m.kind = kind;
        BlockContext at;
        at.block = block;
        nose.nose(0.5, {}, true);
        nose.move(m, at);
        nose.block_done(true);
    };
    const double a = between * std::numbers::pi / 180;
    const Pt far{-20 + 20 * std::cos(a), (inner ? 20 : -20) * std::sin(a)};
    nose.select(-1);
    step({20, 0}, {0, 0}, MoveKind::Rapid, 1);
    step({0, 0}, {-20, 0}, MoveKind::Linear, 2);
    step({-20, 0}, far, MoveKind::Linear, 3);
    nose.cancel();
    step(far, {far.p + 20 * std::cos(a), far.q * 2}, MoveKind::Linear, 4);
    std::vector<Move> cuts;
    for (std::size_t k = 0; k < out.moves.size(); ++k)
        if (out.blocks[k] == 2 || out.blocks[k] == 3) cuts.push_back(out.moves[k]);
    return cuts;
}

TEST(NosePath, SharpInnerCornersAreMarkedForLessFeed) {
    const CornerFeed feed{2, 1, 90, 0.4};
    const std::vector<Move> sharp = cut_corner(80, true, feed);
    ASSERT_EQ(sharp.size(), 2u);
    EXPECT_EQ(sharp[0].slow_head, 0);
    EXPECT_EQ(sharp[0].slow_tail, 2);
    EXPECT_EQ(sharp[0].slow_share, 0.4);
    EXPECT_EQ(sharp[1].slow_head, 1);
    EXPECT_EQ(sharp[1].slow_tail, 0) << "G40 leaves in line";
    for (const auto& [between, inner, how] :
         {std::tuple{100.0, true, feed}, {80.0, false, feed}, {80.0, true, CornerFeed{}}})
        for (const Move& m : cut_corner(between, inner, how))
            EXPECT_EQ(m.slow_head + m.slow_tail, 0) << between << inner;
}

TEST(NosePath, KeepsItsDistanceAndTouchesEveryElement) {
    EXPECT_TRUE(holds("corners lengthened, fanuc", [] {
        const double radius = draw(0.05, 1.0);
        const int side = pick(2) ? 1 : -1;
        const Ways ways = drive(radius, side, {});
        RC_CLASSIFY(ways.failed, "alarm");
        if (!ways.failed) judge(ways, radius, true);
    }));
    EXPECT_TRUE(holds("corners with an arc or an intersection, sinumerik", [] {
        const double radius = draw(0.05, 1.0);
        const int side = pick(2) ? 1 : -1;
        Options options;
        options.corner = pick(2) ? Corner::Arc : Corner::Intersection;
        options.entry = pick(2) ? Entry::Direct : Entry::Around;
        const Ways ways = drive(radius, side, options);
        RC_CLASSIFY(ways.failed, "alarm");
        if (!ways.failed) judge(ways, radius, true);
    }));
}

// The same contours with every element in turn an alarm would be no proof: at least nine of ten
// must be driven.
TEST(NosePath, SeldomRefuses) {
    int refused = 0, all = 0;
    EXPECT_TRUE(holds("", [&] {
        refused += drive(draw(0.05, 1.0), pick(2) ? 1 : -1, {}).failed;
        ++all;
    }));
    EXPECT_LE(refused * 10, all);
}

}  // namespace
}  // namespace polyturn::channels::compensation
