// What must hold for every screen in every language: no word is shortened because it does not fit.
#pragma once
#include <gtest/gtest.h>

#include "hmi/app/main_window.hpp"

namespace polyturn::hmi {

inline void noWordIsShortened(MainWindow& window) {
    for (const Tongue tongue : kTongues) {
        window.setTongue(tongue);
        for (std::size_t i = 0; i < window.screens().size(); ++i) {
            window.showScreen(static_cast<int>(i));
            std::vector<Sheet*> sheets = window.ownSheets();
            for (Sheet* one : window.screen()->sheets()) sheets.push_back(one);
            for (Sheet* sheet : sheets)
                for (const QString& text : sheet->shortened())
                    ADD_FAILURE() << codeOf(tongue) << ", " << window.screen()->name() << ", " << window.width() << "x" << window.height() << ": does not fit: " << text.toStdString();
        }
    }
    window.setTongue(Tongue::English);
}

}  // namespace polyturn::hmi
