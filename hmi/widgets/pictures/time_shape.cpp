#include "hmi/widgets/pictures/time_shape.hpp"

namespace polyturn::hmi {

void drawTimeShape(Writer& w, TimeShape shape, const QRectF& bar, const QColor& colour) {
    switch (shape) {
        case TimeShape::Full:
            w.fill(bar, colour);
            break;
        case TimeShape::Half:
            w.fill(bar.adjusted(0, bar.height() / 2, 0, 0), colour);
            break;
        case TimeShape::Hatched:
            w.hatch(bar, colour);
            break;
        case TimeShape::Hollow:
            w.frame(bar.adjusted(0, bar.height() * 0.25, 0, -bar.height() * 0.25), colour, 0,
                    px(2));
            break;
    }
}

}  // namespace polyturn::hmi
