#include "hmi/app/help_slices.hpp"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace polyturn::hmi {
namespace {

constexpr double kMostLetters = 60;  // of a cell that are worth a wider column
constexpr double kLeastLetters = 4;
constexpr double kCellRoom = 4;       // letters: between a word and the lines beside it
constexpr double kPageLetters = 104;  // of a line of the page on a panel of 1280

bool rowOfTable(const QString& line) { return line.startsWith('|'); }

QStringList cellsOf(const QString& row) {
    QString inner = row.trimmed();
    inner.remove(0, 1);
    if (inner.endsWith('|')) inner.chop(1);
    inner.replace("\\|", QString(QChar(1)));
    return inner.split('|');
}

// Without the signs of markdown.
QString shownText(const QString& markdown) {
    QString out;
    out.reserve(markdown.size());
    for (const QChar c : markdown)
        if (c != '*' && c != '`' && c != '\\') out += c;
    return out;
}

// An empty cell stays one: Qt takes it for a part of the cell before.
QString withEmptyCells(QString row) {
    static const QRegularExpression kEmpty("\\|\\s*(?=\\|)");
    return row.replace(kEmpty, QString("| ") + QChar(QChar::Nbsp) + ' ');
}

// A column is as wide as its longest word at least, and shares the rest by what it has to say.
std::vector<double> sharesOf(const QStringList& rows) {
    std::vector<double> least, wanted;
    for (const QString& row : rows) {
        if (row.contains("---")) continue;
        const QStringList cells = cellsOf(row);
        least.resize(std::max(least.size(), static_cast<std::size_t>(cells.size())), kLeastLetters);
        wanted.resize(least.size(), kLeastLetters);
        for (qsizetype c = 0; c < cells.size(); ++c) {
            const QString text = shownText(cells[c]).trimmed();
            double word = 0;
            for (const QString& one : text.split(' '))
                word = std::max<double>(word, static_cast<double>(one.size()));
            auto& low = least[static_cast<std::size_t>(c)];
            auto& much = wanted[static_cast<std::size_t>(c)];
            low = std::max(low, word + kCellRoom);
            much = std::max(much, std::min(kMostLetters, static_cast<double>(text.size()) + 2));
        }
    }
    double words = 0, more = 0;
    for (std::size_t c = 0; c < wanted.size(); ++c) {
        words += least[c];
        more += wanted[c] = std::max(0.0, wanted[c] - least[c]);
    }
    const double spare = std::max(0.0, kPageLetters - words), all = words + (more > 0 ? spare : 0);
    for (std::size_t c = 0; c < wanted.size(); ++c)
        wanted[c] = (least[c] + (more > 0 ? spare * wanted[c] / more : 0)) * 100 / all;
    return wanted;
}

}  // namespace

std::vector<HelpSlice> sliceHelp(const QString& markdown) {
    static const QRegularExpression kPicture("^!\\[[^\\]]*\\]\\(([^)]+)\\)\\s*$");
    std::vector<HelpSlice> out;
    const QStringList lines = markdown.split('\n');
    QStringList text;
    const auto flush = [&] {
        if (!text.join("").trimmed().isEmpty()) out.push_back({text.join('\n'), {}, false, {}});
        text.clear();
    };
    bool fenced = false;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString& line = lines[i];
        if (line.startsWith("```")) fenced = !fenced;
        if (!fenced && rowOfTable(line) && i + 1 < lines.size() && rowOfTable(lines[i + 1])) {
            flush();
            QStringList rows;
            for (; i < lines.size() && rowOfTable(lines[i]); ++i) rows << withEmptyCells(lines[i]);
            --i;
            const std::vector<double> shares =
                rows.size() > kMostSliceRows + 2 ? sharesOf(rows) : std::vector<double>();
            for (qsizetype from = 2; from == 2 || from < rows.size(); from += kMostSliceRows)
                out.push_back({(rows.mid(0, 2) + rows.mid(from, kMostSliceRows)).join('\n') + '\n',
                               shares,
                               from > 2,
                               {},
                               from + kMostSliceRows >= rows.size()});
            continue;
        }
        if (const auto picture = kPicture.match(line); !fenced && picture.hasMatch()) {
            flush();
            out.push_back({line + '\n', {}, false, picture.captured(1)});
            continue;
        }
        // Between paragraphs: not within a list or a block of code, whose lines belong together.
        const bool apart = !fenced && line.trimmed().isEmpty() && i + 1 < lines.size() &&
                           !lines[i + 1].startsWith(' ') && !lines[i + 1].startsWith('\t');
        text << line;
        if ((apart || (!fenced && i + 1 < lines.size() && lines[i + 1].startsWith('#'))) &&
            text.size() >= kMostSliceLines / 2)
            flush();
        else if (!fenced && text.size() >= kMostSliceLines && i + 1 < lines.size() &&
                 lines[i + 1].startsWith("- "))
            // a long list: before its next item
            flush();
    }
    flush();
    return out;
}

int sliceWith(const std::vector<HelpSlice>& slices, const QString& find, bool code) {
    if (find.isEmpty()) return -1;
    const QString quoted = QRegularExpression::escape(find);
    const QRegularExpression wanted(code ? "(?<![\\w])" + quoted + "(?![\\w])" : quoted,
                                    code ? QRegularExpression::UseUnicodePropertiesOption
                                         : QRegularExpression::CaseInsensitiveOption |
                                               QRegularExpression::UseUnicodePropertiesOption);
    for (std::size_t i = 0; i < slices.size(); ++i)
        if (slices[i].picture.isEmpty() &&
            wanted.match(shownText(slices[i].markdown).simplified()).hasMatch())
            return static_cast<int>(i);
    return -1;
}

int splitAt(std::vector<HelpSlice>& slices, int slice, const QString& find) {
    if (slice < 0 || !slices[static_cast<std::size_t>(slice)].shares.empty()) return slice;
    const QStringList lines = slices[static_cast<std::size_t>(slice)].markdown.split('\n');
    qsizetype at = 0;
    while (at < lines.size() && !shownText(lines[at]).contains(find, Qt::CaseInsensitive)) ++at;
    if (at == lines.size()) return slice;  // over the end of a line
    while (at > 0 && !lines[at].startsWith('#') && !lines[at].startsWith("- ") &&
           !lines[at - 1].trimmed().isEmpty())
        --at;
    if (lines.mid(0, at).join("").trimmed().isEmpty()) return slice;
    slices[static_cast<std::size_t>(slice)].markdown = lines.mid(at).join('\n');
    slices.insert(slices.begin() + slice, {lines.mid(0, at).join('\n') + '\n', {}, false, {}});
    return slice + 1;
}

}  // namespace polyturn::hmi
