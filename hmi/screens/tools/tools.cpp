#include "hmi/screens/tools/tools.hpp"

#include <QDateTime>
#include <QMouseEvent>
#include <algorithm>

#include "hmi/text/search.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr qsizetype kNameBytes = 32;  // of the longest text in a row of tools, with its end
constexpr int kFilterHit = 900, kSearchHit = 901;

}  // namespace

void ToolList::mousePressEvent(QMouseEvent* event) {
    from_ = event->position();
    out_ = false;
    const int row = rowAt(from_);
    lifted_ = row >= 0 && toolAt ? toolAt(row) : 0;
    Table::mousePressEvent(event);
}

void ToolList::mouseMoveEvent(QMouseEvent* event) {
    const QPointF way = event->position() - from_;
    if (lifted_ && !out_ && way.x() < -px(24) && std::abs(way.x()) > 0.6 * std::abs(way.y())) {
        out_ = true;
        if (onLifted) onLifted(lifted_);
    }
    if (!out_) Table::mouseMoveEvent(event);
}

void ToolList::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(out_, false)) {
        if (onDropped) onDropped(lifted_, event->globalPosition().toPoint());
        lifted_ = 0;
        return;
    }
    lifted_ = 0;
    Table::mouseReleaseEvent(event);
}

Tools::Tools(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      detail_(new FreeSheet(this)),
      side_(new FreeSheet(this)),
      picture_(new Magazine(context.live, this)),
      list_(new ToolList(this)),
      table_(new Table(this)),
      pad_(new NumberPad(this)),
      letters_(new TextPad(this)),
      presetter_(new PresetterPage(context, this)) {
    setFocusPolicy(Qt::StrongFocus);
    letters_->onText = [this](const QString& text) {
        if ((typed_ + text).toUtf8().size() < kNameBytes) {
            typed_ += text;
            refresh();
        }
    };
    letters_->national = true;  // Latin ones at first: programs call tools by these
    letters_->onBackspace = [this] {
        typed_.chop(1);
        refresh();
    };
    letters_->onEnter = [this] {
        fieldActivated();
        refresh();
    };
    picture_->focused = true;
    head_->onCompose = [this](Writer& w) { composeHead(w); };
    head_->onTouched = [this](int number) {
        if (number == kFilterHit) return nextFilter();
        if (number == kSearchHit)
            return context_.ask({word("Search"),
                                 search_,
                                 [this](const QString& text) {
                                     search_ = text;
                                     fillList();
                                     list_->choose(0);
                                     refresh();
                                 },
                                 {}});
        showMagazine(number - 1000);
    };
    detail_->onCompose = [this](Writer& w) { composeDetail(w); };
    side_->onCompose = [this](Writer& w) { composeSide(w); };
    side_->onTouched = [this](int) {
        if (page_ == Page::Pallets) askProgram();
    };
    picture_->onChosen = [this] {
        picture_->focused = true;
        followPlace();
        if (context_.keysChanged) context_.keysChanged();
    };
    picture_->onActivated = [this] {
        const ToolPlace* place = picture_->chosen();
        if (picture_->carried)
            putDown(place);
        else if (place && place->tool)
            showPage(Page::Data);
    };
    picture_->onLifted = [this](std::int32_t tool) { carry(tool); };
    picture_->onDropped = [this](std::int32_t tool, const QPoint& at) { dropped(tool, at); };
    list_->columns = {{word("No."), 0.55, kRight},
                      {word("Tool"), 1.75},
                      {word("Place"), 0.85},
                      {word("Life left"), 1.3},
                      {word("State"), 2.0}};
    list_->rowUnits = 36;
    list_->textUnits = 14.5;
    list_->rows = [this] { return static_cast<int>(rows_.size()); };
    list_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        const std::int32_t number = rows_[static_cast<std::size_t>(row)];
        const ToolRow* tool = toolOf(context_.live, number);
        if (!tool) return {};
        switch (column) {
            case 0:
                return {QString::number(number), t.dim};
            case 1:
                return {toolName(*tool, number) +
                            (tool->duplo > 1 ? QString("  #%1").arg(tool->duplo) : QString()),
                        t.text, Sign::None, number == tool_};
            case 2:
                return {tool->magazine ? placeText(context_.live, tool->magazine, tool->pot)
                                       : QString::fromUtf8("–"),
                        tool->magazine ? t.text : t.dim};
            case 3: {
                Table::Cell cell{lifeText(*tool), colourOf(lifeTone(*tool)), Sign::None, false,
                                 Face::Condensed};
                cell.bar = lifeLeft(*tool);
                if (cell.bar < 0) cell = {};
                return cell;
            }
            default: {
                const StateWords state = toolWords(*tool);
                return {state.text, colourOf(state.tone), state.sign, false, Face::Condensed};
            }
        }
    };
    list_->onChosen = [this] {
        picture_->focused = false;
        if (list_->row() < static_cast<int>(rows_.size()))
            chooseTool(rows_[static_cast<std::size_t>(list_->row())]);
    };
    list_->onActivated = [this] {
        if (tool_) showPage(Page::Data);
    };
    list_->toolAt = [this](int row) { return rows_[static_cast<std::size_t>(row)]; };
    list_->onLifted = [this](std::int32_t tool) { carry(tool); };
    list_->onDropped = [this](std::int32_t tool, const QPoint& at) { dropped(tool, at); };
    table_->onChosen = [this] {
        typed_.clear();
        pad_->clear();
        if (page_ == Page::Data && letters_->isVisible() != textField()) layOut();
        if (page_ == Page::Life && table_->row() < static_cast<int>(life_.size()) &&
            life_[static_cast<std::size_t>(table_->row())].tool)
            tool_ = life_[static_cast<std::size_t>(table_->row())].tool;
        if (context_.keysChanged) context_.keysChanged();
    };
    table_->onActivated = [this] {
        if (page_ == Page::Data) fieldActivated();
        if (page_ == Page::Pallets) askProgram();
    };
    showPage(Page::Magazine);
}

void Tools::rebuilt() {
    version_ = 0;
    lookAt_ = 0;
    life_.clear();
    pallets_.clear();
    whyNoPallets_.clear();
    const auto all = magazines();
    if (!all.empty() && std::find(all.begin(), all.end(), picture_->shown()) == all.end())
        picture_->show(all.front());
}

void Tools::restore(const QString& state) {
    const QStringList parts = state.split(' ');
    if (parts.size() < 2) return;
    if (parts.size() > 2 && parts[2] != "-") presetter_->setPin(parts[2]);
    if (parts.size() > 4) {
        tool_ = parts[3].toInt();
        filter_ =
            static_cast<Filter>(std::clamp(parts[4].toInt(), 0, static_cast<int>(Filter::Replace)));
        search_ = state.section(' ', 5);
    }
    picture_->show(parts[1].toInt());
    if (parts[0].toInt() >= 0 && parts[0].toInt() <= static_cast<int>(Page::Presetter))
        showPage(static_cast<Page>(parts[0].toInt()));
    if (page_ != Page::Magazine || !chosen()) return;
    const std::int32_t wanted = tool_;
    // else keys speak of the place that the picture begins with
    picture_->focused = chosen()->magazine == picture_->shown();
    if (picture_->focused) picture_->choose(chosen()->pot);
    tool_ = wanted;
    fillList();
    if (const int at = rowOf(wanted); at >= 0) list_->choose(at);
}

std::vector<Sheet*> Tools::sheets() {
    switch (page_) {
        case Page::Magazine:
            return {head_, picture_, list_, detail_};
        case Page::Data:
            if (letters_->isVisible()) return {head_, table_, side_, letters_};
            return {head_, table_, side_, pad_};
        case Page::Pallets:
            return {head_, table_, side_, pad_};
        case Page::Life:
            return {head_, table_, detail_};
        case Page::Presetter:
            break;
    }
    std::vector<Sheet*> out = presetter_->sheets();
    out.push_back(head_);
    return out;
}

std::vector<std::int32_t> Tools::magazines() const {
    std::vector<std::int32_t> out;
    const ToolPlaceTable& places = context_.live.places();
    for (std::size_t i = 0; context_.live.connected() && i < places.count; ++i)
        if (out.empty() || out.back() != places.places[i].magazine)
            out.push_back(places.places[i].magazine);
    return out;
}

void Tools::turnTo(int page) {
    const auto all = magazines();
    // behind the pages: the magazines but the first
    const auto other = static_cast<std::size_t>(std::max(0, page - kPages + 1));
    const bool magazine = page == 0 || (page >= kPages && other < all.size());
    showPage(magazine ? Page::Magazine : static_cast<Page>(std::min(page, kPages - 1)));
    if (magazine && !all.empty()) showMagazine(all[page == 0 ? 0 : other]);
    if (!magazine && page >= kPages) presetter_->propose();
}

void Tools::showPage(Page page) {
    page_ = page;
    picture_->carried = 0;
    typed_.clear();
    pad_->clear();
    const bool magazine = page == Page::Magazine, own = page == Page::Presetter;
    picture_->setVisible(magazine);
    list_->setVisible(magazine);
    detail_->setVisible(magazine || page == Page::Life);
    table_->setVisible(!magazine && !own);
    side_->setVisible(page == Page::Data || page == Page::Pallets);
    pad_->setVisible(page == Page::Data || page == Page::Pallets);
    presetter_->setVisible(own);
    version_ = 0;
    lookAt_ = 0;
    taken_ = 0;
    if (page == Page::Data && !chosen() && !awaited() && !rows_.empty()) tool_ = rows_.front();
    if (page == Page::Data) fillData();
    if (page == Page::Life) fillLife();
    if (page == Page::Pallets) fillPallets();
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void Tools::resizeEvent(QResizeEvent*) { layOut(); }

void Tools::layOut() {
    const int top = px(page_ == Page::Magazine && upright(*this) ? 92 : 46), edge = px(8),
              right = page_ == Page::Magazine ? px(600) : px(340), foot = px(150), pad = px(380);
    head_->setGeometry(0, 0, width(), top);
    const QRect room(edge, top, width() - 2 * edge, height() - top - edge);
    const Parted all =
        parted(*this, room, right, page_ == Page::Magazine ? room.height() / 2 : px(400), edge);
    const Padded beside = padded(*this, all.side, px(346), pad, edge);
    if (page_ == Page::Magazine) {
        picture_->setGeometry(all.main);
        list_->setGeometry(all.side.adjusted(0, 0, 0, -foot - edge));
    }
    const bool side = page_ == Page::Data || page_ == Page::Pallets;
    const bool letters = page_ == Page::Data && textField();
    letters_->setVisible(letters);
    letters_->setGeometry(all.main.left(), all.main.bottom() + 1 - px(280), all.main.width(),
                          px(280));
    table_->setGeometry((side ? all.main : room)
                            .adjusted(0, 0, 0,
                                      page_ == Page::Life ? -px(80)
                                      : letters           ? -px(288)
                                                          : 0));
    if (page_ == Page::Life)
        detail_->setGeometry(edge, height() - px(76), width() - 2 * edge, px(68));
    else
        detail_->setGeometry(all.side.left(), all.side.bottom() + 1 - foot, all.side.width(), foot);
    side_->setGeometry(letters ? all.side : beside.rest);
    pad_->setGeometry(beside.pad);
    pad_->setVisible(side && !letters);
    presetter_->setGeometry(0, top, width(), height() - top);
    for (Sheet* one : sheets()) one->refresh();
}

bool Tools::passes(std::int32_t number, const ToolRow& tool) const {
    if (!search_.isEmpty() && !holds(toolName(tool, number), search_) &&
        QString::number(number) != search_ &&
        QString("T%1").arg(tool.type_number).compare(search_, Qt::CaseInsensitive) != 0)
        return false;
    switch (filter_) {
        case Filter::All:
            return true;
        case Filter::Here:
            return tool.magazine == picture_->shown();
        case Filter::Nowhere:
            return tool.magazine == 0;
        case Filter::Replace:
            return (tool.state & (kToolWorn | kToolWarned | kToolBroken | kToolLocked)) != 0;
    }
    return true;
}

void Tools::fillList() {
    version_ = context_.live.toolsVersion();
    rows_.clear();
    if (context_.live.connected())
        for (std::int32_t n = 1; n <= static_cast<std::int32_t>(kTools); ++n)
            if (const ToolRow* tool = toolOf(context_.live, n); tool && passes(n, *tool))
                rows_.push_back(n);
    list_->nothing = filter_ == Filter::All && search_.isEmpty()
                         ? word("There are no tools yet: «New tool» on the page of tool data.")
                         : word("No tool is like this.");
    if (!followPlace() && !chosen() && !awaited()) tool_ = rows_.empty() ? 0 : rows_.front();
}

// In the picture the keys act on what stands in the chosen place, and on nothing where it is empty.
// False: the list is where one chooses.
bool Tools::followPlace() {
    const ToolPlace* place = picture_->chosen();
    if (page_ != Page::Magazine || !picture_->focused || picture_->carried || !place) return false;
    if (place->tool)
        chooseTool(place->tool);
    else
        tool_ = 0;
    return true;
}

int Tools::rowOf(std::int32_t tool) const {
    const auto at = std::find(rows_.begin(), rows_.end(), tool);
    return at == rows_.end() ? -1 : static_cast<int>(at - rows_.begin());
}

void Tools::chooseTool(std::int32_t tool) {
    if (tool_ == tool) return;
    tool_ = tool;
    const ToolRow* row = chosen();
    if (picture_->focused) {
        if (const int at = rowOf(tool); at >= 0 && list_->row() != at) {
            const bool focused = picture_->focused;
            list_->choose(at);
            picture_->focused = focused;
        }
    } else if (row && row->magazine && !picture_->carried) {
        picture_->show(row->magazine);
        picture_->choose(row->pot);
        picture_->focused = false;
    }
    if (page_ == Page::Data) fillData();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void Tools::nextFilter() {
    filter_ = static_cast<Filter>((static_cast<int>(filter_) + 1) % 4);
    fillList();
    list_->choose(0);
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void Tools::composeHead(Writer& w) {
    const Theme& t = theme();
    // filter and search in a line of their own
    const bool stacked = page_ == Page::Magazine && upright(*this);
    const double high = stacked ? head_->height() / 2.0 : head_->height(),
                 down = stacked ? high : 0, end = head_->width() - px(stacked ? 8 : 608);
    static constexpr const char* kTitles[] = {WORD("Magazines"), WORD("Tool data"),
                                              WORD("Life and forecast"), WORD("Pallets"),
                                              WORD("Presetter")};
    w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
    w.text(QRectF(px(14), 0,
                  page_ == Page::Magazine || page_ == Page::Data ? px(230) : head_->width() * 0.5,
                  high),
           word(kTitles[static_cast<std::size_t>(page_)]), lettering(20, true), t.text);
    if (page_ == Page::Data) {
        const ToolRow* tool = chosen();
        w.data(QRectF(px(250), 0, head_->width() - px(260), high),
               tool ? QString("%1   %2").arg(tool_).arg(toolName(*tool, tool_)) : QString(),
               lettering(17, true), t.accent);
    }
    if (page_ != Page::Magazine) return;
    // As many as there are, between the title and the filter: places of spindles come last, and
    // must be there too.
    const auto all = magazines();
    const double begin = px(40) +
                         QFontMetricsF(lettering(20, true)).horizontalAdvance(word(kTitles[0])),
                 room = end - px(6) - begin;
    const double each = std::clamp<double>(
        room / static_cast<double>(std::max<std::size_t>(1, all.size())), px(40), px(68));
    double x = begin;
    for (const std::int32_t one : all) {
        const bool here = one == picture_->shown();
        const QRectF box(x, px(6), each - px(5), high - px(11));
        if (box.right() > end) break;
        w.fill(box, here ? t.mark : t.card, px(6));
        w.frame(box, here ? t.accent : t.edge, px(6), here ? px(2) : 1);
        w.text(box, one >= 10 ? placeText(context_.live, one, 1) : QString("M%1").arg(one),
               lettering(each < px(52) ? 13 : 15.5, here), t.text, Qt::AlignCenter);
        w.hit(box, magazineHit(one));
        x += each;
    }
    static constexpr const char* kFilters[] = {WORD("All tools"), WORD("In this magazine"),
                                               WORD("Not loaded"), WORD("To be replaced")};
    const QRectF box(head_->width() - px(608), down + px(6), px(250), high - px(11));
    w.fill(box, t.card, px(6));
    w.frame(box, filter_ == Filter::All ? t.edge : t.accent, px(6),
            filter_ == Filter::All ? 1 : px(2));
    w.text(box.adjusted(px(12), 0, -px(60), 0), word(kFilters[static_cast<std::size_t>(filter_)]),
           lettering(15, filter_ != Filter::All), t.text);
    w.text(box.adjusted(px(180), 0, -px(12), 0), QString::number(rows_.size()), lettering(15),
           t.dim, kRight);
    w.hit(box, kFilterHit);
    w.field(QRectF(head_->width() - px(350), down + px(6), px(342), high - px(11)), search_,
            word("Type a part of the name"), !search_.isEmpty(), kSearchHit);
}

// What the chosen tool is, beneath the list; on the page of lives what stops the machine first.
void Tools::composeDetail(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    if (page_ == Page::Life) {
        w.sign(QRectF(px(14), px(21), px(26), px(26)),
               firstToStop_.isEmpty() ? Sign::Note : Sign::Warning,
               firstToStop_.isEmpty() ? t.dim : t.warn);
        Item& item = w.text(
            QRectF(px(52), px(6), wide - px(64), high - px(12)),
            firstToStop_.isEmpty()
                ? word("No forecast yet: it begins when parts have been made with tools whose "
                       "life is monitored.")
                : firstToStop_,
            lettering(16), t.text);
        item.wraps = true;
        item.data = !firstToStop_.isEmpty();
        return;
    }
    const ToolRow* tool = chosen();
    if (const ToolPlace* place = picture_->chosen(); !tool && place) {
        w.text(QRectF(px(16), px(8), wide - px(32), px(28)),
               placeText(context_.live, place->magazine, place->pot) + "  " + word("empty"),
               lettering(18, true), t.dim);
        const auto& rows = context_.live.tools().rows;  // why nothing can be loaded now
        const bool homeless = std::any_of(rows.begin(), rows.end(), [](const ToolRow& one) {
            return one.used && one.magazine == 0;
        });
        w.text(QRectF(px(16), px(42), wide - px(32), px(52)),
               homeless ? word("To load: choose a tool without a place in the list")
                        : word("Nothing to load: every tool has a place"),
               lettering(15), t.dim, Qt::AlignLeft | Qt::AlignTop)
            .wraps = true;
    }
    if (!tool) return;
    const StateWords state = toolWords(*tool);
    w.fill(QRectF(0, 0, px(5), high), colourOf(state.tone), px(2));
    w.data(QRectF(px(16), px(8), wide * 0.56, px(28)), toolName(*tool, tool_), lettering(18, true),
           t.text);
    w.sign(QRectF(wide * 0.62, px(11), px(22), px(22)), state.sign, colourOf(state.tone));
    w.text(QRectF(wide * 0.62 + px(30), px(8), wide * 0.38 - px(42), px(28)), state.text,
           lettering(16, true), colourOf(state.tone));
    const auto line = [&](double x, double y, const QString& title, const QString& value) {
        w.text(QRectF(x, y, wide * 0.22, px(22)), title, lettering(14, false, Face::Condensed),
               t.dim);
        w.data(QRectF(x + wide * 0.2, y, wide * 0.27, px(22)),
               value.isEmpty() ? QString::fromUtf8("–") : value, lettering(15, true), t.text);
    };
    const double second = wide * 0.5;
    line(px(16), px(42), word("Place"), placeText(context_.live, tool->magazine, tool->pot));
    line(second, px(42), word("Called by"),
         tool->type_number ? QString("T%1").arg(tool->type_number) : QString());
    line(px(16), px(66), word("Kind"), kindText(tool->kind));
    line(second, px(66), word("Offset"), tool->h_cell ? QString::number(tool->h_cell) : QString());
    int sisters = 0;
    for (const ToolRow& one : context_.live.tools().rows)
        sisters += one.used && tool->type_number && one.type_number == tool->type_number;
    line(px(16), px(90), word("Sister"),
         sisters > 1 ? word("%1 of %2").arg(tool->duplo).arg(sisters) : QString());
    line(second, px(90), word("Life left"), lifeText(*tool));
    if (lifeLeft(*tool) >= 0)
        w.bar(QRectF(px(16), px(124), wide - px(32), px(12)), lifeLeft(*tool),
              colourOf(lifeTone(*tool)), t.edge);
}

void Tools::showMagazine(std::int32_t magazine) {
    picture_->show(magazine);
    if (const ToolPlace* place = picture_->chosen()) picture_->choose(place->pot);
    picture_->focused = true;
    version_ = 0;
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void Tools::refresh() {
    if (page_ == Page::Magazine && version_ != context_.live.toolsVersion()) fillList();
    if (page_ == Page::Data && version_ != context_.live.toolsVersion()) fillData();
    if ((page_ == Page::Life || page_ == Page::Pallets) && context_.live.connected() &&
        QDateTime::currentMSecsSinceEpoch() > lookAt_)
        look();
    if (page_ == Page::Presetter) presetter_->refresh();
    list_->marked = rowOf(tool_) >= 0;  // a place without a tool has no row
    for (Sheet* one : sheets()) one->refresh();
}

bool Tools::key(QKeyEvent* event) {
    if (page_ == Page::Presetter) return presetter_->key(event);
    if (page_ == Page::Magazine) {
        if (event->key() == Qt::Key_Escape) {
            if (picture_->carried)
                picture_->carried = 0;
            else {
                search_.clear();
                fillList();
            }
            refresh();
            return true;
        }
        if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) {
            picture_->focused = !picture_->focused;
            refresh();
            return true;
        }
        // what a finger chooses above the picture
        if ((event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown) &&
            (picture_->focused || picture_->carried)) {
            const auto all = magazines();
            const auto here = std::find(all.begin(), all.end(), picture_->shown()) - all.begin() +
                              (event->key() == Qt::Key_PageDown ? 1 : -1);
            if (here >= 0 && here < static_cast<std::ptrdiff_t>(all.size()))
                showMagazine(all[static_cast<std::size_t>(here)]);
            return true;
        }
        const QString text = event->text();
        if (event->key() == Qt::Key_Backspace ||
            (text.size() == 1 && text[0].isPrint() &&
             !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)))) {
            if (event->key() == Qt::Key_Backspace)
                search_.chop(1);
            else
                search_ += text;
            fillList();
            list_->choose(0);
            refresh();
            return true;
        }
        return picture_->focused || picture_->carried ? picture_->key(event) : list_->key(event);
    }
    if (page_ == Page::Data && textField()) {
        const QString text = event->text();
        if (event->key() == Qt::Key_Backspace) {
            typed_.chop(1);
            refresh();
            return true;
        }
        if (event->key() == Qt::Key_Escape) {
            typed_.clear();
            refresh();
            return true;
        }
        if (text.size() == 1 && text[0].isPrint() && (typed_ + text).toUtf8().size() < kNameBytes) {
            typed_ += text;
            refresh();
            return true;
        }
    } else if ((page_ == Page::Data || page_ == Page::Pallets) && pad_->key(event)) {
        return true;
    }
    return table_->key(event);
}

}  // namespace polyturn::hmi
