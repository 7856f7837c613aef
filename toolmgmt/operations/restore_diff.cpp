#include "toolmgmt/operations/restore_diff.hpp"

#include <cmath>
#include <set>

#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::toolmgmt {
namespace {

struct Collector {
    const StoreValues& now;
    StoreValues& wanted;
    std::vector<Change> out;

    void number(const Key& key) {
        const double* is = number_at(wanted, key);
        Change change;
        if (is && change_to(now, key, *is, {}, false, change)) out.push_back(std::move(change));
    }
    void value(const Key& key, double number) {
        Change change;
        if (change_to(now, key, number, {}, false, change)) out.push_back(std::move(change));
    }
    void text(const Key& key, std::string_view words) {
        Change change;
        if (change_to(now, key, 0, words, true, change)) out.push_back(std::move(change));
    }
};

void parameters(Collector& all) {
    for (const params::Row& row : params::rows())
        for (unsigned instance = 1; instance <= params::instances(row.scope); ++instance)
            for (int element = 0; element < row.array; ++element) {
                const Key key{Kind::Parameter, static_cast<std::int32_t>(instance), element, 0,
                              std::string(row.number)};
                if (row.type != params::Type::Text)
                    all.number(key);
                else
                    all.text(key, params::text_at(
                                      all.wanted.parameters,
                                      row.first_slot +
                                          static_cast<std::size_t>(instance - 1) * row.array +
                                          static_cast<std::size_t>(element)));
            }
}

void channel(Collector& all, std::int32_t l) {
    for (int number = 1; number < static_cast<int>(kOffsets); ++number)
        for (int table = 0; table < 3; ++table)
            for (int field = 0; field < 5; ++field)
                if (table == 0 || field < 4)
                    all.number({Kind::Offset, l, number, table * 256 + field, {}});
    for (int row = 0; row < static_cast<int>(kWorkZeros); ++row)
        for (int place = 0; place < static_cast<int>(kChannelAxes); ++place)
            all.number({Kind::WorkZero, l, row, place, {}});
    for (int index = 0; index < static_cast<int>(kPersistentVariables); ++index)
        all.number({Kind::Variable, l, index, 0, {}});
}

void tools(Collector& all) {
    for (std::int32_t n = 1; n <= static_cast<std::int32_t>(kTools); ++n) {
        const ToolRow& is = *all.wanted.tool(n);
        const ToolRow& was = *all.now.tool(n);
        if (!is.used && !was.used) continue;
        for (const ToolField& field : tool_fields()) {
            const Key key{Kind::Tool, 0, n, 0, std::string(field.name)};
            if (field.is_text())
                all.text(key, tool_text(is, field));
            else
                all.value(key, tool_number(is, field));
        }
        if (is.used != was.used)
            all.value({Kind::Tool, 0, n, 0, "exists"}, is.used ? 1.0 : std::nan(""));
    }
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (const StoreValues* one : {&all.now, static_cast<const StoreValues*>(&all.wanted)})
        for (std::size_t i = 0; i < one->edges.count; ++i)
            edges.insert({one->edges.edges[i].tool, one->edges.edges[i].number});
    for (const auto& [tool, number] : edges) {
        const ToolEdge* edge = find_edge(all.wanted, tool, number);
        for (int k = 1; k < 36; ++k)
            all.value({Kind::Edge, tool, number, k, {}},
                      edge ? edge->dp[static_cast<std::size_t>(k)] : 0.0);
    }
}

}  // namespace

std::vector<Change> changes_between(const StoreValues& now, StoreValues& wanted) {
    Collector all{now, wanted, {}};
    parameters(all);
    for (std::int32_t l = 1; l <= static_cast<std::int32_t>(kMaxChannels); ++l) channel(all, l);
    for (int counter = 0; counter < kCounters; ++counter)
        all.number({Kind::Counter, 0, counter, 0, {}});
    tools(all);
    for (const auto& [key, cell] : wanted.cells) {
        if (key.kind == Kind::Setting) continue;
        if (cell.is_text)
            all.text(key, cell.text);
        else
            all.value(key, cell.number);
    }
    for (const auto& [key, cell] : now.cells) {
        if (key.kind == Kind::Setting || wanted.cells.contains(key)) continue;
        if (cell.is_text)
            all.text(key, {});
        else
            all.value(key, std::nan(""));
    }
    return std::move(all.out);
}

const char* section_of(Kind kind) {
    static constexpr const char* kNames[] = {
        "",      "parameters", "offsets", "zeros", "variables",  "counters", "positions", "tools",
        "tools", "places",     "tools",   "users", "dimensions", "pallets",  "settings"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace polyturn::toolmgmt
