#include "hmi/screens/overview/channel_keys.hpp"

#include <algorithm>

namespace polyturn::hmi {

double composeChannelKeys(Writer& w, const Context& context, const QSizeF& title) {
    const Theme& t = theme();
    const auto& all = context.live.channels();
    double right = title.width() - px(8);
    for (auto channel = all.rbegin(); channel != all.rend(); ++channel) {
        const bool here = *channel == context.channel;
        const double step =
            std::min<double>(px(60), title.width() * 0.6 / static_cast<double>(all.size()));
        const QRectF box(right - step + px(2), px(7), step - px(6), title.height() - px(12));
        w.fill(box, here ? t.mark : t.card, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        // sixteen on a portrait panel
        w.text(box, QString("L%1").arg(*channel),
               step < px(40) ? lettering(12.5, here, Face::Condensed) : lettering(16, here), t.text,
               Qt::AlignCenter);
        w.hit(box, static_cast<int>(*channel));
        right -= step;
    }
    return right;
}

}  // namespace polyturn::hmi
