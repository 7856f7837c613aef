#include "hmi/machine/programs/text_difference.hpp"

#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <algorithm>
#include <cstdint>
#include <dtl/dtl.hpp>

#include "hmi/machine/programs/ordinary_file.hpp"

namespace polyturn::hmi {
namespace {

// of lines, a second or less; their number grows with lines times differences
constexpr std::int64_t kMostComparisons = 20'000'000;
constexpr qint64 kMostBytes = 64 << 20;

bool readLines(const QString& name, QStringList& out) {
    QFile file;
    if (!openOrdinary(file, name) || file.size() > kMostBytes) return false;
    out = QString::fromUtf8(file.readAll()).split('\n');
    for (QString& line : out)
        while (!line.isEmpty() && line.back().isSpace()) line.chop(1);
    if (!out.isEmpty() && out.back().isEmpty()) out.removeLast();
    return true;
}

// Whether two lines are the same one; counts, so that the search can be ended: from then on all
// are, which leads it to the end of both texts at once, and its result is thrown away.
struct Alike {
    const std::atomic<bool>* stop = nullptr;
    std::int64_t* left = nullptr;  // comparisons
    bool impl(int a, int b) const { return over() || (--*left, a == b); }
    bool over() const { return *left <= 0 || *stop; }
};

// Lines as numbers, the same one for equal lines.
std::vector<int> numbered(const QStringList& lines, QHash<QString, int>& numbers) {
    std::vector<int> out;
    for (const QString& line : lines) {
        const auto known = numbers.constFind(line);
        out.push_back(known != numbers.constEnd()
                          ? *known
                          : *numbers.insert(line, static_cast<int>(numbers.size())));
    }
    return out;
}

// The shortest edit script from a to b; nothing if the search was ended.
bool shortest(const QStringList& a, const QStringList& b, const std::atomic<bool>& stop,
              std::vector<PairedLine>& out) {
    QHash<QString, int> numbers;
    std::int64_t left = kMostComparisons;
    const Alike alike{&stop, &left};
    dtl::Diff<int, std::vector<int>, Alike> search(numbered(a, numbers), numbered(b, numbers),
                                                   alike);
    search.compose();
    if (alike.over()) return false;
    int x = 0, y = 0;
    for (const auto& [number, step] : search.getSes().getSequence()) {
        const bool from_left = step.type != dtl::SES_ADD, from_right = step.type != dtl::SES_DELETE;
        out.push_back({from_left ? x++ : -1, from_right ? y++ : -1, from_left && from_right});
    }
    return true;
}

// Lines that were left out and lines that came in their place stand side by side.
std::vector<PairedLine> sideBySide(const std::vector<PairedLine>& in) {
    std::vector<PairedLine> out;
    for (std::size_t i = 0; i < in.size();) {
        if (in[i].same) {
            out.push_back(in[i++]);
            continue;
        }
        std::vector<int> left, right;
        for (; i < in.size() && !in[i].same; ++i)
            (in[i].left >= 0 ? left : right).push_back(in[i].left >= 0 ? in[i].left : in[i].right);
        for (std::size_t j = 0; j < std::max(left.size(), right.size()); ++j)
            out.push_back(
                {j < left.size() ? left[j] : -1, j < right.size() ? right[j] : -1, false});
    }
    return out;
}

}  // namespace

Difference differenceOf(QStringList left, QStringList right, const std::atomic<bool>& stop) {
    Difference out;
    // What is alike at begin and end is no part of the search.
    int head = 0, tail = 0;
    const int n = static_cast<int>(left.size()), m = static_cast<int>(right.size());
    while (head < n && head < m && left[head] == right[head]) ++head;
    while (tail < n - head && tail < m - head && left[n - 1 - tail] == right[m - 1 - tail]) ++tail;
    std::vector<PairedLine> middle;
    const QStringList a = left.mid(head, n - head - tail), b = right.mid(head, m - head - tail);
    if (!shortest(a, b, stop, middle)) {
        out.rough = true;
        for (int i = 0; i < std::max(a.size(), b.size()); ++i)
            middle.push_back({i < a.size() ? i : -1, i < b.size() ? i : -1,
                              i < a.size() && i < b.size() && a[i] == b[i]});
    } else {
        middle = sideBySide(middle);
    }
    for (int i = 0; i < head; ++i) out.lines.push_back({i, i, true});
    for (const PairedLine& one : middle)
        out.lines.push_back(
            {one.left < 0 ? -1 : one.left + head, one.right < 0 ? -1 : one.right + head, one.same});
    for (int i = 0; i < tail; ++i) out.lines.push_back({n - tail + i, m - tail + i, true});
    for (std::size_t i = 0; i < out.lines.size(); ++i)
        out.places += !out.lines[i].same && (i == 0 || out.lines[i - 1].same);
    out.left = std::move(left);
    out.right = std::move(right);
    return out;
}

Difference compareFiles(const QString& left, const QString& right, const std::atomic<bool>& stop) {
    QStringList a, b;
    Difference out;
    if (!readLines(left, a)) {
        out.fault = QFileInfo(left).fileName();
        return out;
    }
    if (!readLines(right, b)) {
        out.fault = QFileInfo(right).fileName();
        return out;
    }
    return differenceOf(std::move(a), std::move(b), stop);
}

}  // namespace polyturn::hmi
