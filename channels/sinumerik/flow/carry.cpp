// What a program leaves to the next one in its channel: R parameters (sinumerik_part3 11.5), the G
// commands that MD20152 keeps (2), static synchronized actions (8), outputs, texts that WRITE has
// made, tool environments, curve tables, the parts of frames that the store does not keep, the
// count of parts. Everything else begins as the machine data say.
#include "channels/sinumerik/flow/carry.hpp"

#include <algorithm>
#include <iterator>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/flow/program_begin.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

struct Left {
    std::vector<Value> r;
    std::array<std::uint8_t, kGroups> active{};
    std::vector<SynchronizedAction> actions;
    std::map<std::string, std::optional<std::string>, std::less<>> files;
    std::map<std::string, CalendarTime, std::less<>> times;
    std::map<std::string, std::array<double, 3>, std::less<>> environments;
    CurveTables tables;
    std::map<std::string, Value, std::less<>> outputs;  // $A_OUT
    std::map<int, FrameValue> settable, grinding;
    double parts = 0;
};

}  // namespace

std::any carry(const Execution& x) {
    auto left = std::make_shared<Left>();
    left->r = x.names.r->cells;
    left->active = x.modal.active;
    std::copy_if(x.actions.all.begin(), x.actions.all.end(), std::back_inserter(left->actions),
                 [](const SynchronizedAction& one) { return one.is_static; });
    left->files = x.texts.written;
    left->times = x.texts.written_at;
    left->environments = x.tools.environments;
    left->tables = x.curve_tables;
    for (const auto& [name, value] : x.names.system)
        if (name.starts_with("$A_OUT[")) left->outputs[name] = value;
    left->settable = x.frames.settable;
    left->grinding = x.frames.grinding;
    left->parts = x.shown.parts;
    return left;
}

void take_carry(Execution& x, const std::any& before, bool after_reset) {
    const auto* held = std::any_cast<std::shared_ptr<Left>>(&before);
    if (!held || !*held) return;
    const Left& last = **held;
    // MD28050 may have changed
    std::copy_n(last.r.begin(), std::min(last.r.size(), x.names.r->cells.size()),
                x.names.r->cells.begin());
    x.actions.all = last.actions;
    x.texts.written = last.files;
    x.texts.written_at = last.times;
    x.tools.environments = last.environments;
    x.curve_tables = last.tables;
    x.names.system.insert(last.outputs.begin(), last.outputs.end());
    if (after_reset) look_at_outputs(x);
    x.frames.settable = last.settable;
    x.frames.grinding = last.grinding;
    x.shown.parts = last.parts;
    if (std::any_of(x.settings.g_keep.begin(), x.settings.g_keep.end(),
                    [](bool keeps) { return keeps; })) {
        x.modal.active = last.active;
        reset_modal(x);
    }
    (void)g_zero(x, *find_g(8, x.modal.active[8]));  // with all parts of its frame; nothing moves
    use_frame(x);
    x.modal.pending_zero = {};
}

// Tools and their lengths are the program's own data here; zeros are the operator's.
bool offsets_changed(Execution& x) {
    if (x.core.reads_ahead() || x.core.transformed()) return false;
    x.core.change_offsets([] {});
    x.run.state_changed = true;
    return true;
}
}  // namespace polyturn::channels::sinumerik
