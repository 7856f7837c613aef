// Sources as tests read them: statements and rows, each in one line, without comments.
#pragma once
#include <QString>
#include <QStringList>

namespace polyturn::hmi {

inline QStringList statementsOf(const QString& source) {
    QStringList out{QString()};
    for (const QString& whole : source.split('\n')) {
        const QString line = whole.trimmed();
        if (line.startsWith("//")) continue;
        out.back() += (out.back().isEmpty() ? "" : " ") + line;
        if (line.isEmpty() || line.startsWith('#') || line.endsWith(';') || line.endsWith('{') ||
            line.endsWith('}') || line.endsWith("},"))
            out << QString();
    }
    return out;
}

}  // namespace polyturn::hmi
