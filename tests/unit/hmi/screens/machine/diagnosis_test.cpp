// Diagnosis: the scope's trigger and export, the roundness of a circle, and both against a real
// controller.
#include "hmi/screens/machine/diagnosis.hpp"

#include <QFile>
#include <cmath>

#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

std::vector<ScopeSample> ramp(std::int64_t from, int count) {  // trace 0 counts the ticks
    std::vector<ScopeSample> out(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        out[static_cast<std::size_t>(i)].tick = from + i;
        out[static_cast<std::size_t>(i)].value[0] = static_cast<double>(from + i);
    }
    return out;
}

TEST(Diagnosis, TheTriggerStopsTheRecordFourFifthsOfTheWindowBehindIt) {
    ScopeRecord record;
    record.trigger = {0, 500.0, true};
    record.arm();
    record.add(ramp(0, 400), 1000);
    EXPECT_EQ(record.mode(), ScopeRecord::Mode::Armed);
    record.add(ramp(400, 200), 1000);
    EXPECT_EQ(record.mode(), ScopeRecord::Mode::Triggered);
    EXPECT_EQ(record.triggeredAt(), 500);
    record.add(ramp(600, 2000), 1000);
    EXPECT_EQ(record.mode(), ScopeRecord::Mode::Stopped);
    EXPECT_EQ(record.samples().back().tick, 1300);
    record.trigger.rising = false;  // a signal that only rises never triggers
    record.arm();
    record.add(ramp(0, 5000), 1000);
    EXPECT_EQ(record.mode(), ScopeRecord::Mode::Armed);
}

TEST(Diagnosis, TheRecordIsAMinuteAtMostAndWrittenAsATable) {
    ScopeRecord record;
    for (int i = 0; i < 7; ++i) record.add(ramp(i * 10'000, 10'000), 1000);
    EXPECT_EQ(record.samples().size(), ScopeRecord::kMost);
    record.clear();
    record.add(ramp(7, 2), 1000);
    EXPECT_EQ(record.csv({"A1", "", "", "", "", "", "", ""}, 0.001), "t,A1\n0,7\n0.001,8\n");
}

std::deque<ScopeSample> circle(double turns, double radius, double (*deviation)(double angle),
                               bool with_way) {
    std::deque<ScopeSample> out;
    const auto add = [&](double x, double z, double off_x, double off_z) {
        ScopeSample s{};
        s.tick = static_cast<std::int64_t>(out.size());
        s.value[0] = x;
        s.value[1] = z;
        s.value[2] = x + off_x;
        s.value[3] = z + off_z;
        out.push_back(s);
    };
    // stands
    for (int i = 0; i < 100; ++i) add(30, -20, 0, 0);
    // to the start of the circle
    if (with_way)
        for (int i = 0; i < 200; ++i) add(30 + radius * i / 200.0, -20 + 5 - i * 5 / 200.0, 0, 0);
    const int count = static_cast<int>(turns * 4000);
    for (int i = 0; i <= count; ++i) {
        const double a = i * 2 * 3.141592653589793 / 4000, d = deviation(a);
        add(30 + radius * std::cos(a), -20 + radius * std::sin(a), d * std::cos(a),
            d * std::sin(a));
    }
    return out;
}

TEST(Diagnosis, RoundnessIsTheSpreadOfTheMeasuredRadius) {
    const auto round = roundnessOf(circle(
        1, 12, [](double a) { return 0.003 * std::cos(2 * a); }, false));
    ASSERT_TRUE(round);
    EXPECT_NEAR(round->radius, 12, 1e-6);
    EXPECT_NEAR(round->x, 30, 1e-6);
    EXPECT_NEAR(round->error(), 0.006, 1e-5);
    const auto with_way = roundnessOf(circle(
        1, 12, [](double) { return -0.001; }, true));
    ASSERT_TRUE(with_way);
    EXPECT_NEAR(with_way->most, -0.001, 2e-4) << "the way to the circle is no part of it";
    std::deque<ScopeSample> left = circle(
        1, 12, [](double) { return 0.0; }, false);
    // along the tangent, 0.25 mm: 2.6 um beside the circle at its end
    for (int i = 1; i <= 100; ++i) {
        ScopeSample s = left.back();
        ++s.tick;
        s.value[1] += 0.0025;
        s.value[3] = s.value[1];
        left.push_back(s);
    }
    const auto tangent = roundnessOf(left);
    ASSERT_TRUE(tangent);
    EXPECT_LT(tangent->error(), 0.0001) << "the tangent away from the circle is no part of it";
    EXPECT_FALSE(roundnessOf(circle(
        0.4, 12, [](double) { return 0.0; }, false)))
        << "less than three quarters of a turn";
    EXPECT_FALSE(roundnessOf({}));
}

// Axes that follow late by the same time constant drive the circle too small: a circle of the
// frequency w has the radius r / sqrt(1 + (wT)^2).
TEST(Diagnosis, ALagOfBothAxesIsASmallerRadius) {
    constexpr double kRadius = 10, kT = 0.025, kSpeed = 50, w = kSpeed / kRadius, kTick = 0.001;
    constexpr int kSteps = 50;
    std::deque<ScopeSample> out;
    double x = kRadius, z = 0;
    for (int i = 0; i < 5000; ++i) {
        ScopeSample s{};
        s.tick = i;
        s.value[0] = kRadius * std::cos(w * i * kTick);
        s.value[1] = kRadius * std::sin(w * i * kTick);
        for (int k = 0; k < kSteps; ++k) {  // as the axis does between the ticks
            const double a = w * (i - 1 + (k + 1.0) / kSteps) * kTick;
            x += (kRadius * std::cos(a) - x) * kTick / kSteps / kT;
            z += (kRadius * std::sin(a) - z) * kTick / kSteps / kT;
        }
        s.value[2] = x;
        s.value[3] = z;
        if (i > 1000) out.push_back(s);  // swung in
    }
    const auto round = roundnessOf(out);
    ASSERT_TRUE(round);
    const double wanted = kRadius / std::sqrt(1 + w * w * kT * kT) - kRadius;
    EXPECT_NEAR(wanted, -0.0772, 1e-4);
    EXPECT_NEAR(round->least, wanted, 0.0002);  // the sum above is not quite the integral
    EXPECT_NEAR(round->most, wanted, 0.0002);
}

class DiagnosisTasks : public Tasks {};

// Another language makes the screens anew while the kernel has recorded for long: what was before
// them they have not missed.
TEST_F(DiagnosisTasks, TheScopeMissesNothingThatWasBeforeIt) {
    ASSERT_TRUE(g_controller->press("scope 1 measured A1"));
    QTest::qWait(9'500);  // more than the ring of the kernel holds
    window->setDisplayLanguage(DisplayLanguage::Czech);
    ScopePage& scope = screenOf<Diagnosis>().scope();
    ASSERT_TRUE(waitFor([&] { return scope.record().samples().size() > 100; }));
    EXPECT_FALSE(scope.missed());
    window->setDisplayLanguage(DisplayLanguage::English);
}

TEST_F(DiagnosisTasks, TheScopeRecordsTheRunningMachineAtItsTicks) {
    startJob();
    Operator hand(*window);
    hand.screen("diagnosis");
    hand.soft("Scope");
    ScopePage& scope = screenOf<Diagnosis>().scope();
    hand.key(Qt::Key_Return);  // trace 1
    ASSERT_TRUE(scope.choosing());
    hand.type("A2 Z comm");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return scope.record().samples().size() > 300; }));
    const auto& samples = scope.record().samples();
    for (std::size_t i = 1; i < samples.size(); ++i)
        ASSERT_EQ(samples[i].tick, samples[i - 1].tick + 1);
    EXPECT_TRUE(waitFor([&] { return samples.back().value[0] != samples.front().value[0]; }))
        << "the axis moves in this job";
    window->context().folder = g_controller->folder.path();
    hand.soft("Export");
    ASSERT_TRUE(waitFor([&] { return !scope.exported().isEmpty(); }));
    QFile file(scope.exported());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << scope.exported().toStdString();
    EXPECT_EQ(file.readLine(), "t,A2 Z commanded [mm]\n");
    noWordIsShortened(*window);
}

TEST_F(DiagnosisTasks, TheCircleThatWasDrivenIsJudged) {
    Operator hand(*window);
    hand.screen("diagnosis");
    hand.soft("Circularity");
    hand.soft("Axes of L1");
    ScopePage& scope = screenOf<Diagnosis>().scope();
    frames(*window, 500);
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    QFile file(g_controller->folder.filePath("circle.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "O0003\nN10 G98 G0 U-20. W-20.\nN20 G1 U-.2 F600.\n"
        "N30 G2 U0 W-20. R10.\nN35 G2 U0 W20. R10.\n"
        "N40 M30\n");
    file.close();
    ASSERT_TRUE(g_controller->press("select L1=" + file.fileName()) &&
                g_controller->press("cycle_start L1"));
    EXPECT_TRUE(waitFor([&] { return scope.roundness().has_value(); }));
    ASSERT_TRUE(scope.roundness());
    EXPECT_NEAR(scope.roundness()->radius, 10, 0.01);
    EXPECT_LT(scope.roundness()->error(), 0.5);
}

// The position gain is 40 1/s: without feed-forward an axis is T = 1/40 s behind (N0504). In the
// loop lies the simulated drive (PT_DRIVE_FREQ 60 Hz, PT_DRIVE_DAMPING 0.9), late by its 2 D / w0,
// a tick of way and half a tick of hold, t in all: G(s) = 1 / (1 + s T + s^2 T t) near a circle's
// frequency, whose amount is what the radius is multiplied by. 10 mm come out by some hundredths
// too small.
TEST_F(DiagnosisTasks, AKnownLagGivesAKnownRadius) {
    Operator hand(*window);
    hand.screen("diagnosis");
    hand.soft("Circularity");
    hand.soft("Axes of L1");
    ScopePage& scope = screenOf<Diagnosis>().scope();
    const auto feedForward = [&](const char* share) {
        for (const char* axis : {"A1", "A2"})
            ASSERT_TRUE(g_controller->run({"params", "set", QString("N0511 %1=%2").arg(axis, share),
                                           "--instance", g_controller->name}));
    };
    feedForward("0");
    ASSERT_TRUE(g_controller->press("reference all"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<MachineStep>(live().status().step) == MachineStep::Ready; }));
    QFile file(g_controller->folder.filePath("fast.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "O0005\nN10 G98 G0 U-20. W-20.\nN20 G1 U-.2 F3000.\n"
        "N30 G2 U0 W-20. R10.\nN35 G2 U0 W20. R10.\n"
        "N36 G2 U0 W-20. R10.\nN37 G2 U0 W20. R10.\n"
        "N40 M30\n");
    file.close();
    ASSERT_TRUE(g_controller->press("select L1=" + file.fileName()) &&
                g_controller->press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] {
        return scope.roundness() && scope.roundness()->least < -0.02 &&
               state(1) != ChannelState::Running;
    }));
    QTest::qWait(2'500);  // and all of it is judged
    // As fast as it was commanded: curves have a limit of their own.
    const auto& samples = scope.record().samples();
    double circling = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (std::abs(std::hypot(samples[i].value[0] - scope.roundness()->x,
                                samples[i].value[1] - scope.roundness()->z) -
                     10) < 0.001)
            circling =
                std::max(circling, std::hypot(samples[i].value[0] - samples[i - 1].value[0],
                                              samples[i].value[1] - samples[i - 1].value[1]) /
                                       live().seconds(1) / 10);
    ASSERT_GT(circling, 2);
    const double lag = 1.0 / 40, drive = 2 * 0.9 / (2 * M_PI * 60) + 1.5 * live().seconds(1),
                 w = circling;
    const double wanted = 10 / std::hypot(1 - w * w * lag * drive, w * lag) - 10;
    EXPECT_NEAR(scope.roundness()->radius, 10, 0.001);
    EXPECT_NEAR(scope.roundness()->least, wanted, 0.001) << circling;
    feedForward("1");
}

TEST_F(DiagnosisTasks, VariablesOfAChannelAreThoseThatItsProgramHasWritten) {
    QFile file(g_controller->folder.filePath("variables.nc"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("O0004\nN10 #101=12.5\nN15 SETVN 505[SHAFT_D]\nN20 #505=-3\nN30 G4 X2.\nN40 M30\n");
    file.close();
    ASSERT_TRUE(g_controller->press("select L1=" + file.fileName()) &&
                g_controller->press("cycle_start L1"));
    Operator hand(*window);
    hand.screen("diagnosis");
    hand.soft("Variables");
    hand.key(Qt::Key_1, Qt::ControlModifier);
    Table& table = screenOf<Diagnosis>().table();
    const auto value = [&](const QString& name) {
        for (int row = 0; row < table.rows(); ++row)
            if (table.cell(row, 0).text == name) return table.cell(row, 1).text;
        return QString();
    };
    EXPECT_TRUE(waitFor([&] { return value("#101") == "12.5" && value("#505") == "-3"; }))
        << value("#101").toStdString() << " " << value("#505").toStdString();
    for (int row = 0; row < table.rows(); ++row)
        EXPECT_EQ(table.cell(row, 2).text,
                  table.cell(row, 0).text == "#505" ? QString("SHAFT_D") : QString())
            << "the name that SETVN has given";
    hand.soft("Timers, counters");
    EXPECT_GT(table.rows(), 10);
    hand.soft("Couplings");
    hand.soft("Processes");
    noWordIsShortened(*window);
}

}  // namespace
}  // namespace polyturn::hmi
