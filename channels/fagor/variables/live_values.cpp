#include "channels/fagor/variables/live_values.hpp"

#include <cmath>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/statements/statement_text.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {
namespace {

// Is there a variable in the text of which `is` holds?
bool any_variable(const char* at, const char* end, auto&& is) {
    bool quoted = false;
    for (const char* p = at; p < end;) {
        if (*p == '"') quoted = !quoted;
        if (quoted || !is_capital(*p)) {
            ++p;
            continue;
        }
        const std::string_view name = letters_at(p, end);
        char axis = 0;
        if (const VariableRow* row = find_variable(name, axis); row && is(*row, axis)) return true;
        p += name.size();
    }
    return false;
}

}  // namespace

// Does a value of the machine stand in the text? Then the machine must have come here before
// anything of it is done.
bool mentions_live_value(const char* at, const char* end) {
    return any_variable(at, end, [](const VariableRow& row, char) { return row.live; });
}

// A program that reads where an axis really is (POS, APOS) means where it has come to, not how it
// swings there behind a move: it is waited for until the axis is quiet, a fifth of a second at
// most. What a probe has touched is already at rest.
bool axes_settle(Execution& x, const char* at, const char* end) {
    constexpr double kQuietMm = 3e-4;
    constexpr unsigned kQuietLooks = 10, kMostLooks = 200;  // one look a tick
    if (x.core.moves() == x.probe.settled_moves || x.core.moves() == x.probe.moves_at_touch ||
        x.core.reads_ahead())
        return false;
    bool reads = false, swings = false;
    any_variable(at, end, [&](const VariableRow& row, char axis) {
        if ((row.var != Var::Position && row.var != Var::PartPosition) || x.places.of(axis) < 0)
            return false;
        const unsigned machine_axis =
            x.core.view().axes[static_cast<std::size_t>(x.places.of(axis))].machine_axis;
        const auto command = x.core.port().axis_command(machine_axis),
                   measured = x.core.port().axis_measured(machine_axis);
        reads = reads || (command && measured);
        swings = swings || (command && measured && std::fabs(*command - *measured) > kQuietMm);
        return false;
    });
    if (!reads) return false;
    x.probe.quiet_looks = swings ? 0 : x.probe.quiet_looks + 1;
    if (x.probe.quiet_looks < kQuietLooks && ++x.probe.settle_looks < kMostLooks) return true;
    x.probe.settled_moves = x.core.moves();
    x.probe.quiet_looks = x.probe.settle_looks = 0;
    return false;
}

}  // namespace polyturn::channels::fagor
