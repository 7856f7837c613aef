// The words of a program in colours.
#pragma once
#include <QSyntaxHighlighter>

namespace polyturn::hmi {

// Comments, block numbers, G and M words, tools, variables, words of the language, numbers. A line
// gets its colours when it is seen.
class ProgramColours : public QSyntaxHighlighter {
public:
    ProgramColours(QTextDocument* document, QString language)
        : QSyntaxHighlighter(document), language_(std::move(language)) {}
    void see(int first, int last);  // these lines are on the screen now

protected:
    void highlightBlock(const QString& text) override;

private:
    QString language_;
    int first_ = 0, last_ = -1;
};

}  // namespace polyturn::hmi
