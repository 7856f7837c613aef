#include "hmi/screens/overview/overview.hpp"

#include <cmath>
#include <cstring>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/programs/code_help.hpp"
#include "hmi/screens/overview/channel_card.hpp"
#include "hmi/screens/overview/operation_keys.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {

Overview::Overview(Context& context) : Screen(context), empty_(new FreeSheet(this)) {
    setFocusPolicy(Qt::StrongFocus);
    empty_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, empty_->width(), empty_->height()), t.window);
        w.sign(
            QRectF(empty_->width() / 2.0 - px(32), empty_->height() / 2.0 - px(96), px(64), px(64)),
            Sign::Wait, t.dim);
        w.text(QRectF(0, empty_->height() / 2.0 - px(16), empty_->width(), px(36)),
               word("Waiting for the controller"), lettering(24, true), t.text, Qt::AlignCenter);
        w.data(QRectF(0, empty_->height() / 2.0 + px(24), empty_->width(), px(28)),
               QString::fromStdString(context_.live.instance()), lettering(17), t.dim,
               Qt::AlignCenter);
    };
}

void Overview::rebuilt() {
    qDeleteAll(cards_);
    cards_.clear();
    for (const unsigned channel : context_.live.channels()) {
        auto* card = new FreeSheet(this);
        card->onCompose = [this, card, channel](Writer& w) {
            composeCard(
                w, QSizeF(card->size()), context_, channel, programs_,
                canEnlarge() && !enlarged_ ? word("Touch again or Enter: enlarged") : QString(),
                turned_);
        };
        card->onTouched = [this, channel](int number) {
            if (number == kTurnAxesHit) {
                turned_ = !turned_;
                return refresh();
            }
            if (context_.channel == channel && canEnlarge()) return enlarge(!enlarged_);
            context_.choose(channel);
            refresh();
        };
        card->show();
        cards_.push_back(card);
    }
    empty_->setVisible(cards_.empty());
    layOut();
}

void Overview::resizeEvent(QResizeEvent*) { layOut(); }

void Overview::layOut() {
    empty_->setGeometry(rect());
    std::vector<FreeSheet*> grid = cards_;
    int from = 0, above = 0;  // what the large card takes of it
    laidFor_ = context_.channel;
    const auto& all = context_.live.channels();
    if (const auto here = std::find(all.begin(), all.end(), context_.channel);
        enlarged_ && canEnlarge() && here != all.end() && all.size() == cards_.size()) {
        FreeSheet* const big = cards_[static_cast<std::size_t>(here - all.begin())];
        grid.erase(std::find(grid.begin(), grid.end(), big));
        if (upright(*this)) {
            above = height() * 44 / 100;
            big->setGeometry(0, 0, width(), above);
        } else {
            from = width() * 46 / 100;
            big->setGeometry(0, 0, from, height());
        }
        big->refresh();
    }
    const int count = static_cast<int>(grid.size()), room = width() - from;
    if (!count) return;
    const int columns = upright(*this) ? (count <= 2   ? 1
                                          : count <= 8 ? 2
                                                       : 3)
                        : from         ? (count <= 4   ? 1
                                          : count <= 8 ? 2
                                                       : 3)
                        : count <= 4   ? count
                                       : (count + (count + 3) / 4 - 1) / ((count + 3) / 4),
              rows = (count + columns - 1) / columns;
    for (int i = 0; i < count; ++i) {
        const int left = from + room * (i % columns) / columns,
                  right = from + room * (i % columns + 1) / columns;
        const int top = above + (height() - above) * (i / columns) / rows,
                  bottom = above + (height() - above) * (i / columns + 1) / rows;
        grid[static_cast<std::size_t>(i)]->setGeometry(left, top, right - left, bottom - top);
        grid[static_cast<std::size_t>(i)]->refresh();
    }
}

QString Overview::state() const {
    return QString("%1 %2").arg(enlarged_ ? 1 : 0).arg(turned_ ? 1 : 0);
}
void Overview::restore(const QString& state) {
    turned_ = state.section(' ', 1, 1) == "1";
    enlarge(state.section(' ', 0, 0) == "1");
}

void Overview::enlarge(bool on) {
    enlarged_ = on;
    layOut();
}

// The two pages of keys of program control; one card enlarged; the keys of all channels.
int Overview::pages() const {
    return 3 + (canEnlarge() ? 1 : 0) + (groupOf(context_.live, context_.channel) ? 1 : 0);
}

void Overview::turnTo(int page) {
    const bool all =
        page >= 3 && page == pages() - 1 && groupOf(context_.live, context_.channel) != 0;
    page_ = page == 1   ? Keys::Control
            : page == 2 ? Keys::MoreControl
            : all       ? Keys::All
                        : Keys::Channels;
    enlarge(page == 3 && !all);
    if (context_.keysChanged) context_.keysChanged();
}

void Overview::refresh() {
    if (enlarged_ && laidFor_ != context_.channel) layOut();
    for (FreeSheet* card : cards_) card->refresh();
    if (cards_.empty()) empty_->refresh();
}

std::vector<Sheet*> Overview::sheets() {
    if (cards_.empty()) return {empty_};
    return {cards_.begin(), cards_.end()};
}

bool Overview::key(QKeyEvent* event) {
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && canEnlarge()) {
        enlarge(!enlarged_);
        return true;
    }
    if (event->key() == Qt::Key_Escape && enlarged_) {
        enlarge(false);
        return true;
    }
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        turned_ = event->key() == Qt::Key_Down;
        refresh();
        return true;
    }
    if (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right) return false;
    const auto& all = context_.live.channels();
    const auto here = std::find(all.begin(), all.end(), context_.channel);
    if (here == all.end()) return false;
    if (event->key() == Qt::Key_Left && here != all.begin()) context_.choose(*(here - 1));
    if (event->key() == Qt::Key_Right && here + 1 != all.end()) context_.choose(*(here + 1));
    refresh();
    return true;
}

// The code that moves now, in the reference of its program's language.
HelpTopic Overview::help() const {
    const ChannelView& view = context_.live.view(context_.channel);
    const QString page = referenceOf(context_.live.language(context_.channel));
    const QString codes = QString::fromUtf8(
        view.picture.codes.data(),
        static_cast<int>(::strnlen(view.picture.codes.data(), view.picture.codes.size())));
    if (!view.known || codes.isEmpty()) return {"operator.md", "Overview:", {}};
    return {page, codes.section(' ', 0, 0), {}, true};
}

// The first four have their places on every page: who is in need of Hold looks at no page. Where
// the machine has several groups, the next four are those of the chosen channel's; all channels
// together have a page.
std::vector<SoftKey> Overview::keys() {
    const Live& live = context_.live;
    const bool there = live.connected() && !live.channels().empty();
    const unsigned group = groupOf(live, context_.channel);
    std::vector<SoftKey> keys{startKey(context_), holdKey(context_), resetKey(context_),
                              singleBlockKey(context_)};
    if (page_ == Keys::Control || page_ == Keys::MoreControl) {
        addControlKeys(keys, there);
        return keys;
    }
    const unsigned whom = page_ == Keys::All ? 0 : group;
    for (const auto key : {startGroupKey, holdGroupKey, resetGroupKey, singleBlockGroupKey})
        keys.push_back(key(context_, whom));
    if (page_ != Keys::All)
        keys.push_back(
            {word("Program control"), [this] { showKeys(Keys::Control); }, Sign::Right, there});
    if (!group || page_ == Keys::All) keys.push_back(endWithPartKey());
    if (page_ == Keys::All)
        keys.push_back({word("Back"), [this] { showKeys(Keys::Channels); }, Sign::Left});
    else if (group)
        keys.push_back({word("All channels"), [this] { showKeys(Keys::All); }, Sign::Right, there});
    return keys;
}

SoftKey Overview::endWithPartKey() {
    const Live& live = context_.live;
    bool anyProgram = false, anyGoesOn = false;
    for (const unsigned one : live.channels()) {
        if (live.view(one).programs.empty()) continue;
        anyProgram = true;
        anyGoesOn |= (live.channel(one).keys & kKeyStopAfterPart) == 0;
    }
    // life of a tool and warming up ask for it too, in one channel alone
    const bool ends = anyProgram && !anyGoesOn;
    return {word("End with this part"),
            [this, ends] {
                context_.requests.press(QString("stop_after_part") + (ends ? " off" : ""));
            },
            Sign::None,
            live.connected() && !live.channels().empty(),
            ends,
            false,
            ends ? word("Parts go on: press again") : QString()};
}

// However it is left, the screen comes back with its first page.
void Overview::hideEvent(QHideEvent*) { page_ = Keys::Channels; }

// The kernel takes machine lock between programs and at rest only (ChannelRunner::take_keys):
// pressed before, it would act later and unseen.
bool Overview::takesMachineLock() const {
    const auto state = static_cast<ChannelState>(context_.live.channel(context_.channel).state);
    if (state != ChannelState::Reset && state != ChannelState::Ended) return false;
    for (const std::uint16_t number :
         context_.live.config().channel(context_.channel).axis_numbers())
        if (!context_.live.config().axis(number).on_spindle &&
            (context_.live.status().axes[number - 1u].flags & kMoving))
            return false;
    return true;
}

// Retrace is chosen in a hold (ChannelRunner::retrace); a direction that is chosen, or driven, can
// be turned round.
bool Overview::takesRetrace() const {
    const ChannelStatus& status = context_.live.channel(context_.channel);
    const auto state = static_cast<ChannelState>(status.state);
    const auto reason = static_cast<StopReason>(status.stop_reason);
    return state == ChannelState::Held ||
           (state == ChannelState::ProgramStop &&
            (reason == StopReason::SingleBlock || reason == StopReason::Retrace));
}

// How programs of the channel are worked off. What makes the machine do something else than the
// program says is asked for twice; that the axes go again as well.
void Overview::addControlKeys(std::vector<SoftKey>& keys, bool there) {
    const QString name = QString("L%1").arg(context_.channel);
    const std::uint32_t now = context_.live.channel(context_.channel).keys;
    const auto onOff = [&](const char* text, const char* command, std::uint32_t bit, bool can,
                           const QString& confirmOn = {}, const QString& confirmOff = {},
                           Sign sign = Sign::None) {
        const bool on = now & bit;
        keys.push_back({word(text).arg(name),
                        [this, words = QString("%1 %2=%3").arg(command, name, on ? "off" : "on")] {
                            context_.requests.press(words);
                        },
                        sign, can, on, false, on ? confirmOff : confirmOn});
    };
    if (page_ == Keys::MoreControl) {
        onOff(WORD("Path backwards %1"), "retrace", kKeyRetrace, there && takesRetrace(),
              word("Start goes back along the path: press again"), {}, Sign::Left);
        onOff(WORD("Ignore waits %1"), "ignore_waits", kKeyIgnoreWaits, there,
              word("%1 waits for nobody, nobody waits for it: press again").arg(name), {},
              Sign::Wait);
        keys.resize(9);
        keys.push_back({word("Back"), [this] { showKeys(Keys::Channels); }, Sign::Left});
        return;
    }
    onOff(WORD("Optional stop %1"), "optional_stop", kKeyOptionalStop, there);
    // the PLC has all levels; the key puts on the first one, and all off
    const bool skips = now & kAllBlockSkips;
    keys.push_back({word("Block skip %1").arg(name),
                    [this, words = QString("block_skip %1=%2").arg(name).arg(skips ? 0 : 1)] {
                        context_.requests.press(words);
                    },
                    Sign::None, there, skips});
    onOff(WORD("First part %1"), "first_part", kKeyFirstPart, there);
    onOff(WORD("Dry run %1"), "dry_run", kKeyDryRun, there,
          word("Other feeds than programmed: press again"));
    onOff(WORD("Machine lock %1"), "machine_lock", kKeyMachineLock, there && takesMachineLock(),
          word("The axes stand while the program runs: press again"),
          word("The axes move again: press again"));
    keys.push_back({word("More"), [this] { showKeys(Keys::MoreControl); }, Sign::Right, there,
                    (now & (kKeyRetrace | kKeyIgnoreWaits)) != 0});
}

}  // namespace polyturn::hmi
