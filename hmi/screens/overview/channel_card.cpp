#include "hmi/screens/overview/channel_card.hpp"

#include <QFileInfo>
#include <cmath>

#include "hmi/machine/live/axis_places.hpp"
#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_in_work.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {
namespace {

const QString kDash = QString::fromUtf8("–");

// Writes the parts of a card one below the other.
class Card {
public:
    Card(Writer& w, QSizeF size, const Context& context, unsigned channel, ProgramText& programs,
         const QString& hint, bool turned)
        : w_(w),
          t_(theme()),
          live_(context.live),
          alarms_(context.alarms),
          channel_(channel),
          status_(live_.channel(channel)),
          view_(live_.view(channel)),
          config_(live_.config().channel(channel)),
          programs_(programs),
          size_(size),
          chosen_(context.channel),
          focus_(context.channel == channel && live_.channels().size() > 1),
          hint_(focus_ ? hint : QString()),
          turned_(turned) {
        dense_ = size.height() < px(560);
        spare_ = dense_ && size.height() >= px(400);
        left_ = px(dense_ ? 12 : 16);
        wide_ = size.width() - 2 * left_;
        y_ = px(dense_ ? 6 : 9);
    }

    void write() {
        w_.fill(QRectF(QPointF(0, 0), size_), t_.window);
        const QRectF all = QRectF(QPointF(0, 0), size_).adjusted(px(4), px(4), -px(4), -px(2));
        w_.fill(all, t_.card, px(10));
        w_.frame(all, focus_ ? t_.accent : t_.edge, px(10), focus_ ? px(2) : 1);
        w_.hit(all, static_cast<int>(channel_));
        if (size_.height() < px(250)) return small();
        header();
        strip();
        axes();
        speeds();
        tool();
        program();
        parts();
    }

private:
    // More than eight channels: each part of a whole card on one line, in its order; a second touch
    // gives room for the rest.
    void small() {
        left_ = px(11);
        wide_ = size_.width() - 2 * left_;
        y_ = px(7);
        const double foot = px(19), codes = px(15), bottom = size_.height() - px(4) - foot;
        smallHeader();
        smallStrip();
        // Axes go before the codes, and before the running block, where a card has no room for all:
        // the large card beside it has them.
        const double least = kSmallHead() + kLeastRow() * static_cast<double>(std::min<std::size_t>(
                                                              config_.axis_count, 2));
        const bool block = bottom - y_ - kSmallBlock() >= least;
        if (block) smallBlock();
        const bool coded = bottom - y_ - codes >= least;
        const double end = bottom - (coded ? codes : 0.0);
        smallAxes(end);
        const QString path = programPath();
        if (block && status_.line && end - y_ >= px(17))
            for (std::uint32_t number = status_.line + 1;
                 y_ + px(16) <= end && number <= status_.line + 3; ++number, y_ += px(16))
                w_.data(QRectF(left_ + px(18), y_, wide_ - px(18), px(16)),
                        programs_.line(path.toStdString(), number),
                        lettering(11.5, false, Face::Program), t_.dim);
        if (coded)
            w_.data(QRectF(left_, bottom - codes, wide_, codes), activeCodes(),
                    lettering(12, false, Face::Condensed), t_.dim);
        smallFoot(QRectF(left_, bottom, wide_, foot));
    }

    static double kSmallHead() { return px(13); }
    static double kLeastRow() { return px(11); }
    static double kSmallBlock() { return px(20); }

    void smallHeader() {
        const double h = px(21);
        const StateWords state = stateWords(status_);
        w_.sign(QRectF(left_, y_ + px(2), px(17), px(17)), state.sign, colourOf(state.tone));
        w_.text(QRectF(left_ + px(23), y_, px(34), h), QString("L%1").arg(channel_),
                lettering(16, true), t_.text);
        const double from =
            left_ + px(57) + groupMark(QRectF(left_ + px(57), y_ + px(2), 0, h - px(4)));
        const QFont bold = lettering(14, true, Face::Condensed);
        const double most = left_ + wide_ - from,
                     wide = std::min(wordsWidth(state.text, bold) + px(4), most * 0.7);
        w_.data(QRectF(left_ + wide_ - wide, y_, wide, h), state.text, bold, colourOf(state.tone),
                kRight);
        w_.data(QRectF(from, y_, most - wide - px(6), h), modeWord(status_.mode),
                lettering(12.5, false, Face::Condensed), t_.dim);
        y_ += h + px(1);
    }

    void smallStrip() {
        const QRectF box(left_, y_, wide_, px(19));
        const Plight now = plight(live_, alarms_, channel_);
        const bool trouble = now.kind != Plight::Kind::None;
        const auto [sign, colour] = plightSign(now.kind);
        w_.fill(box, t_.raised, px(5));
        const double marks = switchMarks(box, now.kind == Plight::Kind::Alarm);
        if (trouble) w_.sign(QRectF(left_ + px(5), y_ + px(2), px(15), px(15)), sign, colour);
        const QString file = QFileInfo(programPath()).fileName();
        w_.data(QRectF(left_ + px(trouble ? 25 : 8), y_, wide_ - px(trouble ? 29 : 12) - marks,
                       box.height()),
                trouble          ? now.text
                : file.isEmpty() ? word("no program")
                                 : file,
                lettering(13, false, Face::Condensed),
                file.isEmpty() && !trouble ? t_.faint : t_.text);
        y_ += box.height() + px(2);
    }

    // The running block; beside trouble, which has the place of the program's name, that too.
    // Nothing runs: where the program begins.
    void smallBlock() {
        const QRectF box(left_, y_, wide_, px(18));
        const QString path = programPath(), file = QFileInfo(path).fileName();
        const bool runs = status_.line != 0;
        if (runs) {
            w_.fill(box, t_.mark, px(4));
            w_.sign(QRectF(left_ + px(3), y_ + px(3), px(12), px(12)), Sign::Run, t_.accent);
        }
        const bool named =
            plight(live_, alarms_, channel_).kind != Plight::Kind::None && !file.isEmpty();
        const QFont small = lettering(11.5, false, Face::Condensed);
        const double name = named ? std::min(wordsWidth(file, small) + px(8), wide_ * 0.34) : 0;
        if (named)
            w_.data(QRectF(box.right() - name, y_, name - px(4), box.height()), file, small, t_.dim,
                    kRight);
        w_.data(QRectF(left_ + px(18), y_, wide_ - px(20) - name, box.height()),
                programs_.line(path.toStdString(), runs ? status_.line : 1u),
                lettering(11.5, runs, Face::Program), runs ? t_.text : t_.faint);
        y_ += box.height() + px(2);
    }

    // What an axis shows, in the order of a whole card. Where four columns have no room, two of
    // them, and by a touch the two others.
    void smallAxes(double end) {
        enum Column { kWorkpiece, kMachine, kToGo, kLag };
        const bool whole = wide_ >= px(262);
        const std::vector<Column> columns =
            whole     ? std::vector<Column>{kWorkpiece, kMachine, kToGo, kLag}
            : turned_ ? std::vector<Column>{kMachine, kLag}
                      : std::vector<Column>{kWorkpiece, kToGo};
        const double name = px(22), head = kSmallHead(), top = y_;
        const auto most = static_cast<std::size_t>(std::max(0.0, (end - y_ - head) / kLeastRow()));
        const std::size_t count = std::min<std::size_t>(config_.axis_count, most);
        if (!count) return;
        const double row = std::min<double>(px(18), (end - y_ - head) / static_cast<double>(count));
        const double size = row >= px(18)   ? 14.5
                            : row >= px(15) ? 13
                                            : 11.5,
                     first = (wide_ - name) * (whole ? 0.28 : 0.54),
                     other = (wide_ - name - first) / static_cast<double>(columns.size() - 1);
        const auto box = [&](std::size_t column, double y, double high) {
            return column == 0
                       ? QRectF(left_ + name, y, first, high)
                       : QRectF(left_ + name + first + other * static_cast<double>(column - 1), y,
                                other, high);
        };
        if (!whole)
            w_.sign(QRectF(left_, y_, px(11), head), turned_ ? Sign::Left : Sign::Right, t_.accent);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            constexpr const char* kHeads[] = {WORD("Workpiece"), WORD("Machine"), WORD("To go"),
                                              WORD("Lag")};
            w_.text(box(c, y_, head), word(kHeads[columns[c]]),
                    lettering(10.5, false, Face::Condensed), t_.dim, kRight);
        }
        y_ += head;
        for (std::size_t place = 0; place < count; ++place, y_ += row) {
            const AxisPlaces axis(live_, channel_, place);
            w_.text(QRectF(left_, y_, name, row), axis.name(), lettering(size, true),
                    axis.moves ? t_.good : t_.text);
            for (std::size_t c = 0; c < columns.size(); ++c) {
                QString text = kDash;
                QColor colour = c == 0 ? t_.text : t_.dim;
                if (axis.turns)
                    colour = t_.faint;
                else
                    switch (columns[c]) {
                        case kWorkpiece:
                            text = axis.known() || axis.referenced || whole ? axis.workpiece()
                                                                            : axis.machineOrNone();
                            if (!axis.known() && !axis.referenced) colour = t_.warn;
                            break;
                        case kMachine:
                            text = axis.machineOrNone();
                            if (!axis.referenced) colour = t_.warn;
                            break;
                        case kToGo:
                            text = axis.goes ? axis.toGo() : QString();
                            break;
                        case kLag:
                            text = axis.lag();
                            break;
                    }
                w_.text(box(c, y_, row), text,
                        lettering(c == 0 ? size : size - 1.5, c == 0,
                                  whole ? Face::Condensed : Face::Text),
                        colour, kRight);
            }
        }
        if (!whole) w_.hit(QRectF(left_, top, wide_, end - top), kTurnAxesHit);
    }

    // Tool and offset; feed and spindle, each with its override where that is another one than 100
    // %.
    void smallFoot(const QRectF& box) {
        const BlockPicture& p = view_.picture;
        w_.line({box.left(), box.top()}, {box.right(), box.top()}, t_.edge, 1);
        const ToolAtWork inWork = toolAtWork(live_, channel_);
        QString tool = toolAtWorkText(inWork, false);
        if (tool.isEmpty()) tool = kDash;
        if (p.edge > 0 || p.geometry > 0)
            tool += p.edge > 0 ? QString("  D%1").arg(p.edge)
                               : QString("  %1 %2").arg(word("Offset")).arg(p.geometry);
        const auto with = [](const QString& text, double override) {
            return std::abs(override - 1.0) > 1e-6
                       ? QString("%1  %2 %").arg(text).arg(std::lround(override * 100))
                       : text;
        };
        const double third = box.width() / 3;
        const QFont font = lettering(13, false, Face::Condensed);
        w_.data(QRectF(box.left(), box.top(), third + px(16), box.height()), tool,
                lettering(13, true, Face::Condensed),
                view_.known || inWork.certain ? t_.text : t_.faint);
        w_.text(
            QRectF(box.left() + third + px(16), box.top(), third - px(12), box.height()),
            with("F " + live_.unit(channel_).speed(status_.path_speed * 60), status_.feed_override),
            font, status_.feed_override != 1 ? t_.warn : t_.dim, kRight);
        const unsigned spindle = view_.known && p.spindle ? p.spindle : config_.default_spindle;
        if (spindle < 1 || spindle > kMaxSpindles) return;
        const SpindleStatus& turns = live_.status().spindles[spindle - 1];
        w_.text(QRectF(box.left() + 2 * third + px(4), box.top(), third - px(4), box.height()),
                with(QString("S %1").arg(std::abs(turns.speed), 0, 'f', 0), turns.override), font,
                std::abs(turns.override - 1.0) > 1e-6 ? t_.warn : t_.dim, kRight);
    }

    QString programPath() const {
        return view_.file < view_.programs.size()
                   ? QString::fromStdString(view_.programs[view_.file])
                   : QString();
    }

    std::pair<Sign, QColor> plightSign(Plight::Kind kind) const {
        switch (kind) {
            case Plight::Kind::Alarm:
                return {Sign::Alarm, t_.bad};
            case Plight::Kind::Waits:
                return {Sign::Wait, t_.wait};
            case Plight::Kind::Needs:
                return {Sign::Warning, t_.warn};
            case Plight::Kind::Stands:
                return {Sign::Hold, t_.warn};
            case Plight::Kind::Told:
                return {Sign::Note, t_.accent};
            case Plight::Kind::None:
                break;
        }
        return {Sign::None, t_.dim};
    }

    // Which machine group the channel belongs to, where there are several: those of the chosen
    // one's group have a filled mark. Begins at the box' left edge; how much of the width it takes.
    double groupMark(const QRectF& box) {
        const unsigned group = groupOf(live_, channel_);
        if (!group) return 0;
        const bool same = group == groupOf(live_, chosen_);
        const QString text = word("Group %1").arg(group);
        const QFont font = lettering(12.5, same, Face::Condensed);
        const QRectF mark(box.left(), box.top(), wordsWidth(text, font) + px(12), box.height());
        if (same) w_.fill(mark, t_.mark, px(5));
        w_.frame(mark, same ? t_.accent : t_.edge, px(5), 1);
        w_.text(mark, text, font, same ? t_.text : t_.dim, Qt::AlignCenter);
        return mark.width() + px(6);
    }

    // Beside what matters most: the switches of the channel, as status lines name them; beside an
    // alarm in a small card only those by which the machine does something else than the program
    // says. How much of the width they take.
    double switchMarks(const QRectF& box, bool fewest = false) {
        QStringList marks;
        const auto add = [&](std::uint32_t bits, const char* mark) {
            if (status_.keys & bits) marks << mark;
        };
        add(kKeyMachineLock, "MLK");
        add(kKeyDryRun, "DRY");
        add(kKeyRetrace, "RTR");
        add(kKeyIgnoreWaits, "NWT");
        if (!fewest) {
            add(kKeySingleBlock, "SBL");
            add(kKeyOptionalStop, "M01");
            add(kAllBlockSkips, "SKP");
            add(kKeyFirstPart, "FPT");
        }
        if (marks.isEmpty()) return 0;
        while (marks.size() > 4) marks.removeLast();
        const double wide = marks.size() > 2 && box.height() > px(30)
                                ? px(70)
                                : px(36) * static_cast<double>(marks.size());
        const QString text = marks.size() > 2 && box.height() > px(30)
                                 ? marks.mid(0, 2).join(' ') + "\n" + marks.mid(2).join(' ')
                                 : marks.join(' ');
        Item& item = w_.text(QRectF(box.right() - wide - px(4), box.top(), wide, box.height()),
                             text, lettering(12, true, Face::Condensed), t_.warn,
                             Qt::AlignRight | Qt::AlignVCenter);
        item.data = true;
        return wide + px(6);
    }

    bool slim() const { return !dense_ && wide_ < px(320); }  // a whole card among four
    double gap() const { return px(dense_ ? 4 : 9); }
    void below(double height) { y_ += height + gap(); }
    void rule() { w_.line({left_, y_ - gap() / 2}, {left_ + wide_, y_ - gap() / 2}, t_.edge, 1); }

    void header() {
        const double h = px(dense_ ? 26 : 34);
        const StateWords state = stateWords(status_);
        w_.sign(QRectF(left_, y_ + (h - px(22)) / 2, px(22), px(22)), state.sign,
                colourOf(state.tone));
        // What it does is never shortened; then the mode, the group, and of the name what there is
        // room for.
        const QString name = wide_ < px(320) || groupOf(live_, channel_)
                                 ? QString("L%1").arg(channel_)
                                 : channelTitle(live_, channel_),
                      mode = modeWord(status_.mode);
        const QFont bold = lettering(dense_ ? 17 : 21, true);
        const double from = left_ + px(30), all = wide_ - px(30), between = px(8);
        const double least =
            wordsWidth(QString("L%1").arg(channel_), bold) +
            (groupOf(live_, channel_)
                 ? wordsWidth(word("Group %1").arg(99), lettering(12.5, true, Face::Condensed)) +
                       px(20)
                 : 0);
        QFont stateFont = lettering(dense_ ? 15 : 18, true), modeFont = lettering(14.5);
        const auto needed = [&] {
            return wordsWidth(state.text, stateFont) + wordsWidth(mode, modeFont) + 2 * between;
        };
        for (double units = dense_ ? 15 : 17; needed() + least > all && units > 10; units -= 1) {
            stateFont = lettering(units, true, Face::Condensed);
            modeFont = lettering(std::min(units, 13.5), false, Face::Condensed);
        }
        const double stateWide = wordsWidth(state.text, stateFont) + 1,
                     modeWide = wordsWidth(mode, modeFont) + 1,
                     titleWide =
                         std::min(wordsWidth(name, bold) + 1,
                                  std::max(all - needed(),
                                           wordsWidth(QString("L%1").arg(channel_), bold) + 1));
        w_.data(QRectF(from, y_, titleWide, h), name, bold, t_.text);
        w_.text(QRectF(left_ + wide_ - modeWide, y_, modeWide, h), mode, modeFont, t_.dim, kRight);
        w_.text(QRectF(left_ + wide_ - modeWide - between - stateWide, y_, stateWide, h),
                state.text, stateFont, colourOf(state.tone), kRight);
        groupMark(QRectF(from + titleWide + px(4), y_ + px(4), 0, h - px(8)));
        below(h);
    }

    void strip() {
        // three and more side by side: a cause needs three lines
        const double h = px(dense_ ? 36 : wide_ < px(420) ? 60 : 42);
        const QRectF box(left_, y_, wide_, h);
        const Plight now = plight(live_, alarms_, channel_);
        const auto [sign, colour] = plightSign(now.kind);
        w_.fill(box, t_.raised, px(6));
        if (now.kind != Plight::Kind::None) {
            w_.fill(QRectF(box.left(), box.top(), px(4), h), colour, px(2));
            w_.sign(QRectF(box.left() + px(12), box.center().y() - px(10), px(20), px(20)), sign,
                    colour);
            const double marks = switchMarks(box);
            const QRectF room = box.adjusted(px(40), px(1), -px(6) - marks, -px(1));
            QFont font = lettering(13.5);
            if (!wordsFit(now.text, font, room.size()))
                font = letteringThatFits(now.text, room.size(), 13.5, 11.5, Face::Condensed);
            // its beginning goes before its end
            Item& item = w_.text(room, wordsCutTo(now.text, font, room.size()), font, t_.text);
            item.wraps = true;
            item.data = true;
        } else {
            QString switches;
            const auto add = [&](bool on, const QString& text) {
                if (on) switches += (switches.isEmpty() ? "" : "   ") + text;
            };
            add(status_.keys & kKeyRetrace, word("Start goes backwards"));
            add(status_.keys & kKeyIgnoreWaits, word("Waits ignored"));
            add(status_.keys & kKeySingleBlock, word("Single block"));
            add(status_.keys & kKeyOptionalStop, word("Optional stop"));
            add(status_.keys & kKeyDryRun, word("Dry run"));
            add(status_.keys & kKeyMachineLock, word("Machine lock"));
            add(status_.keys & kKeyFirstPart, word("First part"));
            add(status_.keys & kAllBlockSkips, word("Block skip"));
            // a dense card has no other room for them
            const QString codes =
                dense_ && !spare_ && switches.isEmpty() ? activeCodes() : QString();
            if (!codes.isEmpty()) {
                const double line = hint_.isEmpty() ? h : h / 2;
                Item& item =
                    w_.text(QRectF(box.left() + px(8), box.top(), box.width() - px(12), line),
                            codes, lettering(12.5, false, Face::Condensed), t_.dim,
                            Qt::AlignLeft | Qt::AlignVCenter);
                item.wraps = hint_.isEmpty();
                item.data = true;
                if (!hint_.isEmpty())
                    w_.data(
                        QRectF(box.left() + px(8), box.top() + line, box.width() - px(12), line),
                        hint_, lettering(12.5, false, Face::Condensed), t_.faint);
            } else {
                w_.data(box.adjusted(px(12), 0, -px(6), 0), switches.isEmpty() ? hint_ : switches,
                        lettering(13.5), t_.dim);
            }
        }
        below(h);
    }

    void axes() {
        const std::size_t count = config_.axis_count;
        const double head = px(dense_ ? 15 : 17), row = px(dense_ ? 22 : count > 4 ? 26 : 35);
        // eight channels side by side: condensed figures
        const bool narrow = wide_ < px(320);
        const double name = px(narrow ? 24 : 34), first = (wide_ - name) * (narrow ? 0.31 : 0.34),
                     other = (wide_ - name - first) / 3;
        const double at[] = {left_ + name, left_ + name + first, left_ + name + first + other,
                             left_ + name + first + 2 * other};
        const double wide[] = {first, other, other, other};
        const QString heads[] = {word("Workpiece"), word("Machine"), word("To go"),
                                 narrow ? word("Lag") : word("Follow. error")};
        for (int c = 0; c < 4; ++c)
            w_.text(QRectF(at[c], y_, wide[c], head), heads[c],
                    lettering(11.5, false, Face::Condensed), t_.dim, kRight);
        y_ += head;
        for (std::size_t place = 0; place < count && y_ + row < size_.height(); ++place) {
            const AxisPlaces axis(live_, channel_, place);
            w_.text(QRectF(left_, y_, name, row), axis.name(), lettering(dense_ ? 15 : 19, true),
                    axis.moves ? t_.good : t_.text);
            if (axis.moves && !narrow)
                w_.sign(QRectF(left_ + name, y_ + (row - px(11)) / 2, px(11), px(11)), Sign::Run,
                        t_.good);
            if (axis.turns) {
                w_.text(QRectF(at[0], y_, wide[0], row), kDash, lettering(dense_ ? 16 : 20, true),
                        t_.faint, kRight);
                w_.text(QRectF(at[1], y_, at[3] + other - at[1], row), axis.spindle(),
                        lettering(dense_ ? 12.5 : 14), t_.faint, kRight);
                y_ += row;
                continue;
            }
            w_.text(
                QRectF(at[0], y_, wide[0], row), axis.workpiece(),
                narrow ? lettering(16, true, Face::Condensed) : lettering(dense_ ? 16 : 24, true),
                t_.text, kRight);
            const QFont small =
                narrow ? lettering(13, false, Face::Condensed) : lettering(dense_ ? 13.5 : 16);
            w_.text(QRectF(at[1], y_, wide[1], row), axis.machineOrNone(), small,
                    axis.referenced ? t_.text : t_.warn, kRight);
            w_.text(QRectF(at[2], y_, wide[2], row), axis.toGo(), small,
                    axis.goes ? t_.text : t_.faint, kRight);
            w_.text(QRectF(at[3], y_, wide[3], row), axis.lag(), small, t_.dim, kRight);
            y_ += row;
        }
        y_ += gap();
    }

    // Two tiles: feed and spindle, with what is commanded and the overrides.
    void speeds() {
        const double h = px(spare_   ? 62
                            : dense_ ? 44
                            : slim() ? 90
                                     : 74),
                     half = (wide_ - px(8)) / 2;
        tile(QRectF(left_, y_, half, h), Sign::Feed,
             live_.unit(channel_).speed(status_.path_speed * 60), live_.unit(channel_).perMinute(),
             feedWords(), status_.feed_override,
             word("Rapid %1 %").arg(std::lround(status_.rapid_override * 100)));
        const unsigned spindle =
            view_.known && view_.picture.spindle ? view_.picture.spindle : config_.default_spindle;
        const QRectF right(left_ + half + px(8), y_, half, h);
        if (spindle >= 1 && spindle <= kMaxSpindles) {
            const SpindleStatus& now = live_.status().spindles[spindle - 1];
            const QString turn = now.flags & 2u  ? QString()
                                 : now.speed < 0 ? QString::fromUtf8("↺ ")
                                                 : QString::fromUtf8("↻ ");
            tile(right, Sign::Spindle, turn + QString::number(std::abs(now.speed), 'f', 0),
                 unitWord("1/min"), speedWords(spindle), now.override,
                 fromView(live_.config().spindle(spindle).name_text()) +
                     (now.owner && now.owner != channel_ ? QString("  L%1").arg(now.owner)
                                                         : QString()));
        } else {
            w_.fill(right, t_.raised, px(7));
        }
        below(h);
    }

    void tile(const QRectF& box, Sign sign, const QString& value, const QString& unit,
              const QString& wanted, double override, const QString& note) {
        w_.fill(box, t_.raised, px(7));
        const double big = dense_ ? 16 : 25, line = dense_ ? px(22) : px(34);
        w_.sign(
            QRectF(box.left() + px(9), box.top() + line / 2 - px(dense_ ? 5 : 7), px(18), px(18)),
            sign, t_.dim);
        const QFont unitFont = lettering(12.5);
        // an inch has long names in some languages
        const double unitWide = box.width() > px(200)
                                    ? std::max<double>(px(52), wordsWidth(unit, unitFont) + px(2))
                                    : 0;
        w_.text(
            QRectF(box.left() + px(30), box.top() + px(3), box.width() - px(38) - unitWide, line),
            value, lettering(big, true), t_.text, kRight);
        if (unitWide > 0)
            w_.text(QRectF(box.right() - unitWide - px(4), box.top() + px(3), unitWide, line), unit,
                    unitFont, t_.dim, kRight);
        const double second = box.top() + line + px(2);
        // Four channels side by side: what is commanded and the note have a line each.
        const double wantedWide = slim() ? box.width() - px(18) : box.width() * 0.5,
                     noteTop = slim() ? second + px(17) : second,
                     noteLeft = slim() ? box.left() + px(9) : box.left() + box.width() * 0.5;
        const bool lines = !dense_ || spare_;
        if (lines)
            w_.data(QRectF(box.left() + px(9), second, wantedWide, px(16)), wanted, lettering(12.5),
                    t_.dim);
        const bool changed = std::abs(override - 1.0) > 1e-6;
        const QString percent = QString("%1 %").arg(std::lround(override * 100));
        if (lines)
            w_.text(QRectF(noteLeft, noteTop, box.right() - px(9) - noteLeft, px(16)), note,
                    lettering(12.5, false, Face::Condensed), t_.dim, kRight);
        const double bar = box.bottom() - px(dense_ ? 12 : 15);
        w_.bar(QRectF(box.left() + px(10), bar + px(1), box.width() - px(70), px(7)),
               override / 1.5, changed ? t_.warn : t_.accent, t_.edge);
        w_.text(QRectF(box.right() - px(56), bar - px(5), px(48), px(18)), percent,
                lettering(13, true), changed ? t_.warn : t_.text, kRight);
    }

    QString feedWords() const {
        if (!view_.known) return {};
        const BlockPicture& p = view_.picture;
        const LengthUnit unit = live_.unit(channel_);
        switch (static_cast<FeedMode>(p.feed_mode)) {
            case FeedMode::PerRevolution:
                return QString("F %1 %2").arg(unit.of(p.feed), 0, 'g', 5).arg(unit.perRevolution());
            case FeedMode::PerMinute:
                return QString("F %1 %2").arg(unit.of(p.feed), 0, 'g', 6).arg(unit.perMinute());
            case FeedMode::InverseTime:
                return QString("F %1 1/%2").arg(p.feed, 0, 'g', 5).arg(unitWord("min"));
            default:
                return {};
        }
    }

    QString speedWords(unsigned spindle) const {
        const QString command =
            QString("S %1").arg(std::abs(live_.status().spindles[spindle - 1].command), 0, 'f', 0);
        if (!view_.known || view_.picture.spindle != spindle) return command;
        const BlockPicture& p = view_.picture;
        const QString limit = p.speed_limit > 0
                                  ? QString(QChar(0x2264)) + QString::number(p.speed_limit, 'f', 0)
                                  : QString();
        if (static_cast<SpindleModeCode>(p.spindle_mode) == SpindleModeCode::SurfaceSpeed) {
            const LengthUnit unit = live_.unit(channel_);
            return QString("S %1 %2 %3")
                .arg(unit.surface(p.speed), 0, 'g', 5)
                .arg(unit.surfaceName(), limit);
        }
        if (static_cast<SpindleModeCode>(p.spindle_mode) == SpindleModeCode::Position)
            return QString("%1%2").arg(p.speed, 0, 'f', 2).arg(QChar(0xB0));
        return command;
    }

    QString activeCodes() const {
        const auto& codes = view_.picture.codes;
        return view_.known
                   ? QString::fromUtf8(codes.data(),
                                       static_cast<int>(::strnlen(codes.data(), codes.size())))
                   : QString();
    }

    void tool() {
        const double h = px(dense_ ? 20 : 26);
        const BlockPicture& p = view_.picture;
        const ToolAtWork inWork = toolAtWork(live_, channel_);
        QString tool = toolAtWorkText(inWork, true), offset;
        if (tool.isEmpty()) tool = word("no tool known");
        // behind a selection too: positions count it until the program begins
        if (p.tool > 0 || p.offset > 0 || p.geometry > 0) {
            offset = p.edge > 0       ? QString("D%1").arg(p.edge)
                     : p.geometry > 0 ? QString("%1 %2").arg(word("Offset")).arg(p.geometry)
                                      : QString();
            if (p.nose_radius > 0)
                offset += QString("  R%1").arg(live_.unit(channel_).of(p.nose_radius), 0, 'g', 4);
            if (p.tip > 0) offset += QString("  %1 %2").arg(word("tip")).arg(p.tip);
        }
        w_.sign(QRectF(left_, y_ + h / 2 - px(9), px(18), px(18)), Sign::Tools, t_.dim);
        w_.data(QRectF(left_ + px(26), y_, offset.isEmpty() ? wide_ - px(26) : wide_ * 0.45, h),
                tool, lettering(dense_ ? 14 : 16, true),
                view_.known || inWork.certain ? t_.text : t_.faint);
        w_.data(QRectF(left_ + wide_ * 0.45, y_, wide_ * 0.55, h), offset,
                lettering(dense_ ? 12.5 : 14), t_.dim, kRight);
        below(h);
        if (dense_ && !spare_) return;
        const double lines = px(!dense_ ? 37 : wide_ > px(600) ? 18 : 33);
        Item& item =
            w_.text(QRectF(left_, y_, wide_, lines), activeCodes(),
                    lettering(13.5, false, Face::Condensed), t_.dim, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        item.data = true;
        below(lines);
    }

    void program() {
        const double room = size_.height() - y_ - px(dense_ ? 32 : 66);
        const double head = px(dense_ ? 18 : 22), row = px(dense_ ? 18 : 21);
        // two before and three after, where there is room
        const int lines = std::clamp(static_cast<int>((room - head) / row), 1, 6),
                  before = lines >= 5 ? 2 : 1;
        const std::string path =
            view_.file < view_.programs.size() ? view_.programs[view_.file] : std::string();
        const QString file = QFileInfo(QString::fromStdString(path)).fileName();
        rule();
        w_.data(QRectF(left_, y_, wide_ * 0.72, head), file.isEmpty() ? word("no program") : file,
                lettering(dense_ ? 13 : 14.5, true), file.isEmpty() ? t_.faint : t_.text);
        if (status_.line)
            w_.text(QRectF(left_ + wide_ * 0.72, y_, wide_ * 0.28, head),
                    status_.block >= 0 ? QString("N%1").arg(status_.block)
                                       : QString("%1 %2").arg(word("line")).arg(status_.line),
                    lettering(13), t_.dim, kRight);
        y_ += head;
        const auto running = static_cast<int>(status_.line);
        // The running block is shown whole: one that is longer than a line of a dense card has two,
        // and the block before it goes.
        const QFont bold = lettering(dense_ ? 12 : 13.5, true, Face::Program);
        const bool two = dense_ && running && lines > 1 &&
                         wordsWidth(programs_.line(path, static_cast<std::uint32_t>(running)),
                                    bold) > wide_ - px(18);
        const int first =
            running ? std::max(1, running - (two ? 0 : std::min(before, lines - 1))) : 1;
        for (int i = 0, number = first; i < lines; ++i, ++number) {
            const bool here = number == running;
            const QRectF box(left_, y_ + i * row, wide_, here && two ? 2 * row : row);
            if (here && two) {
                w_.fill(box.adjusted(-px(4), 0, px(4), 0), t_.mark, px(4));
                w_.sign(QRectF(box.left(), box.top() + (row - px(12)) / 2, px(12), px(12)),
                        Sign::Run, t_.accent);
                const QRectF words = box.adjusted(px(18), 0, 0, 0);
                Item& item =
                    w_.text(words,
                            wordsCutTo(programs_.line(path, static_cast<std::uint32_t>(number)),
                                       bold, words.size()),
                            bold, t_.text);
                item.wraps = true;
                item.data = true;
                ++i;
                continue;
            }
            if (here) w_.fill(box.adjusted(-px(4), 0, px(4), 0), t_.mark, px(4));
            if (here)
                w_.sign(QRectF(box.left(), box.center().y() - px(6), px(12), px(12)), Sign::Run,
                        t_.accent);
            w_.data(box.adjusted(px(18), 0, 0, 0),
                    programs_.line(path, static_cast<std::uint32_t>(number)),
                    lettering(dense_ ? 12 : 13.5, here, Face::Program), here ? t_.text : t_.dim);
        }
        y_ += lines * row + gap();
    }

    void parts() {
        const double foot = px(dense_ ? 6 : 12);
        // a dense card with fewer axes has room to say what the figures are
        const bool headed = !dense_ || size_.height() - px(30) - foot >= y_ - gap();
        const double h = px(!dense_ ? 48 : headed ? 30 : 22), top = size_.height() - h - foot;
        if (top < y_ - gap()) return;
        y_ = top;
        rule();
        const params::Table& table = live_.table();
        const double made = params::get(table, params::n2307_no_of_machined_parts, channel_),
                     wanted = params::get(table, params::n2308_no_of_parts_reqrd, channel_);
        const bool runs = status_.state == static_cast<std::uint32_t>(ChannelState::Running) ||
                          status_.state == static_cast<std::uint32_t>(ChannelState::Waiting);
        const double mean = status_.mean_cycle_s;
        const double left =
            wanted > made && mean > 0
                ? std::max(0.0, (wanted - made) * mean - (runs ? status_.cycle_s : 0.0))
                : -1.0;
        const QString values[] = {
            wanted > 0 ? QString("%1 / %2").arg(made, 0, 'f', 0).arg(wanted, 0, 'f', 0)
                       : QString::number(made, 'f', 0),
            timeText(status_.cycle_s), status_.cycles ? timeText(status_.last_cycle_s) : kDash,
            status_.cycles ? timeText(mean) : kDash, left >= 0 ? timeText(left) : kDash};
        const QString heads[] = {word("Parts"), word("Cycle"), word("Last"), word("Mean"),
                                 word("Remaining")};
        for (int i = 0; i < 5; ++i) {
            const QRectF box(left_ + wide_ * i / 5, y_, wide_ / 5 - px(4), h);
            if (dense_) {
                if (headed)
                    w_.text(QRectF(box.left(), box.top() + px(1), box.width() + px(3), px(13)),
                            heads[i], lettering(10.5, false, Face::Condensed), t_.dim);
                w_.text(QRectF(box.left(), box.bottom() - px(18), box.width(), px(18)), values[i],
                        lettering(13, true), t_.text);
                continue;
            }
            w_.text(QRectF(box.left(), box.top() + px(2), box.width() + px(slim() ? 3 : 0), px(17)),
                    heads[i], lettering(slim() ? 10.5 : 12, false, Face::Condensed), t_.dim);
            w_.text(QRectF(box.left(), box.top() + px(20), box.width(), px(26)), values[i],
                    lettering(17, true), t_.text);
        }
    }

    Writer& w_;
    const Theme& t_;
    const Live& live_;
    const AlarmLog& alarms_;
    unsigned channel_;
    const ChannelStatus& status_;
    const ChannelView& view_;
    const ChannelConfig& config_;
    ProgramText& programs_;
    QSizeF size_;
    unsigned chosen_;
    // spare: a dense card with room for every line of a whole one
    bool focus_, dense_ = false, spare_ = false;
    QString hint_;
    bool turned_;
    double left_ = 0, wide_ = 0, y_ = 0;
};

}  // namespace

void composeCard(Writer& w, QSizeF size, const Context& context, unsigned channel,
                 ProgramText& programs, const QString& hint, bool turned) {
    Card(w, size, context, channel, programs, hint, turned).write();
}

}  // namespace polyturn::hmi
