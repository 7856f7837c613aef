// What a program leaves to the next one in its channel: R parameters (sinumerik_part3 11.5), the G
// commands that MD20152 keeps (2), static synchronized actions (8), outputs, texts that WRITE has
// made, tool environments, curve tables, the parts of frames that the store does not keep, the
// count of parts. Everything else begins as the machine data say.
#include <algorithm>
#include <iterator>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

struct Interpreter::Left {
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

std::any Interpreter::carry() const {
    auto left = std::make_shared<Left>();
    left->r = r_->cells;
    left->active = modal_.active;
    std::copy_if(actions_.begin(), actions_.end(), std::back_inserter(left->actions),
                 [](const SynchronizedAction& one) { return one.is_static; });
    left->files = written_files_;
    left->times = written_at_;
    left->environments = tool_environments_;
    left->tables = curve_tables_;
    for (const auto& [name, value] : written_system_)
        if (name.starts_with("$A_OUT[")) left->outputs[name] = value;
    left->settable = settable_parts_;
    left->grinding = grinding_frames_;
    left->parts = parts_;
    return left;
}

void Interpreter::take_carry(const std::any& before, bool after_reset) {
    const auto* held = std::any_cast<std::shared_ptr<Left>>(&before);
    if (!held || !*held) return;
    const Left& last = **held;
    // MD28050 may have changed
    std::copy_n(last.r.begin(), std::min(last.r.size(), r_->cells.size()), r_->cells.begin());
    actions_ = last.actions;
    written_files_ = last.files;
    written_at_ = last.times;
    tool_environments_ = last.environments;
    curve_tables_ = last.tables;
    written_system_.insert(last.outputs.begin(), last.outputs.end());
    if (after_reset) look_at_outputs();
    settable_parts_ = last.settable;
    grinding_frames_ = last.grinding;
    parts_ = last.parts;
    if (std::any_of(settings_.g_keep.begin(), settings_.g_keep.end(),
                    [](bool keeps) { return keeps; })) {
        modal_.active = last.active;
        reset_modal();
    }
    (void)g_zero(*find_g(8, modal_.active[8]));  // with all parts of its frame; nothing moves
    use_frame();
    modal_.pending_zero = {};
}

}  // namespace polyturn::channels::sinumerik
