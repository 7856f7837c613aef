#include "hmi/widgets/text_entry.hpp"

#include <QKeyEvent>
#include <algorithm>

#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kCloseHit = 1, kClearHit = 2;

}  // namespace

TextEntry::TextEntry(QWidget* parent)
    : QWidget(parent), line_(new FreeSheet(this)), pad_(new TextPad(this)) {
    hide();
    line_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        const double wide = line_->width(), high = line_->height();
        w.fill(QRectF(0, 0, wide, high), t.bar);
        w.text(QRectF(px(14), 0, wide * 0.28, high), question_.title, lettering(15, true), t.text)
            .data = true;
        const QRectF box(wide * 0.3, px(7), wide * 0.7 - px(270), high - px(14));
        w.field(box, question_.text, QString(), true, 0, Face::Text, caret_);
        for (const auto& [hit, text, left] : {std::tuple{kClearHit, word("Empty"), wide - px(260)},
                                              {kCloseHit, word("Close"), wide - px(130)}}) {
            const QRectF key(left, px(7), px(120), high - px(14));
            w.fill(key, t.raised, px(6));
            w.frame(key, t.edge, px(6), 1);
            w.text(key, text, lettering(15, true), t.text, Qt::AlignCenter);
            w.hit(key, hit);
        }
    };
    line_->onTouched = [this](int number) {
        if (number == kCloseHit) return shut(false);
        if (number == kClearHit) {
            question_.text.clear();
            caret_ = 0;
            changed();
        }
    };
    pad_->onText = [this](const QString& text) { write(text); };
    pad_->onBackspace = [this] { erase(caret_ - 1); };
    pad_->onMove = [this](int letters) { move(caret_ + letters); };
    pad_->onEnter = [this] { shut(true); };
}

void TextEntry::open(TextQuestion question) {
    question_ = std::move(question);
    caret_ = question_.text.size();
    pad_->capitals = question_.capitals;
    // programs have Latin letters
    pad_->national = !question_.capitals;
    pad_->latin = question_.capitals;
    show();
    raise();
    refresh();
}

void TextEntry::shut(bool take) {
    if (!isVisible()) return;
    hide();
    const TextQuestion asked = std::move(question_);
    question_ = {};
    if (take && asked.done) asked.done(asked.text);
}

void TextEntry::write(const QString& text) {
    if (question_.text.size() >= question_.most) return;
    question_.text.insert(caret_, text);
    caret_ += text.size();
    changed();
}

void TextEntry::erase(qsizetype from) {
    if (from < 0 || from >= question_.text.size()) return;
    question_.text.remove(from, 1);
    caret_ = from;
    changed();
}

void TextEntry::move(qsizetype to) {
    caret_ = std::clamp<qsizetype>(to, 0, question_.text.size());
    refresh();
}

void TextEntry::changed() {
    if (question_.changed) question_.changed(question_.text);
    refresh();
}

bool TextEntry::key(QKeyEvent* event) {
    if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
    const QString text = event->text();
    if (event->key() == Qt::Key_Escape)
        shut(false);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        shut(true);
    else if (event->key() == Qt::Key_Backspace)
        erase(caret_ - 1);
    else if (event->key() == Qt::Key_Delete)
        erase(caret_);
    else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        move(caret_ + (event->key() == Qt::Key_Left ? -1 : 1));
    else if (event->key() == Qt::Key_Home || event->key() == Qt::Key_End)
        move(event->key() == Qt::Key_Home ? 0 : question_.text.size());
    else if (text.size() == 1 && text[0].isPrint() && question_.text.size() < question_.most)
        write(question_.capitals ? text.toUpper() : text);
    else
        return false;
    return true;
}

void TextEntry::resizeEvent(QResizeEvent*) {
    const int top = px(60);
    line_->setGeometry(0, 0, width(), top);
    pad_->setGeometry(0, top, width(), height() - top);
}

}  // namespace polyturn::hmi
