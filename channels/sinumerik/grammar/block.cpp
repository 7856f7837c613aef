// A block whose words are read: what must not be, and the order in which the rest acts.
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Groups whose handler acts before tools and functions, in this order: units and plane first, since
// the words count in them.
constexpr std::uint8_t kEarly[] = {13, 6,  14, 29, 4,  10, 11, 12, 19, 20, 21, 24, 25, 26,
                                   27, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 41, 42,
                                   45, 46, 47, 49, 50, 51, 52, 53, 54, 55, 56, 57, 59, 61,
                                   62, 64, 16, 17, 18, 22, 23, 40, 43, 44, 48, 60, 15, 8};
constexpr std::uint8_t kFrameGroup = 3, kSuppression = 9, kCompensation = 7, kMotion = 1,
                       kOneShot = 2;

bool in_list(std::string_view list, std::string_view name) {
    for (std::size_t at = list.find(name); at != std::string_view::npos;
         at = list.find(name, at + 1)) {
        const bool front = at == 0 || list[at - 1] == ' ',
                   back = at + name.size() == list.size() || list[at + name.size()] == ' ';
        if (front && back) return true;
    }
    return false;
}

bool is_function(std::string_view name) {
    return name.size() == 1 && std::string_view("MHSTDF").find(name[0]) != std::string_view::npos;
}

}  // namespace

bool Interpreter::takes(const GCode& code, const Address& address) const {
    return in_list(code.takes, address.name == "axis" ? "axes" : address.name);
}

// The G command that drives the axis words: of group 2, 3 or, when none of them wants them, group
// 1.
const GCode* Interpreter::motion_code() const {
    for (const std::uint8_t group : {kOneShot, kFrameGroup})
        if (const GCode* code = block_.coded[group]) return code;
    return find_g(kMotion,
                  block_.coded[kMotion] ? block_.coded[kMotion]->number : modal_.active[kMotion]);
}

bool Interpreter::check_block() {
    const GCode* motion = motion_code();
    unsigned m = 0, s = 0, h = 0, others = 0;
    for (const Word& word : block_.words) {
        const Address& address = *word.address;
        for (const std::string_view name : {"T", "D", "DL", "F", "FA"})
            others += address.name == name;
        if (address.name == "M" && ++m > 5) return fail_word(Alarm::FunctionsTooMany, word, "M");
        if (address.name == "H" && ++h > 3) return fail_word(Alarm::FunctionsTooMany, word, "H");
        if (address.name == "S" && ++s > 3) return fail_word(Alarm::FunctionsTooMany, word, "S");
        if (address.use == Address::Use::Setting) continue;
        if (is_function(address.name)) continue;
        if (address.name == "P" && (block_.program.wanted || statement_)) continue;
        bool taken = motion && takes(*motion, address);
        for (const GCode* code : block_.codes) taken = taken || takes(*code, address);
        if (!taken)
            return fail_word(
                Alarm::AddressIllegal, word,
                address.name == "axis" ? axis_name(word.axis) : std::string(address.name));
    }
    // sinumerik_part2 14
    if (m + s + h + others > 10) return fail(Alarm::FunctionsTooMany, "M S H T D F");
    if (const GCode* frame = block_.coded[kFrameGroup];
        frame && block_.codes.size() > 1 && (frame->number < 9 || frame->number > 14))
        // frame commands (sinumerik_part2 13.2)
        return fail(Alarm::OwnBlockNeeded, std::string(frame->name));
    // Poles, and the limits of G25 and G26: their axis words are no way (sinumerik_part1 10.3,
    // sinumerik_part2 15.3.1).
    if (const GCode* pole = block_.coded[kFrameGroup];
        pole && pole->number >= 10 && pole->number <= 14 &&
        (block_.coded[kMotion] || block_.coded[kOneShot]))
        return fail(Alarm::OwnBlockNeeded, std::string(pole->name));
    // 15.7
    if (const GCode* dwell = block_.coded[kOneShot];
        dwell && dwell->name == "G4" && axis_words() != 0)
        return fail(Alarm::OwnBlockNeeded, "G4");
    const std::size_t other = block_.words.size() + block_.codes.size();
    for (const auto& [command, call] : block_.procedures)
        if (command->own_block && (other > 0 || block_.procedures.size() > 1))
            return fail(Alarm::OwnBlockNeeded, std::string(command->name));
    return true;
}

bool Interpreter::act() {
    for (const Written& one : written_) report_variable(one.name, one.value);
    written_.clear();
    tell_written_zeros();
    if (!settings_and_tools() || !functions_before()) return false;
    for (auto& [command, call] : block_.procedures)
        if (!(this->*command->act)(call)) return false;
    // what they have given back
    for (const Written& one : written_) report_variable(one.name, one.value);
    written_.clear();
    AxisSet under_way = 0;
    if (!drive_overlays() || !begin_stops() || !start_positioning(under_way) || !motion() ||
        !position_in_parts())
        return false;
    if (core_.due_at_barrier()) stop_reading();
    if (under_way) core_.arrive(under_way, 0);  // POS: the block ends when they are there
    return functions_after();
}

bool Interpreter::settings_and_tools() {
    const auto run = [this](std::uint8_t group) {
        const GCode* code = block_.coded[group];
        if (!code) return true;
        if (!(this->*code->act)(*code)) return false;
        if (code->modal) modal_.active[group] = code->number;
        return true;
    };
    if (!block_.codes.empty())
        for (const std::uint8_t group : kEarly)
            if (!run(group)) return false;
    if (const GCode* code = block_.coded[kMotion]) {
        if (code->number != modal_.active[kMotion] && !motion_changes(*code)) return false;
        modal_.active[kMotion] = code->number;
    }
    core_.at.display_swapped = display_swapped();
    block_feed_ = 0.0;
    if (block_.words.empty()) return true;
    if (!tool_words()) return false;
    core_.at.tool = core_.path.tool.ref;
    for (const Word& word : block_.words) {
        if (word.address->name == "F" && !feed_word(word)) return false;
        if (word.address->use == Address::Use::Setting && !(this->*word.address->act)(word))
            return false;
    }
    return true;
}

bool Interpreter::motion() {
    if (const GCode* code = block_.coded[kSuppression]; code && !(this->*code->act)(*code))
        return false;
    if (const GCode* code = block_.coded[kFrameGroup]; code && !(this->*code->act)(*code))
        return false;
    if (const GCode* code = block_.coded[kCompensation]) {
        if (!(this->*code->act)(*code)) return false;
        modal_.active[kCompensation] = code->number;
    }
    const GCode* one_shot = block_.coded[kOneShot];
    const GCode* code = one_shot;
    if (!code && !block_.coded[kFrameGroup]) {
        const bool wanted =
            std::any_of(block_.words.begin(), block_.words.end(), [&](const Word& word) {
                return word.address->use == Address::Use::Block &&
                       !is_function(word.address->name) && word.address->name != "P";
            });
        if (wanted || block_.coded[kMotion] || block_.coded[kCompensation])
            code = find_g(kMotion, modal_.active[kMotion]);
    }
    if (!code) return true;
    if (!code->act) return fail(Alarm::NotBuilt, std::string(code->name));
    // straight ways only
    if (code->group == kMotion && code->number > 2 && deletes_travel())
        return fail(Alarm::NotBuilt, "DELDTG: " + std::string(code->name));
    // straight segments only
    if (modal_.curve && (code->group != 1 || code->number > 2))
        return fail(Alarm::CodesContradict, "CTABDEF, " + std::string(code->name));
    const bool thread =
        code->group == 1 && ((code->number >= 10 && code->number <= 12) || code->number >= 16);
    // FPR
    const bool other = modal_.feed_spindle && modal_.feed_revolution && code->group == 1 && !thread;
    if (!update_feed() || !with_spindle(other ? modal_.feed_spindle : std::uint16_t{0},
                                        [&] { return (this->*code->act)(*code); }))
        return false;
    for (AxisSet left = axis_words(); left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        modal_.pending_zero[i] = modal_.pending_tool[i] = 0.0;
    }
    return true;
}

bool Interpreter::fail_word(Alarm alarm, const Word& word, std::string detail, double v0,
                            double v1) {
    fault_column_ = word.column;
    fault_length_ = word.length;
    return core_.fail(alarm, 0, std::move(detail), v0, v1);
}

// --- where axis words want their axes

bool Interpreter::is_incremental(const Word& word) const {
    switch (word.mode) {
        case Mode::IC:
        case Mode::DIC:
        case Mode::RIC:
        case Mode::CIC:
            return true;
        case Mode::Plain:
        case Mode::GP:
        case Mode::QU:
            return !absolute();
        default:
            return false;
    }
}

bool Interpreter::counts_diameter(unsigned place, bool incremental) const {
    // of an axis without one the channel means its transverse axis
    const unsigned own = place < kChannelAxes ? modal_.axis_diameter[place] : 0u;
    const bool as_channel =
        own == kAsChannel || (own == 0 && static_cast<int>(place) == settings_.diameter_axis);
    const unsigned status = as_channel ? modal_.active[29] : own ? own : 1u;
    return status == 2 || (status == 3 && !incremental);
}

AxisSet Interpreter::display_swapped() const {
    const MachineView& view = core_.view();
    AxisSet set = 0;
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (counts_diameter(i, false) != view.axes[i].diameter) set |= 1u << i;
    return set;
}

double Interpreter::length_mm(const Word& word, int place, bool incremental) const {
    const MachineView& view = core_.view();
    double value = word.number();
    if (place < 0) return value * unit();
    const auto i = static_cast<unsigned>(place);
    if (view.axes[i].rotary) return value;
    bool diameter = counts_diameter(i, incremental);
    if (word.mode == Mode::DAC || word.mode == Mode::DIC) diameter = true;
    if (word.mode == Mode::RAC || word.mode == Mode::RIC) diameter = false;
    return value * unit() * (diameter ? 0.5 : 1.0);
}

bool Interpreter::axis_target(const Word& word, AxisValues& target) {
    const auto i = static_cast<std::size_t>(word.axis);
    const ChannelAxis& axis = core_.view().axes[i];
    const bool incremental = is_incremental(word);
    const double value = length_mm(word, word.axis, incremental), now = core_.path.programmed[i];
    if (word.mode >= Mode::CAC && word.mode <= Mode::CACN)
        return fail_word(Alarm::NotBuilt, word, "CAC, CIC, CDC");
    if (word.mode == Mode::DC || word.mode == Mode::ACP || word.mode == Mode::ACN) {
        if (!axis.rotary) return fail_word(Alarm::AxisKindWrong, word, axis.name);
        if (word.mode != Mode::DC && !axis.rollover)
            return fail_word(Alarm::AxisKindWrong, word, axis.name);
        if (!(value >= 0 && value <= 360))
            return fail_word(Alarm::ValueOutOfRange, word, axis.name);
        const double period = axis.rollover ? axis.rollover_deg : 360.0;
        double way = std::fmod(value - now, period);
        if (way < 0) way += period;  // the positive way
        if (word.mode == Mode::ACN && way > 0) way -= period;
        if (word.mode == Mode::DC && way > period / 2) way -= period;
        target[i] = now + way;
        return true;
    }
    if (axis.rollover && !modal_.curve) {  // a curve table has its values as they are written
        target[i] = core_.rollover_target(static_cast<unsigned>(word.axis), value, !incremental);
        return true;
    }
    if (!incremental) {
        target[i] = value;
        return true;
    }
    target[i] = now + value + (settings_.zero_travels ? modal_.pending_zero[i] : 0.0) +
                (settings_.tool_travels ? modal_.pending_tool[i] : 0.0);
    return true;
}

// An axis that has been released is taken by naming it where MD30552 says so, as GET takes it
// (sinumerik_part3 7.14): the block is read again behind a barrier, where it is known to which
// place somebody else has driven it.
bool Interpreter::take_back_released_axes() {
    if (!modal_.released || block_.coded[3]) return true;  // TRANS Z moves nothing
    AxisSet back = 0;
    for (const Word& w : block_.words) {
        if (!names_moved_axis(w) || !(modal_.released >> w.axis & 1u)) continue;
        // has_axis() refuses it
        if (params::get(core_.view().table(), params::md30552,
                        core_.view().axes[static_cast<std::size_t>(w.axis)].machine_axis + 1u) == 0)
            continue;
        if (core_.compensating())
            return fail_word(Alarm::AxisExchangeIllegal, w, axis_name(w.axis));
        back |= 1u << w.axis;
    }
    modal_.released &= ~back;
    if (back) needs_barrier_ = true;
    return back == 0;
}

bool Interpreter::has_axis(const Word& word) {
    return !(modal_.released >> word.axis & 1u) ||
           fail_word(Alarm::AxisReleased, word, axis_name(word.axis));
}

bool Interpreter::read_axis_words(AxisValues& target, AxisSet& named) {
    target = core_.path.programmed;
    named = 0;
    for (const Word& word : block_.words) {
        if (word.axis < 0 || word.address->name != "axis") continue;
        if (!has_axis(word)) return false;
        if (!axis_target(word, target)) return false;
        named |= 1u << word.axis;
    }
    return true;
}

// Zeros, frames and tools change what the programmed numbers mean; an incremental block may travel
// the difference.
void Interpreter::zeros_change(const std::function<void()>& change) {
    const AxisValues before = core_.path.programmed;
    change();
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        modal_.pending_zero[i] += before[i] - core_.path.programmed[i];
}

int Interpreter::find_axis(std::string_view name) const {
    const MachineView& view = core_.view();
    const Transformation& transformation = core_.path.transformation;
    // Y is the transformation's; its rotary axis has no name of its own meanwhile
    if (transformation.named_y) {
        if (name == "Y") return transformation.virtual_y;
        if (view.axis_by_name(name) == transformation.rotary_place()) return -1;
    }
    if (const int place = view.axis_by_name(name); place >= 0) return place;
    const auto number_behind = [&](std::size_t from) -> int {
        int number = 0;
        if (from >= name.size() || name.size() - from > 2) return -1;
        for (std::size_t i = from; i < name.size(); ++i) {
            if (!is_digit(name[i])) return -1;
            number = number * 10 + (name[i] - '0');
        }
        return number;
    };
    if (name.size() > 1 && name[0] == 'S')
        if (const int n = number_behind(1); n > 0) return kSpindleAxis + n;
    // Machine axes: AX3 by number, X1 by the letter (MD10000: X1 Y1 Z1 A1 B1 C1 U1 V1).
    if (name.size() > 2 && name.substr(0, 2) == "AX")
        if (const int n = number_behind(2); n > 0)
            for (unsigned i = 0; i < view.axis_count; ++i)
                if (view.axes[i].machine_axis + 1 == n) return static_cast<int>(i);
    if (name.size() == 2 && name[1] == '1' &&
        std::string_view("XYZABCUV").find(name[0]) != std::string_view::npos)
        return view.axis_by_name(name.substr(0, 1));
    return -1;
}

std::string Interpreter::axis_name(int place) const {
    const MachineView& view = core_.view();
    if (place >= kSpindleAxis) return "S" + std::to_string(place - kSpindleAxis);
    return place >= 0 && static_cast<unsigned>(place) < view.axis_count
               ? view.axes[static_cast<std::size_t>(place)].name
               : std::string();
}

}  // namespace polyturn::channels::sinumerik
