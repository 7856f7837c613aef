#include "hmi/app/help_language.hpp"

#include <QFile>
#include <QRegularExpression>

namespace polyturn::hmi {
namespace {

QString contentOfPage(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

QStringList placesOfPage(const QString& markdown) {
    static const QRegularExpression kHeading("^#{1,6} +(.+?)\\s*$"), kItem("^- \\*\\*(.+?)\\*\\*:");
    QStringList out;
    bool fenced = false;
    for (const QString& line : markdown.split('\n')) {
        if (line.startsWith("```")) fenced = !fenced;
        if (fenced) continue;
        if (const auto heading = kHeading.match(line); heading.hasMatch())
            out << heading.captured(1).remove('`').remove('*');
        if (const auto item = kItem.match(line); item.hasMatch()) out << item.captured(1) + ':';
    }
    return out;
}

HelpPlace placeInLanguage(const QString& folder, const HelpPlace& english,
                          const QString& language) {
    QString page = english.page;
    if (!page.endsWith(".md")) return english;
    page.insert(page.size() - 3, '.' + language);
    const QString text = contentOfPage(folder + "/" + page);
    if (text.isEmpty()) return english;
    const QStringList from = placesOfPage(contentOfPage(folder + "/" + english.page)),
                      to = placesOfPage(text);
    if (!english.find.isEmpty() && from.size() == to.size())
        for (qsizetype i = 0; i < from.size(); ++i)
            if (from[i].contains(english.find, Qt::CaseInsensitive)) return {page, to[i]};
    return {page, english.find};  // a code or a number: the same in every language
}

}  // namespace polyturn::hmi
