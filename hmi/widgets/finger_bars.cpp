#include "hmi/widgets/finger_bars.hpp"

#include <QAbstractScrollArea>
#include <QScrollBar>

#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {

void setFingerBars(QAbstractScrollArea& area) {
    constexpr int kLeastHandle = 64;  // units
    const Theme& t = theme();
    for (QScrollBar* bar : {area.verticalScrollBar(), area.horizontalScrollBar()}) {
        const bool upright = bar->orientation() == Qt::Vertical;
        const QString wide = upright ? "width" : "height", along = upright ? "height" : "width";
        const QString style =
            QString(
                "QScrollBar { background: %1; border: none; margin: 0; %2: %3px; }"
                "QScrollBar::handle { background: %4; border-radius: %5px; margin: %6px; "
                "min-%7: %8px; }"
                "QScrollBar::handle:pressed { background: %9; }"
                "QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }"
                "QScrollBar::add-page, QScrollBar::sub-page { background: none; }")
                .arg(t.bar.name(), wide)
                .arg(px(kFingerBar))
                .arg(t.dim.name())
                .arg(px(kFingerBar) / 2 - px(6))
                .arg(px(5))
                .arg(along)
                .arg(px(kLeastHandle))
                .arg(t.accent.name());
        if (bar->styleSheet() != style) bar->setStyleSheet(style);
    }
}

}  // namespace polyturn::hmi
