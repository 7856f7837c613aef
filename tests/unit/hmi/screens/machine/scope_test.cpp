// The scope's graph: columns that are kept say what all samples say, scales that can be read,
// traces that are told apart without colours.
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <set>

#include "hmi/screens/machine/scope_plot.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/pictures/time_shape.hpp"
#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {
namespace {

std::vector<ScopeSample> waves(std::int64_t from, int count) {
    std::vector<ScopeSample> out(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        ScopeSample& s = out[static_cast<std::size_t>(i)];
        s.tick = from + i;
        for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
            s.value[trace] =
                std::sin(static_cast<double>(s.tick) * 0.01 * static_cast<double>(trace + 1)) * 10;
    }
    return out;
}

// Of all samples, as it is meant: nothing kept.
ScopeSpan meant(const std::deque<ScopeSample>& samples, std::size_t trace, std::int64_t column,
                double ticks) {
    ScopeSpan out;
    const double begins = static_cast<double>(column) * ticks,
                 ends = static_cast<double>(column + 1) * ticks;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double t0 = static_cast<double>(samples[i - 1].tick),
                     t1 = static_cast<double>(samples[i].tick);
        if (t1 < begins || t0 >= ends) continue;
        for (const double t : {std::max(t0, begins), std::min(t1, ends)})
            out.add(samples[i - 1].value[trace] +
                    (samples[i].value[trace] - samples[i - 1].value[trace]) * (t - t0) / (t1 - t0));
    }
    return out;
}

TEST(ScopeColumns, KeptOnesAreThoseOfAllSamples) {
    for (const double ticks : {0.3, 1.0, 3.7, 40.0}) {
        SCOPED_TRACE(ticks);
        ScopeRecord record;
        ScopeColumns kept;
        std::int64_t tick = 0;
        // a frame has so many ticks, now more and now less
        for (int look = 0; look < 60; ++look) {
            record.add(waves(tick, 10 + look % 7), 1e9);
            tick += 10 + look % 7;
            kept.take(record, ticks, 100);
        }
        ScopeColumns fresh;
        fresh.take(record, ticks, 100);
        ASSERT_EQ(kept.newest(), fresh.newest());
        for (std::int64_t c = kept.newest() - 98; c < kept.newest(); ++c)
            for (const std::size_t trace : {0u, 7u}) {
                const ScopeSpan span = kept.at(trace, c),
                                wanted = meant(record.samples(), trace, c, ticks);
                if (c < 0 || !wanted.any()) continue;
                EXPECT_NEAR(span.least, wanted.least, 1e-9) << c;
                EXPECT_NEAR(span.most, wanted.most, 1e-9) << c;
                EXPECT_NEAR(fresh.at(trace, c).most, span.most, 1e-9) << c;
            }
        EXPECT_FALSE(kept.at(0, kept.newest() - 100).any());
        EXPECT_FALSE(kept.at(0, kept.newest() + 1).any());
    }
}

TEST(ScopeColumns, ASpikeOfOneTickIsSeenHoweverWideTheWindowIs) {
    ScopeRecord record;
    std::vector<ScopeSample> samples(50'000);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].tick = static_cast<std::int64_t>(i);
    samples[31'234].value[2] = 5;
    record.add(samples, 1e9);
    ScopeColumns columns;
    columns.take(record, 50.0, 1000);
    EXPECT_EQ(columns.whole(2).most, 5);
    EXPECT_EQ(columns.at(2, 31'234 / 50).most, 5);
    record.clear();
    columns.take(record, 50.0, 1000);
    EXPECT_FALSE(columns.whole(2).any()) << "another record has nothing of the one before";
}

TEST(ScopeScale, CanBeReadAndHoldsTheTrace) {
    for (const auto& [least, most] : {std::pair{-3.2, 17.9},
                                      {99.8, 100.4},
                                      {-0.0031, 0.0022},
                                      {0.0, 0.0},
                                      {1500.0, 1500.0},
                                      {-7.0, -7.0}})
        for (std::size_t trace = 0; trace < kScopeTraces; ++trace) {
            ScopeSpan span;
            span.add(least);
            span.add(most);
            const ScopeScale scale = scopeScale(span, {}, trace);
            EXPECT_LE(scale.bottom, least);
            EXPECT_GE(scale.top(), most);
            const double digits =
                scale.division / std::pow(10.0, std::floor(std::log10(scale.division) + 1e-9));
            EXPECT_TRUE(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6 ||
                        std::abs(digits - 5) < 1e-6)
                << scale.division;
            EXPECT_NEAR(std::remainder(scale.bottom, scale.division), 0, scale.division * 1e-6);
            if (most - least > 0.01) {
                EXPECT_GE(most - least, 2.4 * scale.division) << "it fills the graph";
            }
            EXPECT_EQ(scopeScale(span, scale, trace).bottom, scale.bottom) << "and stays";
        }
    ScopeSpan still;
    still.add(80);
    std::set<int> places;
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace)
        places.insert(static_cast<int>(
            std::lround(scopeScale(still, {}, trace).part(80) * ScopeScale::kDivisions)));
    EXPECT_EQ(places.size(), kScopeTraces) << "eight that stand do not lie on one line";
}

TEST(ScopePlot, TracesAreToldApartWithoutColours) {
    std::set<std::vector<bool>> dashes;
    for (std::size_t trace = 0; trace < kScopeTraces; ++trace) {
        std::vector<bool> ink;
        for (std::int64_t column = 0; column < 48; ++column)
            ink.push_back(traceHasInk(trace, column));
        dashes.insert(ink);
    }
    EXPECT_EQ(dashes.size(), kScopeTraces);

    ScopeRecord record;
    record.add(waves(0, 3000), 1e9);
    ScopeLook look;
    look.on.fill(true);
    look.chosen = 1;
    look.title = "velocity";
    look.unit = "mm/min";
    ScopePlot plot;
    plot.take(record, look, QSize(1100, 330));
    QImage image(1100, 330, QImage::Format_RGB32);
    QPainter p(&image);
    std::multiset<QString> heard;
    hearPaintedWords([&](const QString& text, bool fits) {
        heard.insert(text);
        EXPECT_TRUE(fits) << text.toStdString();
    });
    plot.paint(p, image.rect());
    hearPaintedWords({});
    for (int trace = 1; trace <= static_cast<int>(kScopeTraces); ++trace)
        EXPECT_GE(heard.count(QString::number(trace)), 1u) << "its number at the line";
    // values of the chosen trace, and the time
    for (const char* text : {"10", "-10", "0", "-1.0", "-0.4"})
        EXPECT_GE(heard.count(text), 1u) << text;
    EXPECT_EQ(heard.count("2  velocity  mm/min"), 1u);
    look.on.fill(false);
    plot.take(record, look, QSize(1100, 330));
    plot.paint(p, image.rect());  // nothing to draw
}

// The part of each picture that is no background, whatever its colour.
TEST(TimeShapes, DifferInGrey) {
    std::vector<std::vector<bool>> masks;
    for (const TimeShape shape :
         {TimeShape::Full, TimeShape::Half, TimeShape::Hatched, TimeShape::Hollow}) {
        FreeSheet sheet(nullptr);
        sheet.onCompose = [&](Writer& w) {
            w.fill(QRectF(0, 0, 60, 40), theme().card);
            drawTimeShape(w, shape, QRectF(5, 5, 50, 30), theme().accent);
        };
        sheet.resize(60, 40);
        const QImage image = sheet.grab().toImage().convertToFormat(QImage::Format_RGB32);
        std::vector<bool> mask;
        for (int y = 5; y < 35; ++y)
            for (int x = 5; x < 55; ++x) mask.push_back(image.pixelColor(x, y) != theme().card);
        masks.push_back(mask);
    }
    for (std::size_t a = 0; a < masks.size(); ++a)
        for (std::size_t b = a + 1; b < masks.size(); ++b) {
            int differ = 0;
            for (std::size_t i = 0; i < masks[a].size(); ++i) differ += masks[a][i] != masks[b][i];
            EXPECT_GT(differ, 300) << a << " " << b << ": a fifth of the bar";
        }
}

}  // namespace
}  // namespace polyturn::hmi
