#include "hmi/text/search.hpp"

namespace polyturn::hmi {

QString withoutAccents(const QString& text) {
    QString out;
    out.reserve(text.size());
    for (const QChar one : text) {
        const QChar plain = one.unicode() >= 0x80 && one.script() == QChar::Script_Latin &&
                                    one.decompositionTag() == QChar::Canonical
                                ? one.decomposition().at(0)
                                : one;
        out += plain;
    }
    return out;
}

bool holds(const QString& text, const QString& typed) {
    return text.contains(typed, Qt::CaseInsensitive) ||
           withoutAccents(text).contains(withoutAccents(typed), Qt::CaseInsensitive);
}

}  // namespace polyturn::hmi
