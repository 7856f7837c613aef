// What the screen of tools asks of the store, and its keys.
#include <QApplication>
#include <QJsonArray>
#include <algorithm>
#include <limits>

#include "hmi/screens/tools/tools.hpp"

namespace polyturn::hmi {

void Tools::carry(std::int32_t tool) {
    picture_->carried = tool;
    picture_->focused = true;
    if (const ToolRow* row = toolOf(context_.live, tool); row && row->magazine) {
        picture_->show(row->magazine);
        picture_->choose(row->pot);
    } else if (const ToolPlace* place = picture_->chosen())
        picture_->choose(place->pot);
    tool_ = tool;
    refresh();
}

void Tools::putDown(const ToolPlace* place) {
    const std::int32_t tool = std::exchange(picture_->carried, 0);
    const ToolRow* row = toolOf(context_.live, tool);
    if (!row || !place) return refresh();
    if (place->tool == tool) return refresh();  // back where it was
    const QString name = toolName(*row, tool),
                  where = placeText(context_.live, place->magazine, place->pot);
    context_.requests.store({{"do", row->magazine ? "tools.move" : "tools.load"},
                             {"tool", tool},
                             {"magazine", place->magazine},
                             {"pot", place->pot}},
                            [this, name, where](const Answer& answer) {
                                if (answer.ok)
                                    context_.tell(word("%1 stands in %2").arg(name, where),
                                                  Told::Good);
                            });
    refresh();
}

// Let go over a place: it goes there; over the list: out of the magazine; anywhere else: nothing.
void Tools::dropped(std::int32_t tool, const QPoint& at) {
    picture_->carried = tool;
    if (const ToolPlace* place = picture_->placeAt(picture_->mapFromGlobal(at))) {
        picture_->choose(place->pot);
        return putDown(place);
    }
    picture_->carried = 0;
    tool_ = tool;
    if (const ToolRow* row = chosen();
        row && row->magazine && list_->rect().contains(list_->mapFromGlobal(at)))
        unload();
    refresh();
}

void Tools::unload() {
    const ToolRow* row = chosen();
    if (!row) return;
    const QString name = toolName(*row, tool_);
    context_.requests.store({{"do", "tools.unload"}, {"tool", tool_}},
                            [this, name](const Answer& answer) {
                                if (answer.ok)
                                    context_.tell(word("%1 is taken out").arg(name), Told::Good);
                            });
}

// Whose offsets a tool uses: the channel of the turret in which it stands, or the only one there
// is; 0: that is not known. Edges are the tool's own: where it has them and no offset, each channel
// means the same.
unsigned Tools::channelOf(const ToolRow& row) const {
    const auto& all = context_.live.channels();
    for (const unsigned l : all)
        if (row.magazine &&
            static_cast<std::int32_t>(
                params::get(context_.live.table(), params::pt_turret_magazine, l)) == row.magazine)
            return l;
    const auto number = static_cast<std::int32_t>(&row - context_.live.tools().rows.data() + 1);
    const ToolEdgeTable& edges = context_.live.edges();
    const bool ownEdges =
        row.h_cell == 0 &&
        std::any_of(edges.edges.begin(),
                    edges.edges.begin() + static_cast<std::ptrdiff_t>(edges.count),
                    [&](const ToolEdge& edge) { return edge.tool == number; });
    return all.size() == 1 || (ownEdges && !all.empty()) ? all.front() : 0;
}

// A new insert: its life begins, it is not worn any more, and the wear of its offset is none. Of a
// tool outside the turrets nobody knows in which channel that offset is: the same number of another
// one may be that of a tool which works.
void Tools::newInsert() {
    const ToolRow* row = chosen();
    if (!row) return;
    const QString name = toolName(*row, tool_);
    const unsigned channel = channelOf(*row);
    QJsonObject request{{"do", "life.reset"}, {"tools", QJsonArray{tool_}}};
    if (channel) request.insert("channel", static_cast<int>(channel));
    context_.requests.store(request, [this, name, channel](const Answer& answer) {
        if (answer.ok)
            context_.tell(
                (channel
                     ? word("%1 has a new insert: life and wear begin anew")
                     : word(
                           "%1 has a new insert: its life begins anew, the wear of its offset stays"))
                    .arg(name),
                Told::Good);
        lookAt_ = 0;
    });
}

void Tools::setField(const char* field, const QString& value) {
    if (!tool_) return;
    context_.requests.store(
        {{"do", "tools.set"}, {"tool", tool_}, {"fields", QJsonObject{{field, value}}}},
        [this](const Answer& answer) {
            if (answer.ok) context_.tell(word("Written"), Told::Good);
        });
}

void Tools::addTool() {
    context_.requests.store(
        {{"do", "tools.add"}, {"fields", QJsonObject{}}}, [this](const Answer& answer) {
            if (!answer.ok) return;
            tool_ = added_ = answer.object.value("tool").toInt();
            context_.tell(word("Tool %1 is new: enter what it is").arg(tool_), Told::Good);
            showPage(Page::Data);
            table_->choose(0);  // its name
        });
}

// The report of lives or the pallets, asked for again every two seconds while they are shown.
void Tools::look() {
    lookAt_ = QDateTime::currentMSecsSinceEpoch() + 2'000;
    if (page_ == Page::Pallets) {
        context_.requests.store(
            {{"do", "pallets.list"}},
            [this](const Answer& answer) {
                whyNoPallets_ = answer.ok ? QString() : answer.text;
                pallets_.clear();
                for (const auto& one : answer.object.value("pallets").toArray()) {
                    const QJsonObject row = one.toObject();
                    pallets_.push_back({row.value("row").toInt(), row.value("station").toString(),
                                        row.value("program").toString(),
                                        row.value("pallet").toDouble()});
                }
                if (page_ == Page::Pallets) fillPallets();
            },
            true);
        return;
    }
    context_.requests.store(
        {{"do", "life.report"}},
        [this](const Answer& answer) {
            if (!answer.ok) return;
            life_.clear();
            const QString first =
                answer.object.value("stops_first").toObject().value("group").toString();
            for (const auto& one : answer.object.value("groups").toArray()) {
                const QJsonObject group = one.toObject();
                for (const auto& entry : group.value("tools").toArray()) {
                    const QJsonObject tool = entry.toObject();
                    LifeLine line;
                    line.tool = tool.value("tool").toInt();
                    line.group = group.value("group").toString();
                    line.unit = lifeUnit(toolOf(context_.live, line.tool)
                                             ? toolOf(context_.live, line.tool)->life_kind
                                             : 0);
                    line.left = tool.value("left").toDouble(-1);
                    line.first = line.group == first && !first.isEmpty();
                    line.parts = group.value("parts_left").toDouble(-1);
                    line.minutes = group.value("minutes_left").toDouble(-1);
                    life_.push_back(line);
                }
            }
            // T3 before T11; names of groups that are no numbers come last, as the report has them.
            const auto number = [](const LifeLine& line) {
                bool good = false;
                const qlonglong read = line.group.mid(line.group.startsWith('T')).toLongLong(&good);
                return good ? read : std::numeric_limits<qlonglong>::max();
            };
            std::stable_sort(life_.begin(), life_.end(), [&](const LifeLine& a, const LifeLine& b) {
                return number(a) < number(b);
            });
            firstToStop_ = first.isEmpty()
                               ? QString()
                               : word("First to stop the machine: %1; parts until then: %2")
                                     .arg(first)
                                     .arg(answer.object.value("stops_first")
                                              .toObject()
                                              .value("parts_left")
                                              .toDouble(),
                                          0, 'f', 0);
            if (page_ == Page::Life) fillLife();
        },
        true);
}

// The chosen tool where its edges or its offset are entered.
void Tools::toOffsets() {
    const ToolRow* tool = chosen();
    if (!tool) return;
    if (const unsigned turret = channelOf(*tool)) context_.choose(turret);
    const auto edge = static_cast<std::size_t>(std::max(0, table_->row() - shownFields()));
    context_.toolOfOffsets = tool_;
    context_.edgeOfOffsets = edge < edgeRows_.size() ? edgeRows_[edge].first.edge : 1;
    context_.show(kOffsetsScreen);
}

std::vector<SoftKey> Tools::keys() {
    const bool there = context_.live.connected();
    const ToolRow* tool = there ? chosen() : nullptr;
    const auto page = [this](Page wanted, const QString& text) {
        return SoftKey{text, [this, wanted] { showPage(wanted); }, Sign::None, true,
                       page_ == wanted};
    };
    std::vector<SoftKey> keys{page(Page::Magazine, word("Magazines")),
                              page(Page::Data, word("Tool data")), page(Page::Life, word("Life")),
                              page(Page::Pallets, word("Pallets")),
                              page(Page::Presetter, word("Presetter"))};
    const unsigned turret = tool ? channelOf(*tool) : 0;
    const QString name = tool ? toolName(*tool, tool_) : QString();
    const SoftKey insert{word("New insert"),
                         [this] { newInsert(); },
                         Sign::Good,
                         tool != nullptr,
                         false,
                         false,
                         turret ? word("Life and wear to 0: press again")
                                : word("Life to 0, wear stays: press again"),
                         {},
                         QString("%1 L%2").arg(tool_).arg(turret),
                         name};
    const bool locked = tool && (tool->state & kToolLocked);
    const SoftKey lock{locked ? word("Release tool") : word("Lock tool"),
                       [this, locked] { setField("locked", locked ? "0" : "1"); }, Sign::Lock,
                       tool != nullptr, locked};
    switch (page_) {
        case Page::Magazine: {
            const bool carrying = picture_->carried != 0, stands = tool && tool->magazine;
            keys.push_back({carrying ? word("Put it here")
                            : stands ? word("Move")
                                     : word("Load"),
                            [this, carrying] {
                                if (carrying)
                                    putDown(picture_->chosen());
                                else
                                    carry(tool_);
                            },
                            Sign::Right, tool != nullptr && picture_->chosen() != nullptr,
                            carrying});
            keys.push_back({word("Unload"), [this] { unload(); }, Sign::Up, stands && !carrying});
            keys.push_back(insert);
            keys.push_back(lock);
            keys.push_back({word("Filter"), [this] { nextFilter(); }, Sign::None, true,
                            filter_ != Filter::All});
            break;
        }
        case Page::Data: {
            keys.push_back({word("New tool"), [this] { addTool(); }, Sign::None, there});
            keys.push_back({word("Delete tool"),
                            [this] {
                                context_.requests.store({{"do", "tools.delete"}, {"tool", tool_}});
                            },
                            Sign::Bin,
                            tool != nullptr,
                            false,
                            true,
                            word("It is gone: press again"),
                            {},
                            QString::number(tool_),
                            name});
            keys.push_back(insert);
            keys.push_back(lock);
            const ToolPlace* place =
                tool ? placeOf(context_.live, tool->magazine, tool->pot) : nullptr;
            const bool shut = place && (place->state & kPlaceLocked);
            const std::int32_t magazine = place ? place->magazine : 0, pot = place ? place->pot : 0;
            keys.push_back({shut ? word("Release place") : word("Lock place"),
                            [this, magazine, pot, shut] {
                                context_.requests.store({{"do", "tools.place"},
                                                         {"magazine", magazine},
                                                         {"pot", pot},
                                                         {"locked", shut ? 0 : 1}});
                            },
                            Sign::Lock, place != nullptr, shut});
            // Of a row that is entered where offsets are.
            if (rowOfOffsets())
                keys.back() = {word("To the offsets"), [this] { toOffsets(); }, Sign::Offsets,
                               there};
            break;
        }
        case Page::Life:
            keys.resize(7);
            keys.push_back(insert);
            keys.push_back(lock);
            break;
        case Page::Pallets: {
            const int row = table_->row() < static_cast<int>(pallets_.size())
                                ? pallets_[static_cast<std::size_t>(table_->row())].row
                                : 0;
            keys.push_back({taken_ ? word("Exchange with it") : word("Exchange"),
                            [this, row] {
                                if (!taken_) return void(taken_ = row);
                                const int from = std::exchange(taken_, 0);
                                if (from != row)
                                    context_.requests.store(
                                        {{"do", "pallets.exchange"}, {"row", from}, {"with", row}},
                                        [this](const Answer&) { lookAt_ = 0; });
                            },
                            Sign::Right, row > 0, taken_ != 0});
            break;
        }
        case Page::Presetter:
            presetter_->addKeys(keys);
            break;
    }
    return keys;
}

}  // namespace polyturn::hmi
