#include "hmi/machine/programs/draft.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace polyturn::hmi {

// A line of what belongs to it, then the text.
QByteArray Draft::written() const {
    const QJsonObject about{
        {"file", file},         {"canonical", canonical},
        {"language", language}, {"position", position},
        {"dos", dos},           {"from", part.from},
        {"to", part.to},        {"all", part.all},
        {"line", part.line},    {"written_ns", QString::number(part.written_ns)}};
    return QJsonDocument(about).toJson(QJsonDocument::Compact) + '\n' + text.toUtf8();
}

Draft Draft::read(const QByteArray& bytes) {
    Draft out;
    const auto end = bytes.indexOf('\n');
    const QJsonObject about =
        QJsonDocument::fromJson(bytes.left(std::max<qsizetype>(0, end))).object();
    const auto number = [&](const char* name) {
        return static_cast<qint64>(about.value(name).toDouble());
    };
    out.file = about.value("file").toString();
    out.canonical = about.value("canonical").toString();
    out.language = about.value("language").toString();
    out.position = about.value("position").toInt();
    out.dos = about.value("dos").toBool();
    out.part = {number("from"), number("to"), number("all"), number("line"),
                about.value("written_ns").toString().toLongLong()};
    out.text = QString::fromUtf8(bytes.mid(end + 1));
    return out;
}

}  // namespace polyturn::hmi
