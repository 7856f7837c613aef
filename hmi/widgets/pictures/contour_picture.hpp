// A contour as it is entered: what is known, the other solutions to touch, where it is open. Z to
// the right, X upwards.
#pragma once
#include <QWidget>
#include <functional>
#include <optional>

#include "hmi/contour/contour.hpp"

namespace polyturn::hmi {

class ContourPicture : public QWidget {
public:
    explicit ContourPicture(QWidget* parent) : QWidget(parent) {}
    // element: chosen; -1: the start
    void show(const contour::Contour& contour, const contour::Solved& solved, int element);
    std::function<void(std::size_t choice, std::size_t solution)> onChosen;
    // A point on a solution that is not the chosen one, for touches and tests; nothing: there is
    // none.
    std::optional<QPointF> placeOf(std::size_t choice, std::size_t solution) const;

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;

private:
    struct View {
        double scale = 1, z = 0, x = 0;  // px a mm; what lies in the middle
    };
    View view() const;
    QPointF at(const View& v, contour::Point p) const;

    contour::Contour contour_;
    contour::Solved solved_;
    int element_ = -1;
};

}  // namespace polyturn::hmi
