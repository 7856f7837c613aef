// What must hold for every screen in every language: no word is shortened because it does not fit, none is written over another.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hmi/app/main_window.hpp"

namespace polyturn::hmi {

// Every text that does not fit, with where it stands; `looked` counts the sheets that were asked.
inline std::vector<std::string> shortenedWords(MainWindow& window, int& looked) {
    std::vector<std::string> found;
    looked = 0;
    for (const Tongue tongue : kTongues) {
        window.setTongue(tongue);
        for (std::size_t i = 0; i < window.screens().size(); ++i) {
            window.showScreen(static_cast<int>(i));
            const bool starts = QString(window.screen()->name()) == "programs";   // its pages start processes
            const QString before = window.screen()->state();
            const int pages = starts ? 1 : QString(window.screen()->name()) == "graphics" ? 2 : window.screen()->pages();   // its third one too
            for (int page = 0; page < pages; ++page) {
                if (!starts) window.screen()->turnTo(page), window.screen()->refresh();
                window.softKeys().show(window.screen()->keys());
                std::vector<Sheet*> sheets = window.ownSheets();
                for (Sheet* one : window.screen()->sheets()) sheets.push_back(one);
                looked += static_cast<int>(sheets.size());
                const std::string where = codeOf(tongue) + (", " + std::string(window.screen()->name())) + " " + std::to_string(page + 1) + ": ";
                for (Sheet* sheet : sheets) {
                    for (const QString& text : sheet->shortened()) found.push_back(where + text.toStdString());
                    if (!sheet->isVisibleTo(&window)) continue;
                    for (const QString& text : sheet->overlapping()) found.push_back(where + text.toStdString());
                }
            }
            if (!starts) window.screen()->restore(before);
        }
    }
    window.setTongue(Tongue::English);
    return found;
}

inline void noWordIsShortened(MainWindow& window) {
    int looked = 0;
    const std::vector<std::string> found = shortenedWords(window, looked);
    EXPECT_GE(looked, static_cast<int>(std::size(kTongues) * window.screens().size()));
    EXPECT_TRUE(found.empty()) << window.width() << "x" << window.height() << ": " << ::testing::PrintToString(found);
}

}  // namespace polyturn::hmi
