// The contour calculator against plane geometry written another way: complex numbers, closed
// formulas, and contours that are known before their data are taken away.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "hmi/contour/contour.hpp"
#include "tests/property.hpp"

namespace polyturn::contour {
namespace {

using C = std::complex<double>;
C c(Point p) { return {p.z, p.x}; }
double deg(C v) { return std::arg(v) * 180 / M_PI; }
bool same_angle(double a, double b) { return std::fabs(std::remainder(a - b, 360.0)) < 1e-3; }

// Does a piece have what its element tells? `before`: the piece in front of it.
void judge(const Element& e, const Piece& p, const Piece* before) {
    const C from = c(p.from), to = c(p.to), centre = c(p.centre);
    constexpr double kMm = 2e-3;
    if (e.z) RC_ASSERT(std::fabs(to.real() - *e.z) < kMm);
    if (e.x) RC_ASSERT(std::fabs(to.imag() - *e.x) < kMm);
    if (e.dz) RC_ASSERT(std::fabs((to - from).real() - *e.dz) < kMm);
    if (e.dx) RC_ASSERT(std::fabs((to - from).imag() - *e.dx) < kMm);
    const C left(0, 1);
    C in = to - from, out = in;
    if (p.kind != Kind::Line) {
        in = (from - centre) * (p.kind == Kind::ArcCcw ? left : -left);
        out = (to - centre) * (p.kind == Kind::ArcCcw ? left : -left);
        RC_ASSERT(std::fabs(std::abs(from - centre) - std::abs(to - centre)) < kMm);
        if (e.radius) RC_ASSERT(std::fabs(std::abs(from - centre) - *e.radius) < kMm);
        if (e.centre_z) RC_ASSERT(std::fabs(centre.real() - *e.centre_z) < kMm);
        if (e.centre_x) RC_ASSERT(std::fabs(centre.imag() - *e.centre_x) < kMm);
        if (e.sweep)
            RC_ASSERT(same_angle(*e.sweep, deg(p.kind == Kind::ArcCcw ? out / in : in / out)));
        if (e.end_angle)
            RC_ASSERT(std::abs(out / std::abs(out) - std::polar(1.0, *e.end_angle * M_PI / 180)) *
                          std::abs(to - centre) <
                      5 * kMm);
    } else if (e.length) {
        RC_ASSERT(std::fabs(std::abs(in) - *e.length) < kMm);
    }
    if (e.angle)
        RC_ASSERT(std::abs(in / std::abs(in) - std::polar(1.0, *e.angle * M_PI / 180)) *
                      std::abs(in) <
                  5 * kMm);
    if (e.tangent && before) {
        const C b = c(before->to) - c(before->centre);
        const C way = before->kind == Kind::Line
                          ? c(before->to) - c(before->from)
                          : b * (before->kind == Kind::ArcCcw ? left : -left);
        RC_ASSERT(std::abs(in / std::abs(in) - way / std::abs(way)) * std::abs(in) < 5 * kMm);
    }
}

double number(int low, int high) { return *rc::gen::inRange(low * 10, high * 10) / 10.0; }

// An element whose data are all known, from `from` on in direction `way` (tangential) or another
// one.
struct Truth {
    Element all;  // every datum
    Point to, centre;
    double end_way = 0;
};
Truth truth(Point from, double way, bool tangent) {
    Truth out;
    const int kind = *rc::gen::inRange(0, 3);
    out.all.kind = static_cast<Kind>(kind);
    // Not along an axis: there a coordinate of the end says next to nothing about the sweep.
    const auto oblique = [] { return 90.0 * *rc::gen::inRange(0, 4) + number(5, 85); };
    const double in = tangent ? way : oblique();
    out.all.tangent = tangent;
    out.all.angle = in;
    if (kind == 0) {
        const double l = number(3, 40);
        out.to = {from.z + l * std::cos(in * M_PI / 180), from.x + l * std::sin(in * M_PI / 180)};
        out.all.length = l;
        out.end_way = in;
    } else {
        // nor a half circle: its chord says nothing of its centre
        const double r = number(3, 30), side = kind == 2 ? 1 : -1,
                     turn = std::fmod(side * (oblique() - in) + 720, 360),
                     sweep = turn < 10                    ? turn + 10
                             : turn > 350                 ? turn - 10
                             : std::fabs(turn - 180) < 20 ? turn + 40
                                                          : turn;
        const C centre = c(from) + std::polar(r, (in + side * 90) * M_PI / 180),
                to = centre + (c(from) - centre) * std::polar(1.0, side * sweep * M_PI / 180);
        out.to = {to.real(), to.imag()};
        out.centre = {centre.real(), centre.imag()};
        out.end_way = in + side * sweep;
        out.all.radius = r;
        out.all.sweep = sweep;
        out.all.centre_z = out.centre.z;
        out.all.centre_x = out.centre.x;
        out.all.end_angle = out.end_way;
    }
    out.all.z = out.to.z;
    out.all.x = out.to.x;
    out.all.dz = out.to.z - from.z;
    out.all.dx = out.to.x - from.x;
    return out;
}

// Takes data away until only a few are left; which ones is chance.
Element thin(Element e, int keep) {
    std::vector<std::optional<double> Element::*> told;
    for (const auto one : {&Element::z, &Element::x, &Element::dz, &Element::dx, &Element::length,
                           &Element::angle, &Element::radius, &Element::centre_z,
                           &Element::centre_x, &Element::end_angle, &Element::sweep})
        if (e.*one) told.push_back(one);
    while (static_cast<int>(told.size()) > keep) {
        const auto k = *rc::gen::inRange<std::size_t>(0, told.size());
        e.*told[k] = std::nullopt;
        told.erase(told.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return e;
}

PROPERTY(ContourSolve, EverySolutionHasWhatIsToldAndTheTruthIsAmongThem, ()) {
    Contour contour;
    contour.start = {number(-5, 5), number(5, 20)};
    Point at = contour.start;
    double way = 170;
    std::vector<Truth> truths;
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) {
        truths.push_back(truth(at, way, i > 0 && *rc::gen::arbitrary<bool>()));
        at = truths.back().to;
        way = truths.back().end_way;
        Element e = thin(truths.back().all, *rc::gen::inRange(1, 5));
        contour.elements.push_back(e);
    }
    const auto there = [&](const Piece& p) {
        return std::abs(c(p.to) - c(truths[p.element].to)) < 0.02 &&
               (p.kind == Kind::Line || std::abs(c(p.centre) - c(truths[p.element].centre)) < 0.05);
    };
    // Where there are several solutions the one that is true is chosen, group by group.
    Solved solved = solve(contour);
    for (std::size_t k = 0; k < solved.choices.size(); ++k) {
        const Solved::Choice& choice = solved.choices[k];
        std::size_t chosen = 0;
        while (
            chosen < choice.solutions.size() &&
            !std::all_of(choice.solutions[chosen].begin(), choice.solutions[chosen].end(), there))
            ++chosen;
        // no more than eight are searched
        RC_PRE(choice.solutions.size() < 8u || chosen < choice.solutions.size());
        RC_ASSERT(chosen < choice.solutions.size());
        contour.elements[choice.last].solution = static_cast<int>(chosen);
        solved = solve(contour);
    }
    for (std::size_t i = 0; i < contour.elements.size(); ++i) {
        const Element& e = contour.elements[i];
        RC_LOG() << i << " kind " << static_cast<int>(e.kind) << " state "
                 << static_cast<int>(solved.states[i]) << " tangent " << e.tangent;
        for (const auto one :
             {&Element::z, &Element::x, &Element::dz, &Element::dx, &Element::length,
              &Element::angle, &Element::radius, &Element::centre_z, &Element::centre_x,
              &Element::end_angle, &Element::sweep})
            RC_LOG() << " " << (e.*one ? std::to_string(*(e.*one)) : "-");
        RC_LOG() << "\n";
    }
    // the truth is a solution
    for (const State state : solved.states)
        RC_ASSERT((state == State::Known || state == State::Open));
    for (std::size_t i = 0; i < solved.pieces.size(); ++i) {
        judge(contour.elements[solved.pieces[i].element], solved.pieces[i],
              i ? &solved.pieces[i - 1] : nullptr);
        RC_ASSERT(there(solved.pieces[i]));
    }
    for (const Solved::Choice& choice : solved.choices)
        for (const auto& one : choice.solutions)
            for (std::size_t i = 0; i < one.size(); ++i)
                judge(contour.elements[one[i].element], one[i],
                      i                  ? &one[i - 1]
                      : choice.first > 0 ? &solved.pieces[choice.first - 1]
                                         : nullptr);
    RC_CLASSIFY(solved.complete());
}

// 180 from (0, 10), 135 that ends at Z-40 X30: it begins at Z-20
TEST(ContourSolve, ALineMeetsALine) {
    Contour contour;
    contour.start = {0, 10};
    contour.elements.resize(2);
    contour.elements[0].angle = 180;
    EXPECT_EQ(solve(contour).states[0], State::Open);
    EXPECT_EQ(solve(contour).missing[0], 1);
    contour.elements[1].angle = 135;
    contour.elements[1].z = -40;
    contour.elements[1].x = 30;
    const Solved solved = solve(contour);
    ASSERT_TRUE(solved.complete());
    EXPECT_NEAR(solved.pieces[0].to.z, -20, 1e-7);
    EXPECT_NEAR(solved.pieces[0].to.x, 10, 1e-7);
}

// closed formula: the centre lies r above the line
TEST(ContourSolve, AnArcBetweenALineAndAPointIsTangential) {
    Contour contour;
    contour.start = {0, 10};
    contour.elements.resize(2);
    contour.elements[0].angle = 180;
    Element& arc = contour.elements[1];
    arc.kind = Kind::ArcCw;
    arc.tangent = true;
    arc.radius = 8;
    arc.z = -30;
    arc.x = 16;
    const Solved solved = solve(contour);
    ASSERT_TRUE(solved.complete());
    // Centre (zc, 18); (zc + 30)^2 + 2^2 = 64.
    const double half = std::sqrt(64.0 - 4.0);
    EXPECT_TRUE(std::fabs(solved.pieces[1].centre.z - (-30 + half)) < 1e-6 ||
                std::fabs(solved.pieces[1].centre.z - (-30 - half)) < 1e-6)
        << solved.pieces[1].centre.z;
    ASSERT_EQ(solved.choices.size(), 1u);
    EXPECT_EQ(solved.choices[0].solutions.size(), 2u);
    contour.elements[1].solution = 1;
    const Solved other = solve(contour);
    EXPECT_GT(std::fabs(other.pieces[1].centre.z - solved.pieces[1].centre.z), 1.0);
}

TEST(ContourSolve, ContradictionsAndWhatIsTooFarAreSaid) {
    Contour contour;
    contour.start = {0, 10};
    contour.elements.resize(1);
    Element& e = contour.elements[0];
    e.z = -10;
    e.x = 10;
    e.length = 12;
    EXPECT_EQ(solve(contour).states[0], State::Contradiction);
    e.length = 10;
    EXPECT_TRUE(solve(contour).complete());
    e.tangent = true;
    EXPECT_EQ(solve(contour).states[0], State::NothingBefore);
    e = {};
    // the points are farther apart than two radii
    e.kind = Kind::ArcCcw;
    e.z = -20;
    e.x = 10;
    e.radius = 5;
    EXPECT_EQ(solve(contour).states[0], State::Contradiction);
}

// Rounding of a right angle: the centre is r from both lines; a chamfer takes the same from both.
TEST(ContourSolve, TransitionsEndTheElements) {
    Contour contour;
    contour.start = {0, 10};
    contour.elements.resize(2);
    contour.elements[0].z = -20;
    contour.elements[0].x = 10;
    contour.elements[0].round = 3;
    contour.elements[1].z = -20;
    contour.elements[1].x = 30;
    Solved solved = solve(contour);
    ASSERT_EQ(solved.pieces.size(), 3u);
    EXPECT_NEAR(solved.pieces[0].to.z, -17, 1e-9);
    EXPECT_NEAR(solved.pieces[1].centre.z, -17, 1e-9);
    EXPECT_NEAR(solved.pieces[1].centre.x, 13, 1e-9);
    EXPECT_NEAR(solved.pieces[1].sweep, 90, 1e-9);
    EXPECT_EQ(solved.pieces[1].kind, Kind::ArcCw);
    EXPECT_NEAR(solved.pieces[2].from.x, 13, 1e-9);
    contour.elements[0].round = 0;
    contour.elements[0].chamfer = 2;
    solved = solve(contour);
    ASSERT_EQ(solved.pieces.size(), 3u);
    EXPECT_NEAR(solved.pieces[1].from.z, -18, 1e-9);
    EXPECT_NEAR(solved.pieces[1].to.x, 12, 1e-9);
    contour.elements[0].chamfer = 25;
    EXPECT_EQ(solve(contour).states[0], State::NoRoom);
}

// Any two known elements: the rounding touches both and is as large as told.
PROPERTY(ContourSolve, ARoundingTouchesBothElements, ()) {
    Contour contour;
    contour.start = {0, 10};
    const Truth a = truth(contour.start, 0, false), b = truth(a.to, a.end_way, false);
    contour.elements = {a.all, b.all};
    const double r = number(1, 6);
    contour.elements[0].round = r;
    const Solved solved = solve(contour);
    RC_PRE(solved.complete() && solved.pieces.size() == 3);
    const Piece& round = solved.pieces[1];
    RC_ASSERT(std::fabs(std::abs(c(round.from) - c(round.centre)) - r) < 1e-6);
    RC_ASSERT(std::fabs(std::abs(c(round.to) - c(round.centre)) - r) < 1e-6);
    RC_ASSERT(same_angle(direction_at_end(solved.pieces[0]), direction_at_start(round)));
    RC_ASSERT(same_angle(direction_at_end(round), direction_at_start(solved.pieces[2])));
    RC_ASSERT(std::abs(c(solved.pieces[0].to) - c(round.from)) < 1e-6);
    RC_ASSERT(std::abs(c(solved.pieces[2].from) - c(round.to)) < 1e-6);
    RC_ASSERT(std::abs(c(solved.pieces[2].to) - c(b.to)) < 5e-3);
}

}  // namespace
}  // namespace polyturn::contour
