#include "hmi/screens/programs/program_colours.hpp"

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>
#include <vector>

#include "hmi/widgets/theme.hpp"

namespace polyturn::hmi {
namespace {

struct ColourRule {
    QRegularExpression expression;
    QColor Theme::*colour;
    bool bold;
};

// Later rules win: comments and texts last.
const std::vector<ColourRule>& colourRules() {
    static const std::vector<ColourRule> rules = [] {
        std::vector<ColourRule> out;
        const auto add = [&](const char* pattern, QColor Theme::*colour, bool bold) {
            out.push_back({QRegularExpression(pattern, QRegularExpression::CaseInsensitiveOption),
                           colour, bold});
        };
        add("(?:^|(?<=[\\sA-Z0-9.]))[+-]?\\d*\\.?\\d+", &Theme::text, false);
        add("\\b(?:IF|GOTO[FBCS]?|THEN|WHILE|DO|END|ELSE|ENDIF|ENDWHILE|FOR|ENDFOR|LOOP|ENDLOOP|REPEAT|UNTIL|CASE|DEF|PROC|RET|CALL|STOPRE|MSG|AND|OR|XOR|MOD|EQ|NE|GT|LT|GE|LE|SIN|COS|TAN|ATAN|SQRT|ABS|ROUND|FIX|FUP)\\b",
            &Theme::wait, true);
        add("(?:#\\d+|#\\[|\\bR\\d+\\s*(?==)|\\$[A-Z_]+\\w*|\\bP\\d+\\s*(?==))", &Theme::wait,
            false);
        add("(?:^|(?<=[^A-Z_$]))G\\s*\\d+(?:\\.\\d+)?", &Theme::accent, true);
        add("(?:^|(?<=[^A-Z_$]))M\\s*\\d+", &Theme::good, true);
        add("(?:^|(?<=[^A-Z_$]))[TSDH]\\s*=?\\s*\\d+", &Theme::warn, false);
        add("^\\s*/?\\d?\\s*N\\d+", &Theme::dim, false);
        add("^\\s*(?:O\\d+|:\\d+|%.*)", &Theme::dim, true);
        return out;
    }();
    return rules;
}

class Coloured : public QTextBlockUserData {};  // a line that has its colours

}  // namespace

void ProgramColours::see(int first, int last) {
    first_ = first;
    last_ = last;
    for (QTextBlock block = document()->findBlockByNumber(first);
         block.isValid() && block.blockNumber() <= last; block = block.next())
        if (!block.userData()) rehighlightBlock(block);
}

void ProgramColours::highlightBlock(const QString& text) {
    const int line = currentBlock().blockNumber();
    if (!currentBlockUserData()) {
        if (line < first_ || line > last_) return;
        setCurrentBlockUserData(new Coloured);
    }
    const Theme& t = theme();
    for (const ColourRule& rule : colourRules()) {
        QTextCharFormat format;
        format.setForeground(t.*rule.colour);
        if (rule.bold) format.setFontWeight(QFont::Bold);
        for (auto found = rule.expression.globalMatch(text); found.hasNext();) {
            const auto one = found.next();
            setFormat(static_cast<int>(one.capturedStart()), static_cast<int>(one.capturedLength()),
                      format);
        }
    }
    QTextCharFormat comment, tool;
    comment.setForeground(t.faint);
    comment.setFontItalic(true);
    tool.setForeground(t.warn);
    // From left to right: a semicolon in a text begins no comment. A text that names a tool is read
    // as its number is.
    static const QRegularExpression kSemicolon("\"[^\"]*\"|;.*$"), kBrackets("\\([^)]*\\)?"),
        kTool("\\bT\\d*\\s*=\\s*$", QRegularExpression::CaseInsensitiveOption);
    const QRegularExpression& quiet =
        language_ == "sinumerik" || language_ == "fagor" ? kSemicolon : kBrackets;
    for (auto found = quiet.globalMatch(text); found.hasNext();) {
        const auto one = found.next();
        const auto from = static_cast<int>(one.capturedStart()),
                   length = static_cast<int>(one.capturedLength());
        if (const auto named = kTool.match(text.left(from)); named.hasMatch() && text[from] == '"')
            setFormat(static_cast<int>(named.capturedStart()),
                      from + length - static_cast<int>(named.capturedStart()), tool);
        else
            setFormat(from, length, comment);
    }
}

}  // namespace polyturn::hmi
