// Parameters of machines with more channels than the examples have.
#pragma once
#include <QByteArray>
#include <QFile>
#include <QRegularExpression>
#include <QString>

#include "tests/places.hpp"

namespace polyturn::hmi {

// The demonstration machine with further channels, each with X and Z like those of its second one;
// from `second` on they are machine group 2.
inline QByteArray machineWith(int channels, int second = 99) {
    QFile file(QString(kSourceFolder) + "/examples/machines/twin-turret/machine.params");
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QString text = QString::fromUtf8(file.readAll());
    QString out = text;
    const QRegularExpression row("^(\\w+) (A3|A4|L2)=([^;\\s]+)",
                                 QRegularExpression::MultilineOption);
    int axis = 7;
    for (int channel = 3; channel <= channels; ++channel, axis += 2) {
        out += QString("\nN0000 L%1=%2\n").arg(channel).arg(channel >= second ? 2 : 1);
        for (auto found = row.globalMatch(text); found.hasNext();) {
            const auto one = found.next();
            const QString name = one.captured(1), scope = one.captured(2);
            QString value = one.captured(3);
            if (scope == "L2") {
                if (name == "N0000" || name == "N0687" || name == "PT_TURRET_MAGAZINE") continue;
                out += QString("%1 L%2=%3\n").arg(name).arg(channel).arg(value);
                continue;
            }
            const int number = axis + (scope == "A4");
            if (name == "N0002") value = QString::number(channel);
            if (name == "N0501" || name == "N0503") value = QString::number(number);
            out += QString("%1 A%2=%3\n").arg(name).arg(number).arg(value);
        }
    }
    return out.toUtf8();
}

}  // namespace polyturn::hmi
