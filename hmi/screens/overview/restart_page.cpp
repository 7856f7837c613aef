#include "hmi/screens/overview/restart_page.hpp"

#include <QDateTime>
#include <QFileInfo>
#include <QKeyEvent>
#include <QRegularExpression>
#include <cmath>
#include <limits>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/requests/start_words.hpp"

namespace polyturn::hmi {
namespace {

// a power failure in the middle of a part is just when it is wanted
constexpr auto kPlacesSpan = KeptPieces::Span::Lasting;
constexpr qint64 kPlacesMs = 1'000, kPlacesRunningMs = 10'000;
constexpr qint64 kSearchBeginsMs = 2'000;  // who has not begun by then was refused at once

enum Column { kChannel, kProgram, kStood, kTool, kWanted };

QString blockText(std::int64_t block) {
    return block < 0 ? QString::fromUtf8("–") : QString("N%1").arg(block);
}

}  // namespace

RestartPage::RestartPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      table_(new Table(this)),
      note_(new FreeSheet(this)),
      pad_(new NumberPad(this)) {
    table_->columns = {{word("Channel"), 0.8},
                       {word("Program"), 2},
                       {word("Stopped at"), 1.1, kRight, true},
                       {word("Last tool call"), 1.3, kRight, true},
                       {word("Restart at"), 1.1, kRight, true}};
    table_->byCell = true;
    table_->rowUnits = 54;
    table_->textUnits = 18;
    table_->rows = [this] { return static_cast<int>(context_.live.channels().size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const unsigned channel = context_.live.channels()[static_cast<std::size_t>(row)];
        Stood& one = at(channel);
        switch (column) {
            case kChannel:
                return {QString("L%1").arg(channel), t.text, Sign::None, true};
            case kProgram: {
                const auto& programs = context_.live.view(channel).programs;
                return {programs.empty()
                            ? QString()
                            : QFileInfo(QString::fromStdString(programs[0])).fileName(),
                        t.text};
            }
            case kStood:
                return {blockText(one.block), t.text};
            case kTool:
                return {blockText(toolBlock(one)), t.text};
            default:
                return {blockText(one.wanted), one.wanted < 0 ? t.dim : t.accent,
                        one.wanted < 0 ? Sign::None : Sign::Run, true};
        }
    };
    table_->onChosen = [this] { pad_->clear(); };
    // A block that is touched again, or Enter on it: there.
    table_->onActivated = [this] {
        const auto channel = chosen();
        if (!channel) return;
        Stood& one = at(*channel);
        if (table_->column() == kStood)
            one.wanted = one.block;
        else if (table_->column() == kTool)
            one.wanted = toolBlock(one);
        else
            one.wanted = -1;
        refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const auto channel = chosen();
        if (!channel) return std::nullopt;
        return NumberPad::Field{word("L%1: restart at block").arg(*channel),
                                {},
                                at(*channel).wanted < 0 ? std::numeric_limits<double>::quiet_NaN()
                                                        : static_cast<double>(at(*channel).wanted),
                                0,
                                false,
                                1,
                                false};
    };
    pad_->onInput = [this](double value) {
        if (const auto channel = chosen(); channel && value >= 0 && value == std::floor(value))
            at(*channel).wanted = static_cast<std::int64_t>(value);
        refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    note_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, note_->width(), note_->height()), t.window);
        w.fill(QRectF(0, 0, note_->width(), note_->height()), t.card, px(8));
        w.sign(QRectF(px(14), px(14), px(24), px(24)), Sign::Note, t.accent);
        Item& item = w.text(
            QRectF(px(50), px(10), note_->width() - px(62), note_->height() - px(20)),
            word("Bring the axes to a free place first. Touch one of these blocks twice, press "
                 "Enter on it, or type its number: the program restarts there. «Restart» reads "
                 "to it without moving, with all waits replayed. The first start shows what "
                 "comes; the second one does it: tool, functions, axes, and it cuts."),
            lettering(15.5), t.text, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
    };
}

std::optional<unsigned> RestartPage::chosen() const {
    const auto row = static_cast<std::size_t>(table_->row());
    return row < context_.live.channels().size() ? std::optional(context_.live.channels()[row])
                                                 : std::nullopt;
}

// In memory too: another theme or language makes the screens anew.
void RestartPage::keep() {
    if (!back_) return;
    QStringList lines;
    for (unsigned channel = 1; channel <= kMaxChannels; ++channel)
        if (const Stood& one = at(channel); !one.program.empty())
            lines << QString("%1\t%2\t%3\t%4\t%5")
                         .arg(channel)
                         .arg(one.line)
                         .arg(one.block)
                         .arg(one.wanted)
                         .arg(QString::fromStdString(one.program));
    const QByteArray now = lines.join('\n').toUtf8();
    if (now == kept_) return;
    kept_ = now;
    context_.kept.put("restart", now, kPlacesSpan);
}

bool RestartPage::bringBack() {
    if (back_) return true;
    const auto piece = context_.kept.get("restart", kPlacesSpan);
    if (!piece) return false;
    back_ = true;
    kept_ = *piece;
    for (const QString& line : QString::fromUtf8(*piece).split('\n')) {
        const unsigned channel = line.section('\t', 0, 0).toUInt();
        if (channel < 1 || channel > kMaxChannels || line.count('\t') < 4) continue;
        at(channel) = {line.section('\t', 4).toStdString(), line.section('\t', 1, 1).toUInt(),
                       line.section('\t', 2, 2).toLongLong(),
                       line.section('\t', 3, 3).toLongLong()};
    }
    return true;
}

// What has become of the search is told by what the channels are: it is theirs to find the blocks,
// and one that does not takes all back.
void RestartPage::followSearch() {
    if (!searched_) return;
    bool all = true,
         over = QDateTime::currentMSecsSinceEpoch() - searchedAt_ > kSearchBeginsMs && !seen_,
         started = false;
    for (unsigned channel = 1; channel <= kMaxChannels; ++channel) {
        const std::uint32_t bit = 1u << (channel - 1);
        if (!(searched_ & bit)) continue;
        const ChannelStatus& status = context_.live.channel(channel);
        const auto now = static_cast<RestartState>(status.restart);
        const auto state = static_cast<ChannelState>(status.state);
        const bool lacks = (status.start_missing & start_bit("restart")) != 0;
        if (now != RestartState::None) seen_ |= bit;
        all &= now == RestartState::AtBlock && !lacks;
        started |= (seen_ & bit) && now == RestartState::None &&
                   (state == ChannelState::Running || state == ChannelState::Waiting);
        over |= now == RestartState::None && (lacks || (seen_ & bit));
    }
    if (started)
        searched_ = 0;  // its approach: who looks on sees it
    else if (all) {
        searched_ = 0;
        context_.tell(word("All are at their blocks: start makes the approach"), Told::Good);
    } else if (over) {
        searched_ = 0;
        context_.tell(word("The restart was refused, nothing has moved: see the alarms"),
                      Told::Refused);
    }
}

void RestartPage::follow() {
    followSearch();
    if (!bringBack()) return;
    bool runs = false;
    for (const unsigned channel : context_.live.channels()) {
        const ChannelStatus& status = context_.live.channel(channel);
        const ChannelView& view = context_.live.view(channel);
        const auto state = static_cast<ChannelState>(status.state);
        runs |= state == ChannelState::Running || state == ChannelState::Waiting;
        if (view.programs.empty() || status.file != 0 || status.block < 0 || status.line == 0)
            continue;
        if (state == ChannelState::Absent || state == ChannelState::Reset ||
            state == ChannelState::Ended || state == ChannelState::Dead)
            continue;
        Stood& one = at(channel);
        if (one.program != view.programs[0]) one = {view.programs[0], 0, -1, -1};
        one.line = status.line;
        one.block = status.block;
    }
    if (const qint64 now = QDateTime::currentMSecsSinceEpoch(); now >= keepAt_) {
        keepAt_ = now + (runs ? kPlacesRunningMs : kPlacesMs);
        keep();
    }
}

std::optional<std::int64_t> toolCallOf(const QString& line) {
    static const QRegularExpression kText("\"[^\"]*\"?"), kComment("\\([^)]*\\)?|;.*"),
        kCall("^\\s*/?\\d?\\s*N(\\d+)(?:.*[^A-Z_$])?T\\s*[=\\d\"]",
              QRegularExpression::CaseInsensitiveOption);
    if (!line.contains('T', Qt::CaseInsensitive)) return std::nullopt;
    QString bare = line;
    bare.replace(kText, "\"").remove(kComment);
    const auto found = kCall.match(bare);
    return found.hasMatch() ? std::optional<std::int64_t>(found.captured(1).toLongLong())
                            : std::nullopt;
}

// Asked with each frame, in programs of many thousand lines: only what has not been looked at is.
std::int64_t RestartPage::toolBlock(Stood& stood) {
    if (stood.program.empty()) return -1;
    auto& known = stood.tool;
    const int count = texts_.count(stood.program);
    std::uint32_t first = 1;
    if (count == known.count && stood.line >= known.line) {
        if (stood.line <= known.from) return known.block;
        first = known.from + 1;
    } else {
        known = {};
    }
    for (std::uint32_t line = stood.line; line >= first; --line)
        if (const auto block = toolCallOf(texts_.line(stood.program, line))) {
            known.block = *block;
            known.line = line;
            break;
        }
    known.from = stood.line;
    known.count = count;
    return known.block;
}

void RestartPage::restart() {
    QStringList words;
    for (const unsigned channel : context_.live.channels())
        if (at(channel).wanted >= 0)
            words << QString("L%1=N%2").arg(channel).arg(at(channel).wanted);
    if (words.isEmpty()) return;
    context_.requests.press("restart " + words.join(' '), [this](const Answer& answer) {
        if (answer.ok) context_.tell(word("The blocks are searched: nothing moves"), Told::Note);
    });
    searched_ = seen_ = 0;
    for (const unsigned channel : context_.live.channels())
        if (at(channel).wanted >= 0) searched_ |= 1u << (channel - 1);
    searchedAt_ = QDateTime::currentMSecsSinceEpoch();
}

void RestartPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), right = px(340), foot = px(130), pad = px(380);
    const Parted all = parted(*this, rect().adjusted(edge, 0, -edge, -edge), right, pad, edge);
    const bool stacked = upright(*this);
    table_->setGeometry(all.main.adjusted(0, 0, 0, stacked ? 0 : -foot - edge));
    note_->setGeometry(edge, stacked ? all.side.top() : height() - foot - edge,
                       (stacked ? all.side.width() - right - edge : all.main.width()),
                       stacked ? pad : foot);
    pad_->setGeometry(all.side.right() + 1 - right, all.side.top(), right, pad);
}

void RestartPage::refresh() {
    for (Sheet* one : sheets()) one->refresh();
}

bool RestartPage::key(QKeyEvent* event) { return pad_->key(event) || table_->key(event); }

void RestartPage::addKeys(std::vector<SoftKey>& keys) {
    bool any = false;
    QStringList blocks;
    for (const unsigned channel : context_.live.channels()) {
        any |= at(channel).wanted >= 0;
        if (at(channel).wanted >= 0)
            blocks << QString("L%1 N%2").arg(channel).arg(at(channel).wanted);
    }
    keys.push_back({word("All from their last tool call"),
                    [this] {
                        bool found = false;
                        for (const unsigned channel : context_.live.channels()) {
                            at(channel).wanted = toolBlock(at(channel));
                            found |= at(channel).wanted >= 0;
                        }
                        if (!found)
                            context_.tell(word("No tool has been called where the programs "
                                               "stopped: touch a block, or type its number"),
                                          Told::Refused);
                        refresh();
                    },
                    Sign::Tools, !context_.live.channels().empty()});
    keys.push_back({word("Restart"),
                    [this] { restart(); },
                    Sign::Run,
                    any && context_.live.connected(),
                    false,
                    false,
                    word("The axes are free: press again"),
                    {},
                    blocks.join(' '),
                    blocks.join(' ')});
}

}  // namespace polyturn::hmi
