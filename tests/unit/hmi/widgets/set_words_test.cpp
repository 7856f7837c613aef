// What is painted quickly is what Qt paints, and nothing of a picture that was painted before is
// left when something changes.
#include "hmi/widgets/set_words.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QtTest>
#include <random>

#include "hmi/widgets/sheet.hpp"
#include "tests/seeds.hpp"

namespace polyturn::hmi {
namespace {

QImage painted(const std::function<void(QPainter&)>& how) {
    QImage out(420, 90, QImage::Format_RGB32);
    out.fill(Qt::white);
    QPainter p(&out);
    p.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    p.setPen(Qt::black);
    how(p);
    return out;
}

TEST(SetWords, AreThePixelsOfQt) {
    const QString texts[] = {"Feed",
                             "Отклонение",
                             "Zbývá – příliš",
                             "Kérem, nyomja meg",
                             "N160 G1 X40. Z-12.",
                             "↻ 1200",
                             "AVATAR To. Wa fi",
                             "a b  c ",
                             QString::fromUtf8("≤ 3000 1/min"),
                             "O1200.nc",
                             "ends the program: press again, or wait for the next one"};
    const QRectF boxes[] = {
        {10, 10, 400, 24}, {10.5, 10.25, 300.3, 31.7}, {3.3, 4, 61, 20}, {12, 8.6, 120.4, 70}};
    for (const QString& text : texts)
        for (const double size : {11.5, 14.5, 20.0})
            for (const Face face : {Face::Text, Face::Condensed, Face::Program})
                for (const QRectF& box : boxes)
                    for (const int align :
                         {int(Qt::AlignLeft | Qt::AlignVCenter),
                          int(Qt::AlignRight | Qt::AlignVCenter), int(Qt::AlignCenter),
                          int(Qt::AlignLeft | Qt::AlignTop), int(Qt::AlignRight | Qt::AlignBottom)})
                        for (const bool wraps : {false, true}) {
                            const QFont font = lettering(size, size > 15, face);
                            const QImage words = painted([&](QPainter& p) {
                                paintSetWords(p, box, align, text, font, wraps);
                            });
                            const QImage drawn = painted([&](QPainter& p) {
                                p.setFont(font);
                                const QFontMetricsF metrics(font);
                                if (wraps)
                                    p.drawText(box, align | Qt::TextWordWrap, text);
                                else
                                    p.drawText(box, align | Qt::TextSingleLine,
                                               metrics.horizontalAdvance(text) <= box.width() + 0.5
                                                   ? text
                                                   : metrics.elidedText(text, Qt::ElideRight,
                                                                        box.width()));
                            });
                            ASSERT_EQ(words, drawn)
                                << text.toStdString() << " size " << size << " face " << int(face)
                                << " box " << box.width() << " x " << box.height() << " align "
                                << align << (wraps ? " wraps" : "");
                        }
    EXPECT_NE(painted([](QPainter& p) {
                  paintSetWords(p, {10, 10, 300, 30}, Qt::AlignLeft, "Feed", lettering(15));
              }),
              painted([](QPainter&) {}))
        << "something is painted at all";
}

TEST(SetWords, AreCutWhereTheRoomEndsAndSaySo) {
    const QString text =
        "L1  PT0532  the axis X stands at the positive end of its travel: move it away by hand, or "
        "with the handwheel, then press Reset";
    const QFont font = lettering(12.5);
    const double line = setWords("Ag", font, 1000, true).height;
    EXPECT_EQ(wordsCutTo(text, font, QSizeF(4000, line)), text);
    for (const double wide : {150.0, 200.0, 280.0}) {
        const QString one = wordsCutTo(text, font, QSizeF(wide, line)),
                      two = wordsCutTo(text, font, QSizeF(wide, 2 * line + 3));
        for (const QString& cut : {one, two}) {
            EXPECT_TRUE(cut.endsWith(QChar(0x2026)) && text.startsWith(cut.chopped(1)))
                << cut.toStdString();
            EXPECT_LE(setWords(cut, font, wide, true).height,
                      (cut == one ? line : 2 * line + 3) + 1);
        }
        EXPECT_GT(two.size(), one.size() * 3 / 2);
    }
}

// Each step changes some items at random; what has been painted over the picture of before is what
// is painted anew.
TEST(Sheet, LeavesNoStalePixel) {
    std::mt19937 random(test_seed(11));
    const auto draw = [&](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    std::vector<double> numbers(12, 0.0);
    QStringList words{"hold", "Waiting for L2", "runs", "N160", "–", "0:01:12", "Ожидание"};
    std::vector<int> chosen(6, 0);
    int frame = 0, filled = 0, sign = 0;
    double bar = 0;
    FreeSheet sheet;
    sheet.resize(500, 320);
    sheet.onCompose = [&](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, 500, 320), t.window);
        w.fill(QRectF(4, 4, 492, 312), t.card, 10);
        w.frame(QRectF(4, 4, 492, 312), frame ? t.accent : t.edge, 10, frame ? 2 : 1);
        for (int i = 0; i < 12; ++i) {
            const QRectF box(10 + i % 3 * 160, 10 + i / 3 * 26, 158, 26);
            w.fill(box, i == filled ? t.mark : t.raised, i % 2 ? 6 : 0);
            w.text(box, QString::number(numbers[static_cast<std::size_t>(i)], 'f', 3),
                   lettering(i % 2 ? 15 : 22, i % 3 == 0), t.text,
                   i % 3 == 0   ? Qt::AlignRight | Qt::AlignVCenter
                   : i % 3 == 1 ? Qt::AlignCenter
                                : Qt::AlignLeft | Qt::AlignTop);
        }
        for (int i = 0; i < 6; ++i) {
            Item& item = w.text(QRectF(10 + i % 2 * 240, 120 + i / 2 * 30, 120, 28),
                                words[chosen[static_cast<std::size_t>(i)]], lettering(15), t.text);
            item.wraps = i == 3;
            item.data = true;
        }
        w.bar(QRectF(10, 230, 300, 8), bar, t.accent, t.edge);
        w.sign(QRectF(330, 220, 30, 30), static_cast<Sign>(1 + sign), t.warn);
        w.line({10, 250}, {480, 250}, t.edge, 1);
    };
    sheet.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&sheet));
    QImage shown(sheet.size(), QImage::Format_RGB32);
    sheet.render(&shown);
    int differed = 0;
    for (int step = 0; step < 300; ++step) {
        for (int n = draw(4); n >= 0; --n)
            numbers[static_cast<std::size_t>(draw(12))] +=
                draw(2) ? 0.001 * draw(2000) : -120.5 * draw(20);
        if (draw(3) == 0)
            chosen[static_cast<std::size_t>(draw(6))] = draw(static_cast<int>(words.size()));
        if (draw(9) == 0) frame = !frame;
        if (draw(5) == 0) filled = draw(12);
        if (draw(4) == 0) bar = draw(100) / 100.0;
        if (draw(6) == 0) sign = draw(20);
        // What the sheet asks to have painted again, and only that, over the picture of before.
        QRegion asked;
        struct Watch : QObject {
            QRegion* into;
            bool eventFilter(QObject*, QEvent* event) override {
                if (event->type() == QEvent::Paint)
                    *into |= static_cast<QPaintEvent*>(event)->region();
                return false;
            }
        } watch;
        watch.into = &asked;
        sheet.installEventFilter(&watch);
        sheet.refresh();
        QApplication::processEvents();
        sheet.removeEventFilter(&watch);
        if (!asked.isEmpty()) sheet.render(&shown, asked.boundingRect().topLeft(), asked);
        QImage anew(sheet.size(), QImage::Format_RGB32);
        sheet.render(&anew);
        ASSERT_EQ(shown, anew) << "step " << step;
        differed += asked.isEmpty() ? 0 : 1;
    }
    EXPECT_GT(differed, 200);
}

}  // namespace
}  // namespace polyturn::hmi
