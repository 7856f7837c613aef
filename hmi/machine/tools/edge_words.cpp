#include "hmi/machine/tools/edge_words.hpp"

#include <algorithm>
#include <cstring>
#include <tuple>

namespace polyturn::hmi {
namespace {

constexpr const char* kLengths[] = {"L1", "L2", "L3"};

// 0 the channel's own turret, 1 a magazine or spindle, 2 nowhere; -1 the turret of another channel.
int standing(const Live& live, unsigned channel, const ToolRow& row) {
    if (row.magazine == 0) return 2;
    const auto turret = [&](unsigned l) {
        return static_cast<std::int32_t>(
                   params::get(live.table(), params::pt_turret_magazine, l)) == row.magazine;
    };
    if (turret(channel)) return 0;
    return std::any_of(live.channels().begin(), live.channels().end(), turret) ? -1 : 1;
}

}  // namespace

bool usesEdges(const Live& live, unsigned channel) {
    return live.connected() && live.programLanguage(channel) == Dialect::Sinumerik;
}
bool toolsManaged(const Live& live) {
    return params::bit(live.table(), params::n2900_tool_m_config, 0);
}

std::vector<EdgeLine> edgeLines(const Live& live, unsigned channel) {
    using Order =
        std::tuple<int, std::int32_t, std::int32_t, std::string, std::int32_t, std::int32_t>;
    std::vector<std::pair<Order, std::int32_t>> tools;
    const auto unit =
        static_cast<std::int32_t>(params::get(live.table(), params::pt_tool_unit, channel));
    for (std::size_t i = 0; i < kTools; ++i) {
        const ToolRow& row = live.tools().rows[i];
        const int where = row.used ? standing(live, channel, row) : -1;
        if (where < 0 || (row.unit != 0 && row.unit != unit)) continue;
        const auto number = static_cast<std::int32_t>(i + 1);
        tools.push_back({{where, row.magazine, row.pot,
                          std::string(row.name.data(), ::strnlen(row.name.data(), row.name.size())),
                          row.duplo, number},
                         number});
    }
    std::sort(tools.begin(), tools.end());
    const ToolEdgeTable& table = live.edges();
    const auto* const end = table.edges.data() + std::min<std::size_t>(table.count, kToolEdges);
    std::vector<EdgeLine> out;
    for (const auto& [order, number] : tools) {  // edges stand in the order of tool and number
        const auto* at = std::lower_bound(
            table.edges.data(), end, number,
            [](const ToolEdge& edge, std::int32_t tool) { return edge.tool < tool; });
        if (at == end || at->tool != number) out.push_back({number, 1});
        for (; at != end && at->tool == number; ++at) out.push_back({number, at->number});
    }
    return out;
}

const ToolEdge* edgeOf(const Live& live, EdgeLine line) {
    const ToolEdgeTable& table = live.edges();
    const auto* const end = table.edges.data() + std::min<std::size_t>(table.count, kToolEdges);
    const auto* const at = std::lower_bound(
        table.edges.data(), end, line, [](const ToolEdge& edge, const EdgeLine& wanted) {
            return edge.tool != wanted.tool ? edge.tool < wanted.tool : edge.number < wanted.edge;
        });
    return at != end && at->tool == line.tool && at->number == line.edge ? at : nullptr;
}

double edgeValue(const Live& live, EdgeLine line, int dp) {
    const ToolEdge* edge = edgeOf(live, line);
    return edge && dp > 0 && dp < static_cast<int>(edge->dp.size())
               ? edge->dp[static_cast<std::size_t>(dp)]
               : 0.0;
}

unsigned planeNow(const Live& live, unsigned channel) {
    const auto& codes = live.view(channel).picture.codes;
    const QStringList all =
        QString::fromUtf8(codes.data(), static_cast<int>(::strnlen(codes.data(), codes.size())))
            .split(' ');
    return all.contains("G17") ? 0 : all.contains("G19") ? 2 : 1;
}

int placeOfLength(const Live& live, unsigned channel, EdgeLine line, int length) {
    if (length < 0 || length > 2) return -1;
    constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    const int geometry =
        axes_of_edge(live.table(), channel, static_cast<int>(edgeValue(live, line, kDpType)),
                     planeNow(live, channel))[static_cast<std::size_t>(length)];
    const AxisConfig* axis =
        geometry < 0 ? nullptr : find_axis(live.config(), channel, kRoles[geometry]);
    return axis && axis->slot != kNoSlot ? axis->slot : -1;
}

int lengthOf(int dp) {
    return dp >= kDpBase ? dp - kDpBase : dp >= kDpWear ? dp - kDpWear : dp - kDpLength;
}
bool isLength(int dp) { return dp >= kDpLength && lengthOf(dp) >= 0 && lengthOf(dp) <= 2; }

double sumOfLength(const Live& live, EdgeLine line, int length) {
    double sum = 0;
    for (const int from : {kDpLength, kDpWear, kDpBase})
        sum += edgeValue(live, line, from + length);
    return sum;
}

QString edgeParameterTitle(int dp) {
    if (dp == kDpType) return word("Type");
    if (dp == kDpTip) return word("Tip");
    if (dp == kDpRadius) return word("Radius");
    if (dp == kDpWearRadius) return word("Wear R");
    if (dp == kDpBaseRadius) return word("Base R");
    if (!isLength(dp)) return QString("DP%1").arg(dp);
    const QString length = kLengths[lengthOf(dp)];
    return dp >= kDpBase   ? QString("%1 %2").arg(word("Base"), length)
           : dp >= kDpWear ? QString("%1 %2").arg(word("Wear"), length)
                           : length;
}

QString edgeTitle(const Live& live, EdgeLine line) {
    const ToolRow* row = toolOf(live, line.tool);
    return QString("%1  D%2")
        .arg(row ? toolName(*row, line.tool) : QString("T%1").arg(line.tool))
        .arg(line.edge);
}

}  // namespace polyturn::hmi
