// The picture of a cycle beside its form: part, tool path, and the dimensions of the fields; that
// of the chosen field stands out.
#pragma once
#include <QWidget>

#include "hmi/widgets/pictures/cycle_scene.hpp"
#include "ipc/model/languages/cycle_block.hpp"

namespace polyturn::hmi {

class CyclePicture : public QWidget {
public:
    explicit CyclePicture(QWidget* parent) : QWidget(parent) {}
    void show(const forms::Form* form);           // null: nothing
    void point(int field, const QString& value);  // -1: none
    const forms::Form* form() const { return form_; }
    // behind the letters; the first one is the chosen field's
    const std::vector<QRectF>& plates() const { return plates_; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    const forms::Form* form_ = nullptr;
    Scene scene_;
    int field_ = -1;
    QString value_;
    std::vector<QRectF> plates_;
};

}  // namespace polyturn::hmi
