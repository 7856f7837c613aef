#include "hmi/machine/programs/code_help.hpp"

#include <QRegularExpression>
#include <algorithm>

#include "hmi/text/display_languages.hpp"
#include "ipc/model/languages/own_m_codes.hpp"

namespace polyturn::hmi {

QString referenceOf(Dialect language) {
    return language == Dialect::Fagor       ? "reference_fagor.md"
           : language == Dialect::Sinumerik ? "reference_sinumerik.md"
                                            : "reference_fanuc.md";
}

CodePlace placeOfCode(const QString& word, const QString& language) {
    static const QRegularExpression kCode("^([GM])0*(\\d+(?:\\.\\d+)?)$"),
        kName("^\\$?[A-Z][A-Z_0-9]{2,}$");
    const QString upper = word.toUpper();
    const Dialect speaks = dialect_of(language.toStdString());
    const bool fagor = speaks == Dialect::Fagor, sinumerik = speaks == Dialect::Sinumerik;
    const QString page = referenceOf(speaks);
    if (const auto code = kCode.match(upper); code.hasMatch()) {
        const QString number = code.captured(2);
        // what ends, calls and stops programs is the language's own; the rest are waits and the
        // PLC's
        if (code.captured(1) == "M") {
            const auto own = text::own_m_codes(speaks);
            if (const QString code_name = "M" + number;
                std::any_of(own.begin(), own.end(), [&](const text::OwnMCode& one) {
                    return fromView(one.name) == code_name;
                }))
                return {page, code_name};
            if (number.toDouble() >= 100) return {"programmer.md", "Waiting", false};
            return {"setup.md", "M codes of the built-in PLC", false};
        }
        return {page,
                "G" + (fagor && number.section('.', 0, 0).size() < 2 ? "0" : QString()) + number};
    }
    if ((fagor || sinumerik) && kName.match(upper).hasMatch()) return {page, upper};
    return {};
}

QString wordAt(const QString& line, int column) {
    const auto part = [](QChar c) {
        return c.isLetterOrNumber() || c == '.' || c == '_' || c == '$';
    };
    int begin = std::min(column, static_cast<int>(line.size())), end = begin;
    while (begin > 0 && part(line[begin - 1])) --begin;
    while (end < line.size() && part(line[end])) ++end;
    // Words without a blank between them: G1X40. is G1 and X40.
    static const QRegularExpression kWords("[A-Z]+_?[A-Z]*\\d*(?:\\.\\d+)?\\.?|\\d+",
                                           QRegularExpression::CaseInsensitiveOption);
    QString last = line.mid(begin, end - begin);
    if (!QRegularExpression("^[A-Z]-?[0-9.]", QRegularExpression::CaseInsensitiveOption)
             .match(last)
             .hasMatch())
        return last;
    for (auto all = kWords.globalMatch(last); all.hasNext();) {
        const auto one = all.next();
        if (column - begin <= one.capturedEnd()) return one.captured();
    }
    return last;
}

}  // namespace polyturn::hmi
