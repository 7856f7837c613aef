#include "channels/fanuc/grammar/program_hooks.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/system_variables.hpp"
#include "channels/fanuc/macro/system_writes.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

// What ROUND rounds to within an address: the least increment of it (fanuc_lathe 6.4).
double rounding_step(const Execution& x, char address) {
    constexpr std::uint32_t kLengths = letter_set("IJKREF");
    if (address < 'A' || address > 'Z') return 1.0;
    const auto letter = static_cast<std::size_t>(address - 'A');
    const int place = x.vocabulary.absolute_axis[letter] >= 0
                          ? x.vocabulary.absolute_axis[letter]
                          : x.vocabulary.incremental_axis[letter];
    if (place < 0 && !(kLengths & letter_bit(address))) return 1.0;
    if (address == 'F')
        return x.core.path.feed_mode == FeedMode::PerRevolution ? (x.modal.input.inch ? 1e-6 : 1e-4)
                                                                : 1.0;
    const ChannelAxis& axis = x.core.view().axes[place < 0 ? 0 : static_cast<std::size_t>(place)];
    return axis.increment * (x.modal.input.inch && !axis.rotary ? 0.1 : 1.0);
}

}  // namespace

// The scanner's question: a value behind an address.
ScanHook::Read ProgramHooks::read_value(const char*& at, const char* end, double& value) {
    Execution& x = *x_;
    if (!x.settings.policy.macro.expressions) {
        x.reading.pending_fault = {Alarm::NotBuilt,       0,           0.0, 0.0,
                                   "expressions in mefi", std::nullopt};
        x.reading.has_pending_fault = true;
        x.words.culprit.column = static_cast<std::uint32_t>(at - x.text.line.data()) + 1;
        x.words.culprit.length = 1;
        return Read::Fault;
    }
    // The word that is being read follows the last one counted.
    const char address =
        x.block.count < Block::kMaxWords ? x.block.words[x.block.count].address : '\0';
    x.macro.expression.round_to(
        !x.settings.policy.words.rounds_to_increment ? 1.0 : rounding_step(x, address));
    const Expression::Status status = x.macro.expression.operand(at, end, value);
    x.macro.expression.round_to(1.0);
    switch (status) {
        case Expression::Status::Ok:
            // whole codes (fanuc_lathe 6.1)
            if (x.settings.policy.words.rounds_codes &&
                (address == 'G' || address == 'M' || address == 'T'))
                value = std::round(value);
            return is_null(value) ? Read::Null : Read::Value;
        case Expression::Status::NeedsBarrier:
            return Read::NeedsBarrier;
        case Expression::Status::Fault:
            break;
    }
    const ExpressionFault& f = x.macro.expression.fault();
    x.reading.pending_fault = {f.alarm, 0, f.value, 0.0, f.detail, std::nullopt};
    x.reading.has_pending_fault = true;
    x.words.culprit.column = static_cast<std::uint32_t>(f.at - x.text.line.data()) + 1;
    x.words.culprit.length = 1;
    return Read::Fault;
}

bool ProgramHooks::block_skip(unsigned number) { return x_->core.port().block_skip(number); }

bool ProgramHooks::skip_sign_waits() { return x_->settings.skip_sign_drains && !x_->run.fresh; }

std::size_t ProgramHooks::axis_name(const char* at, const char* end, int& axis) {
    Execution& x = *x_;
    const MachineView& view = x.core.view();
    std::size_t longest = 0;
    const auto look = [&](std::string_view name, int place) {
        if (name.size() < 2 || name.size() <= longest ||
            static_cast<std::size_t>(end - at) <= name.size())
            return;
        bool same = true;
        for (std::size_t k = 0; k < name.size(); ++k)
            same = same && (at[k] == name[k] || at[k] == name[k] + 32);
        // A name that ends in a digit must be followed by '='.
        if (same && is_digit(name.back()) && at[name.size()] != '=') same = false;
        if (same) {
            longest = name.size();
            axis = place;
        }
    };
    for (unsigned i = 0; i < view.axis_count; ++i) look(view.axes[i].name, static_cast<int>(i));
    for (std::size_t i = 0; i < x.settings.spindle_addresses.size(); ++i)
        look(x.settings.spindle_addresses[i].name, kSpindleWord + static_cast<int>(i));
    for (std::size_t i = 0; i < x.settings.spindle_names.size(); ++i)
        look(x.settings.spindle_names[i].name, kNamedSpindle + static_cast<int>(i));
    return longest;
}

VariableStatus ProgramHooks::read_system(std::int64_t number, double& value) {
    return fanuc::read_system(*x_, number, value);
}

VariableStatus ProgramHooks::write_system(std::int64_t number, double value) {
    return fanuc::write_system(*x_, number, value);
}

bool ProgramHooks::barrier_fresh() { return x_->run.fresh; }

// A variable of all channels is a live value: another program may have written it.
VariableStatus ProgramHooks::shared_variable(std::int64_t number, bool write, double& value) {
    Execution& x = *x_;
    double* const outside = x.core.port().shared_variables();
    if (!write && !x.run.fresh && !x.reading.inputs_fresh) return VariableStatus::NeedsBarrier;
    double& cell = outside ? outside[number - 100]
                           : (*x.core.view().shared)[static_cast<std::size_t>(number - 100)];
    if (write) {
        x.macro.variables.note_cell(cell);
        cell = value;
    } else {
        value = cell;
    }
    return VariableStatus::Ok;
}

}  // namespace polyturn::channels::fanuc
