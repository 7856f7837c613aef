#include "hmi/screens/machine/diagnosis.hpp"

#include <QDateTime>
#include <QKeyEvent>

#include "hmi/screens/overview/channel_keys.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kSearchHit = 50;  // above the channels
constexpr qint64 kTicksMs = 250;

}  // namespace

Diagnosis::Diagnosis(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      table_(new Table(this)),
      detail_(new FreeSheet(this)),
      scope_(new ScopePage(context, this)) {
    setFocusPolicy(Qt::StrongFocus);
    head_->onCompose = [this](Writer& w) { composeHead(w); };
    head_->onTouched = [this](int number) {
        if (number == kSearchHit)
            return context_.ask(
                {word("Search"), search_, [this](const QString& text) { find(text); }, {}});
        context_.choose(static_cast<unsigned>(number));
        refresh();
    };
    detail_->onCompose = [this](Writer& w) { composeTicks(w); };
    showPage(Page::Signals);
}

void Diagnosis::rebuilt() {
    scope_->rebuilt();
    // of the machine that there is now, at the same place
    restore(state());
}

void Diagnosis::restore(const QString& state) {
    const int page = state.section(' ', 0, 0).toInt();
    if (page < 0 || page > static_cast<int>(Page::Scope)) return;
    showPage(static_cast<Page>(page));
    if (page_ == Page::Signals || page_ == Page::Variables) find(state.section(' ', 2));
    if (page_ != Page::Scope) table_->choose(state.section(' ', 1, 1).toInt());
}

void Diagnosis::turnTo(int page) {
    showPage(static_cast<Page>(std::min(page, static_cast<int>(Page::Scope))));
    scope_->showCircle(page == 7);
    scope_->showChooser(page == 8);
    scope_->showLevel(page == 9);
}

void Diagnosis::showPage(Page page) {
    page_ = page;
    search_.clear();
    table_->nothing.clear();
    switch (page) {
        case Page::Signals:
            fillSignals();
            break;
        case Page::Axes:
            fillAxes();
            break;
        case Page::Couplings:
            fillCouplings();
            break;
        case Page::Variables:
            fillVariables();
            break;
        case Page::Counters:
            fillCounters();
            break;
        case Page::Processes:
            fillProcesses();
            break;
        case Page::Scope:
            scope_->showCircle(false);
            break;
    }
    if (page != Page::Scope) table_->choose(0);
    ticksAt_ = 0;
    layOut();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void Diagnosis::resizeEvent(QResizeEvent*) { layOut(); }

void Diagnosis::layOut() {
    const bool beside = page_ == Page::Processes, scope = page_ == Page::Scope;
    const bool stacked = beside && upright(*this);
    const int top = px(46), edge = px(8), side = beside && !stacked ? width() / 2 : 0,
              below = stacked ? (height() - top) / 2 : 0;
    head_->setGeometry(0, 0, width(), top);
    table_->setGeometry(edge, top, width() - 2 * edge - side, height() - top - edge - below);
    if (stacked)
        detail_->setGeometry(0, height() - below, width() - edge, below - edge);
    else
        detail_->setGeometry(width() - side, top, side - edge, height() - top - edge);
    scope_->setGeometry(0, top, width(), height() - top);
    table_->setVisible(!scope);
    detail_->setVisible(beside);
    scope_->setVisible(scope);
}

std::vector<Sheet*> Diagnosis::sheets() {
    std::vector<Sheet*> out{head_};
    if (page_ == Page::Scope) {
        for (Sheet* one : scope_->sheets()) out.push_back(one);
        return out;
    }
    out.push_back(table_);
    if (page_ == Page::Processes) out.push_back(detail_);
    return out;
}

void Diagnosis::composeHead(Writer& w) {
    const Theme& t = theme();
    static constexpr const char* kTitles[] = {WORD("Signals of NC and PLC"),
                                              WORD("Axes and drives"),
                                              WORD("Couplings and exchanges"),
                                              WORD("Variables"),
                                              WORD("Timers and counters"),
                                              WORD("Processes and ticks"),
                                              WORD("Scope")};
    w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
    // there the keys of sixteen channels want the room
    const double title = head_->width() * (page_ == Page::Variables ? 0.18 : 0.4);
    w.text(QRectF(px(14), 0, title, head_->height()),
           page_ == Page::Scope && scope_->circle()
               ? word("Circularity")
               : word(kTitles[static_cast<std::size_t>(page_)]),
           lettering(20, true), t.text);
    double right = head_->width() - px(8);
    if (page_ == Page::Variables || (page_ == Page::Scope && scope_->circle()))
        right = composeChannelKeys(w, context_, head_->size());
    if (page_ == Page::Signals || page_ == Page::Variables) {
        const QRectF field(title + px(24), px(6), right - title - px(38), head_->height() - px(10));
        w.field(field, search_,
                field.width() < px(240) ? word("Search") : word("Type a part of the name"),
                !search_.isEmpty(), kSearchHit);
    }
}

// What the scope waits for may come while another screen is looked at; and time goes on.
void Diagnosis::follow() {
    scope_->follow();
    totals_.follow(context_.live);
}

void Diagnosis::refresh() {
    switch (page_) {
        case Page::Couplings:
            fillCouplings();
            break;
        case Page::Variables:
            fillVariables();
            break;
        case Page::Processes:
            fillProcesses();
            break;
        case Page::Scope:
            scope_->refresh();
            break;
        default:
            break;
    }
    head_->refresh();
    if (page_ != Page::Scope) table_->refresh();
    // The histogram changes with each tick and its bars are many: now and then.
    if (const qint64 now = QDateTime::currentMSecsSinceEpoch();
        page_ == Page::Processes && now >= ticksAt_) {
        ticksAt_ = now + kTicksMs;
        detail_->refresh();
    }
}

std::vector<SoftKey> Diagnosis::keys() {
    if (page_ == Page::Scope)
        return scope_->keys([this] {
            if (scope_->circle())
                scope_->showCircle(false);
            else
                showPage(Page::Signals);
        });
    const auto page = [this](Page wanted, const QString& text) {
        return SoftKey{text, [this, wanted] { showPage(wanted); }, Sign::None, true,
                       page_ == wanted};
    };
    return {page(Page::Signals, word("Signals")),
            page(Page::Axes, word("Axes")),
            page(Page::Couplings, word("Couplings")),
            page(Page::Variables, word("Variables")),
            page(Page::Counters, word("Timers, counters")),
            page(Page::Processes, word("Processes")),
            {word("Scope"), [this] { showPage(Page::Scope); }, Sign::Feed},
            {word("Circularity"),
             [this] {
                 showPage(Page::Scope);
                 scope_->showCircle(true);
             },
             Sign::Spindle}};
}

void Diagnosis::find(const QString& text) {
    search_ = text;
    if (page_ == Page::Signals)
        fillSignals();
    else
        fillVariables();
    table_->choose(0);
    refresh();
}

bool Diagnosis::key(QKeyEvent* event) {
    if (page_ == Page::Scope) {
        const bool done = scope_->key(event);
        if (done && context_.keysChanged) context_.keysChanged();
        return done;
    }
    if (page_ == Page::Signals || page_ == Page::Variables) {
        const QString text = event->text();
        if (event->key() == Qt::Key_Backspace)
            search_.chop(1);
        else if (event->key() == Qt::Key_Escape)
            search_.clear();
        else if (text.size() == 1 && text[0].isPrint() &&
                 !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)))
            search_ += text;
        else
            return table_->key(event);
        find(search_);
        return true;
    }
    return table_->key(event);
}

// The chosen signal, then what the page is about.
HelpTopic Diagnosis::help() const {
    const auto row = static_cast<std::size_t>(std::max(0, table_->row()));
    if (page_ != Page::Signals || row >= found_.size()) return {"operator.md", "Diagnosis:", {}};
    const SignalLine& one = found_[row];
    return {"builder.md", "A PLC of your own",
            QString("# %1\n\n%2\n\n%3")
                .arg(one.name, one.meaning,
                     one.plc ? word("The PLC writes it.") : word("The NC writes it."))};
}

}  // namespace polyturn::hmi
