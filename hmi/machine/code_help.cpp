#include "hmi/machine/code_help.hpp"

#include <QRegularExpression>
#include <algorithm>

namespace polyturn::hmi {

CodePlace placeOfCode(const QString& word, const QString& language) {
    static const QRegularExpression kCode("^([GM])0*(\\d+(?:\\.\\d+)?)$"), kName("^\\$?[A-Z][A-Z_0-9]{2,}$");
    const QString upper = word.toUpper();
    const bool fagor = language == "fagor", sinumerik = language == "sinumerik";
    const QString page = fagor ? "reference_fagor.md" : sinumerik ? "reference_sinumerik.md" : "reference_fanuc.md";
    if (const auto code = kCode.match(upper); code.hasMatch()) {
        const QString number = code.captured(2);
        if (code.captured(1) == "M" && number.toDouble() >= 100) return {"programmer.md", "Waiting"};
        if (code.captured(1) == "M") return {"setup.md", "M" + number};
        return {page, "G" + (fagor && number.section('.', 0, 0).size() < 2 ? "0" : QString()) + number};
    }
    if ((fagor || sinumerik) && kName.match(upper).hasMatch()) return {page, upper};
    return {};
}

QString wordAt(const QString& line, int column) {
    const auto part = [](QChar c) { return c.isLetterOrNumber() || c == '.' || c == '_' || c == '$'; };
    int begin = std::min(column, static_cast<int>(line.size())), end = begin;
    while (begin > 0 && part(line[begin - 1])) --begin;
    while (end < line.size() && part(line[end])) ++end;
    // Words without a blank between them: G1X40. is G1 and X40.
    static const QRegularExpression kWords("[A-Z]+_?[A-Z]*\\d*(?:\\.\\d+)?\\.?|\\d+", QRegularExpression::CaseInsensitiveOption);
    QString last = line.mid(begin, end - begin);
    if (!QRegularExpression("^[A-Z]-?[0-9.]", QRegularExpression::CaseInsensitiveOption).match(last).hasMatch()) return last;
    for (auto all = kWords.globalMatch(last); all.hasNext();) {
        const auto one = all.next();
        if (column - begin <= one.capturedEnd()) return one.captured();
    }
    return last;
}

}  // namespace polyturn::hmi
