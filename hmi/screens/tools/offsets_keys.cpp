// The soft keys of offsets and zeros: what they ask before they act, and of which value.
#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/tools/offsets.hpp"

namespace polyturn::hmi {

std::vector<SoftKey> Offsets::keys() {
    const bool ready =
        context_.live.connected() && pad_->entry().has_value() && chosen().has_value();
    const auto value = chosen();
    const OffsetEntries::Undo::Change* last = entries_.newest();
    const bool empty = pad_->text().isEmpty(), placed = value.has_value() && value->place >= 0;
    std::vector<SoftKey> keys{
        {values_.edged() ? word("Tool edges") : word("Tool offsets"),
         [this] {
             showParts(false);
             showZeros(false);
         },
         Sign::Tools, true, !zeros_ && !partsShown_},
        {word("Work zeros"),
         [this] {
             showParts(false);
             showZeros(true);
         },
         Sign::Offsets, true, zeros_ && !partsShown_},
        {word("Measured parts"), [this] { showParts(true); }, Sign::Parameters, true, partsShown_},
        {}};
    if (partsShown_) {
        parts_->addKeys(keys);
        return keys;
    }
    // «offset L1 3 wear X», with what is typed: another one of them is another question.
    const QStringList words = value ? value->words.split(' ') : QStringList();
    const auto brief = [](const QStringList& of) {
        return of.size() < 4 ? QString()
               : of[0] == "edge"
                   ? QString("%1 %2 %3").arg(of[2], of[3], edgeParameterTitle(of[4].mid(2).toInt()))
                   : QString("%1 %2 %3").arg(of[1], of[2], of.last());
    };
    const QString subject = value ? value->words + "=" + pad_->text() : QString(),
                  object = brief(words);
    const QString asks = !zeros_ ? word("Enters what was touched: press again")
                         : entries_.probe()
                             ? word("Probe is offset %1: press again").arg(entries_.probe())
                             : word("Without a probe offset: press again");
    keys.back() = {zeros_ ? word("Workpiece setter") : word("Tool setter"),
                   [this] { touched(); },
                   Sign::None,
                   context_.live.connected() && value.has_value(),
                   false,
                   false,
                   asks,
                   {},
                   subject,
                   object};
    if (empty && !zeros_)
        keys.push_back({word("Relative input"),
                        [this] {
                            if (const auto now = chosen()) entries_.relativeInput(*now);
                        },
                        Sign::None,
                        context_.live.connected() && placed,
                        false,
                        false,
                        word("Enters the relative counter: press again"),
                        {},
                        subject,
                        object});
    else
        keys.push_back({word("Input"), [this] { pad_->enter(false); }, Sign::None, ready});
    if (empty && values_.byEdges())
        keys.push_back({word("Base lengths"),
                        [this] {
                            base_ = !base_;
                            build();
                            table_->choose(table_->row(), values_.firstColumn());
                            refresh();
                        },
                        Sign::None, context_.live.connected(), base_});
    else
        keys.push_back({word("+ Input"), [this] { pad_->enter(true); }, Sign::None, ready});
    if (zeros_)
        keys.push_back({pad_->text().isEmpty() ? word("Zero here") : word("This is here"),
                        [this] { zeroHere(); },
                        Sign::None,
                        value.has_value() && (pad_->text().isEmpty() || ready),
                        false,
                        false,
                        word("Sets the zero: press again"),
                        {},
                        subject,
                        object});
    else if (empty)
        keys.push_back({word("Relative zero"), [this] { entries_.relativeZero(); }, Sign::None,
                        context_.live.connected()});
    else
        keys.push_back({word("Measured"),
                        [this] { measure(); },
                        Sign::None,
                        ready && value->place >= 0 && !value->wear(),
                        false,
                        false,
                        word("Tip is at this measure: press again"),
                        {},
                        subject,
                        object});
    keys.push_back({word("Undo"),
                    [this] { entries_.undo(); },
                    Sign::Undo,
                    last != nullptr,
                    false,
                    false,
                    {},
                    {},
                    {},
                    last ? brief(last->where.words.split(' ')) : QString()});
    if (values_.byEdges()) addEdgeKeys(keys);
    addPatternKey(keys);
    return keys;
}

void Offsets::addEdgeKeys(std::vector<SoftKey>& keys) {
    const auto value = chosen();
    keys.push_back({word("New edge"),
                    [this] {
                        if (const auto now = chosen()) entries_.newEdge(*now);
                    },
                    Sign::None, context_.live.connected() && value.has_value()});
    const QString edge =
        value && value->ofEdge() ? edgeTitle(context_.live, value->edge) : QString();
    keys.push_back({word("Delete edge"),
                    [this] {
                        const auto now = chosen();
                        if (now && mayDelete()) entries_.deleteEdge(*now);
                    },
                    Sign::Bin,
                    mayDelete(),
                    false,
                    false,
                    word("Its values go: press again"),
                    {},
                    edge,
                    value ? QString("D%1").arg(value->edge.edge) : QString()});
}

// The pattern menu of the fanuc family's macros: the program O9500 builds it, and its dialogue
// comes up.
void Offsets::addPatternKey(std::vector<SoftKey>& keys) {
    if (keys.size() < 10 &&
        params::get_text(context_.live.table(), params::pt_language, context_.channel) == "fanuc")
        keys.push_back(
            {word("Pattern menu"),
             [this] {
                 // the mode is the operator's
                 if (static_cast<ChannelMode>(context_.live.channel(context_.channel).mode) ==
                     ChannelMode::Auto)
                     return context_.tell(
                         word("L%1 is in automatic mode: choose Jog or MDI").arg(context_.channel),
                         Told::Refused);
                 context_.requests.press(QString("hand_key L%1 M98 P9500").arg(context_.channel));
             },
             Sign::Note,
             context_.live.connected() &&
                 static_cast<ChannelState>(context_.live.channel(context_.channel).state) !=
                     ChannelState::Running});
}

}  // namespace polyturn::hmi
