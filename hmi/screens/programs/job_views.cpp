// The synchronised view and the timeline of a job (see Programs).
#include <QDateTime>
#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/programs/critical_path.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/pictures/time_shape.hpp"
#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kAlignEveryMs = 250;  // while the run goes on

// The channel that another one has waited for longest at a rendezvous: the one that came last; 0:
// there was no other.
unsigned lastToCome(const std::map<unsigned, RunChannel>& channels, unsigned waiting,
                    const RunWait& meeting) {
    constexpr double kSame_s = 0.02;  // partners of a rendezvous go on within some ticks
    unsigned out = 0;
    double latest = meeting.from;
    for (const auto& [number, channel] : channels)
        for (const RunWait& wait : channel.waits)
            if (number != waiting && wait.code == meeting.code &&
                std::abs(wait.to - meeting.to) < kSame_s && wait.from > latest) {
                latest = wait.from;
                out = number;
            }
    return out;
}

struct TimeLook {
    TimeShape shape;
    QColor colour;
};
TimeLook spanLook(RunSpan::Kind kind) {
    const Theme& t = theme();
    return kind == RunSpan::Kind::Cutting ? TimeLook{TimeShape::Full, t.good}
           : kind == RunSpan::Kind::Rapid ? TimeLook{TimeShape::Half, t.accent}
                                          : TimeLook{TimeShape::Hatched, t.warn};
}

}  // namespace

// Anew when the run has reported more; of a long program not with each frame.
void Programs::alignJob() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (alignedVersion_ == dry_.version() || (dry_.running() && now < alignAt_)) return;
    alignedVersion_ = dry_.version();
    alignAt_ = now + kAlignEveryMs;
    aligned_.build(dry_.channels());
}

// As the program of the run writes it.
QString Programs::waitName(unsigned channel, int code) const {
    return fromView(wait_name(dry_.language(channel, context_.live.panelLanguage(channel)), code));
}

void Programs::composeTogether(Writer& w) {
    const Theme& t = theme();
    const double wide = view_->width(), high = view_->height(), foot = px(92);
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high - foot - px(6)), t.card, px(8));
    w.fill(QRectF(0, high - foot, wide, foot), t.card, px(8));
    composeFaults(w, QRectF(0, high - foot + px(6), wide, foot - px(8)));
    const auto& channels = dry_.channels();
    if (channels.empty()) return;
    const double each = wide / static_cast<double>(channels.size()), head = px(34),
                 row = px(kTogetherRow);
    // eight channels: smaller letters, so that a block can be read
    const bool narrow = each < px(220);
    const double text = px(narrow ? 36 : 56);
    std::map<unsigned, double> left;
    double x = 0;
    for (const auto& [number, channel] : channels) {
        left[number] = x;
        w.text(QRectF(x + px(14), 0, px(70), head), QString("L%1").arg(number), lettering(18, true),
               t.accent);
        if (!channel.blocks.empty())
            w.data(QRectF(x + px(narrow ? 48 : 84), 0, each - px(narrow ? 54 : 98), head),
                   QFileInfo(QString::fromStdString(channel.blocks.front().file)).fileName(),
                   lettering(narrow ? 12 : 14), t.dim, kRight);
        if (x > 0) w.line(QPointF(x, px(6)), QPointF(x, high - foot - px(14)), t.edge, 1);
        x += each;
    }
    alignJob();
    const auto& rows = aligned_.rows();
    const int visible = static_cast<int>((high - foot - head - px(12)) / row);
    scroll_ = std::clamp(scroll_, 0, std::max(0, static_cast<int>(rows.size()) - visible));
    // that there is more, and where this is
    if (const int all = static_cast<int>(rows.size()); all > visible) {
        const double room = visible * row, part = std::max<double>(px(24), room * visible / all);
        w.fill(QRectF(wide - px(7), head + (room - part) * scroll_ / (all - visible), px(5), part),
               t.edge, px(2));
    }
    // an error rather than a warning; nullptr: neither
    const auto faultAt = [&](const RunLine& line) {
        const RunFault* found = nullptr;
        for (const RunFault& fault : dry_.faults())
            if (fault.at.line == line.line && fault.at.file == line.file && (!found || fault.error))
                found = &fault;
        return found;
    };
    // in which file the line above stands: where another one begins, its name is beside
    std::map<unsigned, std::string> stands;
    for (int i = 0; i < visible && scroll_ + i < static_cast<int>(rows.size()); ++i) {
        const AlignedJob::Row& one = rows[static_cast<std::size_t>(scroll_ + i)];
        const double y = head + i * row;
        if (const RunWait* wait = aligned_.wait(channels, one)) {
            std::vector<unsigned> here;
            for (const auto& [number, channel] : channels)
                if (one.comes(number)) here.push_back(number);
            const bool all = here.size() == wait->channels.size();
            const QColor colour = all ? t.wait : t.bad;
            double from = wide, to = 0;
            for (const unsigned number : here) {
                from = std::min(from, left[number]);
                to = std::max(to, left[number] + each);
            }
            // The bridge: a line from the first to the last, a pier in each column that takes part;
            // it passes over the others.
            w.fill(QRectF(from + px(12), y + row / 2 - px(1.5), to - from - px(24), px(3)), colour);
            for (const unsigned number : here) {
                w.fill(QRectF(left[number] + px(8), y + px(2), each - px(16), row - px(4)), t.mark,
                       px(9));
                w.frame(QRectF(left[number] + px(8), y + px(2), each - px(16), row - px(4)), colour,
                        px(9), px(1.5));
            }
            QStringList missing;
            for (const unsigned number : wait->channels)
                if (!one.comes(number)) missing << QString("L%1").arg(number);
            // In each channel's own column, so that no sign lies between columns where a word
            // stands.
            for (const unsigned number : here) {
                w.sign(QRectF(left[number] + text, y + px(5), px(14), px(14)),
                       all ? Sign::Wait : Sign::Alarm, colour);
                const QString absent = all || number != here.front()
                                           ? QString()
                                           : "   " + word("never comes: %1").arg(missing.join(' '));
                w.text(QRectF(left[number] + text + px(narrow ? 18 : 22), y,
                              each - text - px(narrow ? 28 : 34), row),
                       waitName(number, wait->code) + absent, lettering(narrow ? 13 : 14.5, true),
                       colour);
            }
            continue;
        }
        for (const auto& [number, channel] : channels) {
            const RunLine* has = aligned_.line(channels, one, number);
            if (!has) continue;
            const RunLine& line = *has;
            const RunFault* fault = faultAt(line);
            const bool bad = fault != nullptr;
            const QColor colour = !bad ? t.text : fault->error ? t.bad : t.warn;
            const double at = left[number];
            std::string& above =
                stands.try_emplace(number, channel.blocks.front().file).first->second;
            const bool enters = !narrow && !bad && above != line.file;
            above = line.file;
            if (enters)
                w.data(QRectF(at + each - px(110), y, px(100), row),
                       QFileInfo(QString::fromStdString(line.file)).fileName(),
                       lettering(12, false, Face::Condensed), t.accent, kRight);
            if (bad) {
                w.fill(QRectF(at + px(4), y + 1, each - px(8), row - 2), t.raised, px(4));
                w.sign(QRectF(at + each - px(26), y + px(4), px(16), px(16)),
                       fault->error ? Sign::Alarm : Sign::Warning, colour);
            }
            w.text(QRectF(at + px(2), y, text - px(narrow ? 5 : 10), row),
                   QString::number(line.line),
                   lettering(narrow ? 11 : 12, false, narrow ? Face::Condensed : Face::Text),
                   t.faint, kRight);
            w.data(QRectF(at + text, y,
                          each - text -
                              px(enters   ? 114
                                 : bad    ? 32
                                 : narrow ? 4
                                          : 10),
                          row),
                   texts_.line(line.file, line.line),
                   lettering(narrow ? 11.5 : 13.5, bad, Face::Program), colour);
        }
    }
}

void Programs::composeTime(Writer& w) {
    const Theme& t = theme();
    const double wide = view_->width(), high = view_->height(), foot = px(150);
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high - foot - px(6)), t.card, px(8));
    w.fill(QRectF(0, high - foot, wide, foot), t.card, px(8));
    composeFaults(w, QRectF(0, high - px(84), wide, px(80)));
    const double end = dry_.end();
    const auto& channels = dry_.channels();
    if (channels.empty() || end <= 0) return;
    // The meanings of the lines stand beside the whole time, in as many rows as a narrow panel
    // needs.
    const double left = px(74), right = wide - px(200), meaning = px(150);
    const int across = std::max(1, static_cast<int>((right - left) / meaning)), meanings = 5;
    const double top = px(54) + px(26) * ((meanings - 1) / across),
                 each = std::min<double>(
                     px(130), (high - foot - top - px(50)) / static_cast<double>(channels.size()));
    const auto at = [&](double seconds) { return left + (right - left) * seconds / end; };
    // what the lines mean
    const TimeLook waits{TimeShape::Hollow, t.wait};
    const std::pair<const char*, TimeLook> keys[] = {
        {WORD("Cutting"), spanLook(RunSpan::Kind::Cutting)},
        {WORD("Rapid"), spanLook(RunSpan::Kind::Rapid)},
        {WORD("Dwell"), spanLook(RunSpan::Kind::Dwell)},
        {WORD("Waiting"), waits}};
    int count = 0;
    const auto named = [&](const char* text, const auto& draw) {
        const double x = left + meaning * (count % across), y = px(10) + px(26) * (count / across);
        draw(QRectF(x, y + px(5), px(26), px(18)));
        w.text(QRectF(x + px(34), y, meaning - px(38), px(28)), word(text), lettering(14), t.dim);
        ++count;
    };
    for (const auto& [text, look] : keys)
        named(text,
              [&](const QRectF& sample) { drawTimeShape(w, look.shape, sample, look.colour); });
    named(WORD("Decides the time"), [&](const QRectF& sample) {
        w.fill(QRectF(sample.left(), sample.top() + px(7), sample.width(), px(4)), t.text);
    });
    w.text(QRectF(right + px(10), px(8), px(182), px(30)), word("%1 in all").arg(timeText(end)),
           lettering(17, true), t.text, kRight);
    double y = top, longest = 0;
    unsigned longestChannel = 0;
    const RunWait* worst = nullptr;
    // The critical path: a line above the bars, from channel to channel at the rendezvous.
    const std::vector<RunStretch> path = criticalPath(channels);
    std::map<unsigned, double> above, decides;
    for (const auto& [number, channel] : channels)
        above[number] = top + each * static_cast<double>(above.size()) - px(9);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double line = above[path[i].channel];
        decides[path[i].channel] += path[i].to - path[i].from;
        w.fill(
            QRectF(at(path[i].from), line, std::max(1.0, at(path[i].to) - at(path[i].from)), px(4)),
            t.text);
        if (i)
            w.line({at(path[i].from), std::min(line, above[path[i - 1].channel])},
                   {at(path[i].from), std::max(line, above[path[i - 1].channel]) + px(4)}, t.text,
                   px(1.6));
    }
    for (const auto& [number, channel] : channels) {
        const double bar = each * 0.46;
        w.text(QRectF(px(14), y, px(56), bar), QString("L%1").arg(number), lettering(20, true),
               t.text);
        w.fill(QRectF(left, y, right - left, bar), t.raised, px(3));
        double cutting = 0, rapid = 0, dwelling = 0, waiting = 0;
        // Spans narrower than a pixel are drawn together with their neighbours.
        RunSpan joined{};
        bool any = false;
        const auto flush = [&] {
            if (!any) return;
            const TimeLook look = spanLook(joined.kind);
            drawTimeShape(
                w, look.shape,
                QRectF(at(joined.from), y, std::max(1.0, at(joined.to) - at(joined.from)), bar),
                look.colour);
        };
        for (const RunSpan& span : channel.spans) {
            (span.kind == RunSpan::Kind::Cutting ? cutting
             : span.kind == RunSpan::Kind::Rapid ? rapid
                                                 : dwelling) += span.to - span.from;
            if (any && span.kind == joined.kind && at(span.from) - at(joined.to) < 1.0) {
                joined.to = span.to;
                continue;
            }
            flush();
            joined = span;
            any = true;
        }
        flush();
        for (const RunWait& wait : channel.waits) {
            const double lasts = wait.to - wait.from;
            waiting += std::max(0.0, lasts);
            drawTimeShape(w, waits.shape,
                          QRectF(at(wait.from), y, std::max(1.5, at(wait.to) - at(wait.from)), bar),
                          waits.colour);
            w.line({at(wait.to), y - px(4)}, {at(wait.to), y + bar + px(4)}, t.wait, 1);
            if (lasts > longest) {
                longest = lasts;
                longestChannel = number;
                worst = &wait;
            }
            if (at(wait.to) - at(wait.from) > px(44))
                w.text(QRectF(at(wait.from), y + bar + px(2), at(wait.to) - at(wait.from), px(18)),
                       waitName(number, wait.code), lettering(12.5), t.wait, Qt::AlignCenter);
        }
        // What it spends its time with; the rest are tool changes, M codes and what it does not run
        // any more.
        struct Share {
            const char* text;
            double seconds;
            QColor colour;
        };
        const Share shares[] = {{WORD("Cutting"), cutting, t.good},
                                {WORD("Rapid"), rapid, t.accent},
                                {WORD("Dwell"), dwelling, t.warn},
                                {WORD("Waiting"), waiting, t.wait},
                                {WORD("Other"), end - cutting - rapid - dwelling - waiting, t.dim}};
        const double pitch = std::min<double>(px(19), each / 5);
        double line = y - px(6);
        for (const Share& share : shares) {
            const long percent = std::lround(100 * share.seconds / end);
            if (percent <= 0) continue;
            w.text(QRectF(right + px(10), line, px(182), pitch + px(1)),
                   QString("%1  %2 %").arg(word(share.text)).arg(percent),
                   lettering(pitch < px(17) ? 11.5 : 13.5), share.colour, kRight);
            line += pitch;
        }
        y += each;
    }
    // seconds
    const double axis = high - foot - px(40);
    double step = 1;
    for (const double one :
         {1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0})
        if (end / one > 12) step = one * 2;
    w.line({left, axis}, {right, axis}, t.edge, 1);
    for (double s = 0; s <= end; s += step) {
        w.line({at(s), axis}, {at(s), axis + px(5)}, t.edge, 1);
        w.text(QRectF(at(s) - px(32), axis + px(7), px(64), px(18)), timeText(s), lettering(12),
               t.dim, Qt::AlignCenter);
    }
    if (decides.empty()) return;
    const auto most =
        std::max_element(decides.begin(), decides.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    QString note = word("L%1 decides %2 of %3: what becomes shorter there shortens the cycle.")
                       .arg(most->first)
                       .arg(timeText(most->second), timeText(end));
    if (worst && longest > 0.5) {
        note += " " + word("Longest wait: L%1 stands %2 s at %3 (line %4).")
                          .arg(longestChannel)
                          .arg(longest, 0, 'f', 1)
                          .arg(waitName(longestChannel, worst->code))
                          .arg(worst->at.line);
        // What is moved shortens one and lengthens the other: at best both arrive in the middle.
        if (const unsigned last = lastToCome(channels, longestChannel, *worst))
            note += " " + word("Work moved from L%1 to L%2 saves up to %3 s.")
                              .arg(last)
                              .arg(longestChannel)
                              .arg(longest / 2, 0, 'f', 1);
    }
    w.sign(QRectF(px(14), high - foot + px(14), px(24), px(24)), Sign::Note, t.accent);
    Item& item = w.text(QRectF(px(50), high - foot + px(16), wide - px(64), px(48)), note,
                        lettering(15), t.text, Qt::AlignLeft | Qt::AlignTop);
    item.wraps = true;
}

}  // namespace polyturn::hmi
