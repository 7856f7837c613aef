// What must hold for every screen in every language: no word is shortened because it does not fit,
// none is written over another.
#pragma once
#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QtTest/QTest>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "hmi/app/main_window.hpp"
#include "tests/places.hpp"

namespace polyturn::hmi {

// Everything that the screens say by themselves, in a language: a cell of a table that shows one of
// these shows a word of ours, no data.
inline const std::set<QString>& ownWords(DisplayLanguage display_language) {
    static std::map<DisplayLanguage, std::set<QString>> all;
    std::set<QString>& out = all[display_language];
    if (!out.empty()) return out;
    static const QRegularExpression kSource("<source>([^<]*)</source>"),
        kTranslation("<translation>([^<]*)</translation>");
    QFile file(QString("%1/hmi/translations/polyturn_%2.ts")
                   .arg(QString(kSourceFolder), display_language == DisplayLanguage::English
                                                    ? QString("ru")
                                                    : QString(codeOf(display_language))));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    for (auto found = (display_language == DisplayLanguage::English ? kSource : kTranslation)
                          .globalMatch(QString::fromUtf8(file.readAll()));
         found.hasNext();) {
        QString text = found.next().captured(1);
        out.insert(text.replace("&apos;", "'")
                       .replace("&quot;", "\"")
                       .replace("&lt;", "<")
                       .replace("&gt;", ">")
                       .replace("&amp;", "&"));
    }
    return out;
}

// Of the programs' screen: what it shows just now, or all its pages that start no process.
enum class ProgramPages : std::uint8_t { AsTheyAre, All };

// Each page of each screen, then what lies over the screens.
inline void eachPage(
    MainWindow& window, ProgramPages wanted,
    const std::function<void(const std::string& where, const std::vector<Sheet*>& sheets)>& look) {
    const auto settled = [&](const std::function<bool()>& condition) {
        for (int i = 0; i < 100 && !condition(); ++i) QTest::qWait(20);
    };
    for (std::size_t i = 0; i < window.screens().size(); ++i) {
        window.showScreen(static_cast<int>(i));
        const QString name = window.screen()->name(), before = window.screen()->state();
        const bool programs = name == "programs",
                   asItIs = programs && wanted == ProgramPages::AsTheyAre;
        if (programs && !asItIs) {  // with a job in the list: without one there is only this page
            window.screen()->restore(QString("0|") + kSourceFolder +
                                     "/examples/jobs/shaft/shaft.job.toml");
            settled([&] { return window.screen()->pages() > 1; });
            EXPECT_GT(window.screen()->pages(), 1);
        }
        // its third one is a dry run, and so are
        const int pages = asItIs ? 1 : name == "graphics" ? 2 : window.screen()->pages();
        for (int page = 0; page < pages; ++page) {
            // these of the programs
            if (programs && (page == 1 || page == 2)) continue;
            if (!asItIs) window.screen()->turnTo(page);
            if (programs && !asItIs) settled([&] { return !window.screen()->busy(); });
            window.screen()->refresh();
            window.softKeys().show(window.screen()->keys());
            std::vector<Sheet*> sheets = window.ownSheets();
            for (Sheet* one : window.screen()->sheets()) sheets.push_back(one);
            look(name.toStdString() + " " + std::to_string(page + 1), sheets);
        }
        if (!asItIs) window.screen()->turnTo(0);
        if (!programs) window.screen()->restore(before);
    }
    for (const auto& [over, name] : MainWindow::kOvers) {
        if (!window.showOver(over)) continue;
        for (Sheet* one : window.overSheets()) one->refresh();
        look(name, window.overSheets());
    }
    window.showOver(MainWindow::Over::Screen);
}

inline bool standsOn(const std::vector<Sheet*>& sheets, const QString& text) {
    for (const Sheet* sheet : sheets)
        for (const Item& one : sheet->items())
            if (one.text.contains(text)) return true;
    return false;
}

// Each key that asks before it acts, lit or not, in its asking state; `tell` hears what does not
// fit there. Nothing acts.
inline void askEach(SoftKeyBar& bar, const std::vector<SoftKey>& keys,
                    const std::function<void(const QString&)>& tell) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].confirm.isEmpty()) continue;
        std::vector<SoftKey> lit = keys;
        lit[i].enabled = true;
        bar.show({});
        bar.show(lit);
        bar.press(static_cast<int>(i));
        EXPECT_EQ(bar.asked(), static_cast<int>(i));
        for (const QString& text : bar.shortened()) tell(text);
        for (const QString& text : bar.overlapping()) tell(text);
    }
    bar.show({});
    bar.show(keys);
}

// Lines that are cut above or below: neither dots nor a gap say that something is missing, so data
// too.
inline std::vector<QString> cutLines(const Sheet& sheet) {
    std::vector<QString> out;
    for (const Item& item : sheet.items())
        if (item.kind == Item::Kind::Text && item.wraps &&
            QFontMetricsF(item.font)
                    .boundingRect(QRectF(0, 0, item.box.width(), 1e5), Qt::TextWordWrap, item.text)
                    .height() > item.box.height() + 1.5)
            out.push_back(item.text);
    return out;
}

// Every text that does not fit, with where it stands; `looked` counts the sheets that were asked.
inline std::vector<std::string> shortenedWords(MainWindow& window, int& looked,
                                               ProgramPages wanted = ProgramPages::AsTheyAre) {
    std::vector<std::string> found;
    looked = 0;
    for (const DisplayLanguage display_language : kDisplayLanguages) {
        window.setDisplayLanguage(display_language);
        const std::set<QString>& own = ownWords(display_language);
        eachPage(window, wanted, [&](const std::string& page, const std::vector<Sheet*>& sheets) {
            looked += static_cast<int>(sheets.size());
            const std::string where = codeOf(display_language) + (", " + page) + ": ";
            for (Sheet* sheet : sheets) {
                for (const QString& text : sheet->shortened())
                    found.push_back(where + text.toStdString());
                for (const QString& text : sheet->shortenedData())
                    if (own.count(text))
                        found.push_back(where + text.toStdString() + " (a word of ours)");
                if (!sheet->isVisibleTo(&window)) continue;
                for (const QString& text : cutLines(*sheet))
                    found.push_back(where + text.toStdString() + " (its lines are cut)");
                for (const QString& text : sheet->overlapping())
                    found.push_back(where + text.toStdString());
            }
            if (sheets != window.overSheets())
                askEach(window.softKeys(), window.screen()->keys(), [&](const QString& text) {
                    found.push_back(where + text.toStdString() + " (a key that asks)");
                });
        });
    }
    window.setDisplayLanguage(DisplayLanguage::English);
    return found;
}

inline void noWordIsShortened(MainWindow& window, ProgramPages wanted = ProgramPages::AsTheyAre) {
    int looked = 0;
    const std::vector<std::string> found = shortenedWords(window, looked, wanted);
    EXPECT_GE(looked, static_cast<int>(std::size(kDisplayLanguages) * window.screens().size()));
    EXPECT_TRUE(found.empty()) << window.width() << "x" << window.height() << ": "
                               << ::testing::PrintToString(found);
}

}  // namespace polyturn::hmi
