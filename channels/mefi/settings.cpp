#include "channels/mefi/settings.hpp"

#include "channels/nct/settings.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::mefi {

namespace {

// Whole words only: no macros, no calls, no increments by letter.
void mefi_policy(fanuc::Policy& p) {
    p.words.increment_letters = p.words.comma_words = false;
    p.words.once = true;
    p.macro.statements = p.macro.expressions = p.macro.program_names = false;
    p.program.starts_with_zero = true;
    p.program.offset_outlasts_end = p.program.offset_ends = false;
    p.motion.angle_lines = p.motion.rotary_feed = false;
    p.tools.zeros_until_power_off = true;
}

}  // namespace

fanuc::Settings mefi_settings(const params::Table& t, unsigned l) {
    // What the specification leaves open (T digits, dwell, feeds at power-on, M groups) is the
    // machine's: its N parameters.
    fanuc::Settings s = nct::nct_settings(t, l);
    s.system = fanuc::kM;
    s.dialect = Dialect::Mefi;
    mefi_policy(s.policy);
    s.point_means_nothing = true;  // section 3: X100 is 100 mm
    s.power_on_inch = false;       // section 3: millimetres
    s.power_on_incremental = false;
    s.power_on_per_revolution = false;
    s.g_calls.clear();
    s.m_calls.clear();
    s.letter_calls.clear();
    const auto priority = params::get(t, params::pt_mefi_priority, l);
    s.priority_zero_row = static_cast<std::int32_t>(*work_zero_row(priority == 54 ? "G54" : "G53"));
    return s;
}

}  // namespace polyturn::channels::mefi
