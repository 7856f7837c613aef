#include "hmi/machine/text_difference.hpp"

#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace polyturn::hmi {
namespace {

constexpr int kMostEdits = 3000;            // the memory of the way grows with their square
constexpr qint64 kMostBytes = 64 << 20;

bool readLines(const QString& name, QStringList& out) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kMostBytes) return false;
    out = QString::fromUtf8(file.readAll()).split('\n');
    for (QString& line : out)
        while (!line.isEmpty() && line.back().isSpace()) line.chop(1);
    if (!out.isEmpty() && out.back().isEmpty()) out.removeLast();
    return true;
}

// Myers: v[k] is how far the left text is used on diagonal k = left - right with d edits; each d's v is kept for the way back.
//
//   given   a, b lines; n, m their numbers           wanted  which lines of a and b are paired, the most of them
//   forward for d = 0, 1, ...: from diagonal k-1 one line of a is left out, from k+1 one of b; then all equal lines are run through
//   back    from (n, m), for d down to 0: the run of equal lines, then the step that led to its begin
bool shortest(const QStringList& a, const QStringList& b, const std::atomic<bool>& stop, std::vector<PairedLine>& out) {
    const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
    const int most = std::min(n + m, kMostEdits);
    std::vector<std::vector<int>> ways;
    std::vector<int> v(static_cast<std::size_t>(2 * most + 3), 0);
    const auto at = [most](int k) { return static_cast<std::size_t>(k + most + 1); };
    int found = -1;
    for (int d = 0; d <= most && found < 0; ++d) {
        if (stop) return false;
        ways.emplace_back(v.begin() + (most + 1 - d), v.begin() + (most + 2 + d));   // diagonals -d .. d as they were before step d
        for (int k = -d; k <= d; k += 2) {
            int x = k == -d || (k != d && v[at(k - 1)] < v[at(k + 1)]) ? v[at(k + 1)] : v[at(k - 1)] + 1;
            int y = x - k;
            while (x < n && y < m && a[x] == b[y]) ++x, ++y;
            v[at(k)] = x;
            if (x >= n && y >= m) { found = d; break; }
        }
    }
    if (found < 0) return false;
    std::vector<PairedLine> back;
    int x = n, y = m;
    for (int d = found; d >= 0; --d) {
        const auto& before = ways[static_cast<std::size_t>(d)];
        const auto was = [&](int k) { return before[static_cast<std::size_t>(k + d)]; };
        const int k = x - y;
        int from_x = 0, from_y = 0;
        if (d > 0) {
            const bool down = k == -d || (k != d && was(k - 1) < was(k + 1));
            const int from_k = down ? k + 1 : k - 1;
            from_x = was(from_k), from_y = from_x - from_k;
        }
        while (x > from_x && y > from_y) --x, --y, back.push_back({x, y, true});
        if (d == 0) break;
        if (x == from_x) --y, back.push_back({-1, y, false});
        else --x, back.push_back({x, -1, false});
    }
    out.assign(back.rbegin(), back.rend());
    return true;
}

// Lines that were left out and lines that came in their place stand side by side.
std::vector<PairedLine> sideBySide(const std::vector<PairedLine>& in) {
    std::vector<PairedLine> out;
    for (std::size_t i = 0; i < in.size();) {
        if (in[i].same) { out.push_back(in[i++]); continue; }
        std::vector<int> left, right;
        for (; i < in.size() && !in[i].same; ++i) (in[i].left >= 0 ? left : right).push_back(in[i].left >= 0 ? in[i].left : in[i].right);
        for (std::size_t j = 0; j < std::max(left.size(), right.size()); ++j) out.push_back({j < left.size() ? left[j] : -1, j < right.size() ? right[j] : -1, false});
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
        for (int i = 0; i < std::max(a.size(), b.size()); ++i) middle.push_back({i < a.size() ? i : -1, i < b.size() ? i : -1, i < a.size() && i < b.size() && a[i] == b[i]});
    } else {
        middle = sideBySide(middle);
    }
    for (int i = 0; i < head; ++i) out.lines.push_back({i, i, true});
    for (const PairedLine& one : middle) out.lines.push_back({one.left < 0 ? -1 : one.left + head, one.right < 0 ? -1 : one.right + head, one.same});
    for (int i = 0; i < tail; ++i) out.lines.push_back({n - tail + i, m - tail + i, true});
    for (std::size_t i = 0; i < out.lines.size(); ++i) out.places += !out.lines[i].same && (i == 0 || out.lines[i - 1].same);
    out.left = std::move(left), out.right = std::move(right);
    return out;
}

Difference compareFiles(const QString& left, const QString& right, const std::atomic<bool>& stop) {
    QStringList a, b;
    Difference out;
    if (!readLines(left, a)) return out.fault = QFileInfo(left).fileName(), out;
    if (!readLines(right, b)) return out.fault = QFileInfo(right).fileName(), out;
    return differenceOf(std::move(a), std::move(b), stop);
}

}  // namespace polyturn::hmi
