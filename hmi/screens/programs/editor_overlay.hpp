// What lies over the editor's text for a while and writes into it: cycle forms, the contour
// calculator.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "ipc/model/languages/cycle_block.hpp"

namespace polyturn::hmi {

class EditorOverlay : public QWidget {
public:
    explicit EditorOverlay(QWidget* parent) : QWidget(parent) { setAutoFillBackground(true); }
    virtual void refresh() = 0;
    virtual bool key(QKeyEvent* event) = 0;
    virtual void addKeys(std::vector<SoftKey>& keys) = 0;
    virtual std::vector<Sheet*> sheets() = 0;

    std::function<void(const std::vector<forms::LineChange>&)> onWrite;
    std::function<void()> onClose;
};

}  // namespace polyturn::hmi
