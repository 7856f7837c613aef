// Names of signals and numbers of parameters become slots and values, once.
#include <cstdio>

#include "kernel/plc/lathe/lathe_plc.hpp"

namespace polyturn::plc {
namespace {

struct Finder {
    const PolyturnPlcHost& host;
    const char* missing = nullptr;
    std::int32_t nc(const char* name, std::uint32_t instance) {
        const std::int32_t slot = host.nc_slot(name, instance);
        if (slot < 0) missing = name;
        return slot;
    }
    std::int32_t plc(const char* name, std::uint32_t instance) {
        const std::int32_t slot = host.plc_slot(name, instance);
        if (slot < 0) missing = name;
        return slot;
    }
    double real(const char* number, std::uint32_t instance) {
        double value = 0.0;
        if (!host.parameter(number, instance, &value)) missing = number;
        return value;
    }
    std::int32_t whole(const char* number, std::uint32_t instance) {
        return static_cast<std::int32_t>(real(number, instance));
    }
    // The n-th (from 0) of a row of parameters that begins with N<first>.
    double in_row(int first, std::uint32_t n, std::uint32_t instance) {
        char number[8];
        std::snprintf(number, sizeof number, "N%04d",
                      static_cast<int>(static_cast<std::uint32_t>(first) + n) % 10000);
        double value = 0.0;
        if (!host.parameter(number, instance, &value)) missing = "a parameter of a row";
        return value;
    }
};

}  // namespace

const char* LathePlc::resolve(const PolyturnPlcHost& host) {
    Finder f{host};
    if (host.channels < kChannels || host.spindles < kSpindles || host.axes < kAxes)
        return "the capacities of the image";
    for (std::uint32_t c = 1; c <= kChannels; ++c) {
        channel_slots_[c - 1] = {
            f.nc("CN_RESET", c),     f.nc("CN_MSTR", c),        f.nc("CN_MCODE", c),
            f.nc("CN_SSTR", c),      f.nc("CN_SCODE", c),       f.nc("CN_TSTR", c),
            f.nc("CN_TCODE", c),     f.nc("CN_BSTR", c),        f.nc("CN_SSEL", c),
            f.nc("CN_MGZNO", c),     f.nc("CN_POTNO", c),       f.plc("CP_MFIN", c),
            f.plc("CP_SFIN", c),     f.plc("CP_TFIN", c),       f.plc("CP_BFIN", c),
            f.plc("CP_FIN", c),      f.plc("CP_ACTT", c),       f.plc("CP_MGR1", c),
            f.plc("CP_DOOROPEN", c), f.plc("CP_NOLUBE", c),     f.plc("CP_BAREND", c),
            f.plc("CP_SSEL", c),     f.plc("CP_TURRETOPEN", c), f.plc("CP_TAILOPEN", c),
            f.plc("CP_SETUP", c),    f.plc("CP_JOGFD", c),      f.plc("CP_UIN", c)};
        ChannelSettings& s = channel_settings_[c - 1];
        s.default_spindle = f.whole("N0604", c);
        s.turret_time_s = f.real("PT_TURRET_TIME", c);
        s.turret_clamp_s = f.real("PT_TURRET_CLAMP", c);
        s.forward_only = f.real("PT_TURRET_FORWARD", c) != 0;
        s.stations = f.whole("PT_TURRET_STATIONS", c);
        s.half = f.real("PT_TURRET_HALF", c) != 0;
        s.magazine = f.whole("PT_TURRET_MAGAZINE", c);
        s.first_pot = s.magazine ? static_cast<std::int32_t>(f.in_row(
                                       2906, static_cast<std::uint32_t>(s.magazine - 1), 1))
                                 : 1;
        s.lube_time_s = f.real("PT_LUBE_TIME", c);
        static constexpr const char* kCodes[kHelpers] = {"PT_M_TAILSTOCK", "PT_M_BAR",
                                                         "PT_M_CATCHER", "PT_M_DOOR"};
        static constexpr const char* kTimes[kHelpers] = {"PT_TAILSTOCK_TIME", "PT_BAR_TIME",
                                                         "PT_CATCHER_TIME", "PT_DOOR_TIME"};
        for (std::size_t h = 0; h < kHelpers; ++h) {
            s.code[h] = f.whole(kCodes[h], c);
            s.time_s[h] = f.real(kTimes[h], c);
        }
        s.first_spindle_code = f.whole("PT_M_SPINDLE", c);
        s.in_door = f.whole("PT_IN_DOOR", c);
        s.in_setup = f.whole("PT_IN_SETUP", c);
        s.in_lube = f.whole("PT_IN_LUBE", c);
        s.in_bar = f.whole("PT_IN_BAR", c);
        s.driven_spindle = static_cast<std::uint32_t>(f.real("PT_DRIVEN_SPINDLE", c));
        if (s.driven_spindle > kSpindles) s.driven_spindle = 0;
        for (std::uint32_t n = 0; n < kMGroups; ++n) {
            s.group_low[n] = static_cast<std::int32_t>(f.in_row(1341, n, c));
            s.group_high[n] = static_cast<std::int32_t>(f.in_row(1357, n, c));
        }
    }
    group_stride_ = host.plc_slot("CP_MGR2", 1) - host.plc_slot("CP_MGR1", 1);
    for (std::uint32_t s = 1; s <= kSpindles; ++s) {
        SpindleSettings& set = spindle_settings_[s - 1];
        set.chuck_time_s = f.real("PT_CHUCK_TIME", s);
        set.gear_time_s = f.real("PT_GEAR_TIME", s);
        set.ranges = f.whole("PT_GEAR_RANGES", s);
        set.c_axis_code = f.whole("PT_M_C_AXIS", s);
        set.in_chuck = f.whole("PT_IN_CHUCK", s);
        set.in_orient = f.whole("PT_IN_ORIENT", s);
        set.master = f.whole("PT_SPINDLE_MASTER", s);
        if (set.master > static_cast<std::int32_t>(kSpindles)) set.master = 0;
        set.follow_code = f.whole("PT_M_FOLLOW", s);
        set.closing_code = f.whole("N0823", s);
        set.state_low = f.whole("N0689", s);
        set.state_high = f.whole("N0690", s);
        for (std::uint32_t n = 0; n < kRanges; ++n) set.range_max[n] = f.in_row(650, n, s);
        spindle_slots_[s - 1] = {
            f.nc("SN_NS", s),     f.nc("SN_N0", s),       f.nc("SN_INPOS", s),
            f.plc("SP_ROT", s),   f.plc("SP_OREQ", s),    f.plc("SP_PAR", s),
            f.plc("SP_RANGE", s), f.plc("SP_SDETCHR", s), f.plc("SP_UNCLAMPED", s),
            f.plc("SP_ACTT", s),  f.nc("SN_SYNCA", s),    f.nc("SN_FOLLOW", s),
            f.plc("SP_SYNCR", s), f.plc("SP_PHASER", s)};
    }
    for (std::uint32_t a = 1; a <= kAxes; ++a) {
        lube_slot_[a - 1] = f.nc("AN_LUBR", a);
        axis_codes_[a - 1] = {f.nc("AN_PAXFSTR", a), f.nc("AN_PAXFLET", a), f.nc("AN_PAXFCODE", a),
                              f.plc("AP_PAXFFIN", a), f.plc("AP_PAXENA", a)};
        couplings_[a - 1] = {
            {f.whole("PT_M_SYNC", a), f.whole("PT_M_MIX", a), f.whole("PT_M_SUPER", a)},
            {f.plc("AP_SYNCR", a), f.plc("AP_MIXR", a), f.plc("AP_SPRPNR", a)},
            {f.nc("AN_SYNCA", a), f.nc("AN_MIXA", a), f.nc("AN_SPRPNA", a)}};
        torque_[a - 1] = {f.whole("PT_M_TORQUE", a), f.whole("PT_STOP_TORQUE", a),
                          f.plc("AP_TORQ", a),       f.nc("AN_FIXED", a),
                          f.nc("AN_MOVE", a),        false};
        axis_channel_[a - 1] = static_cast<std::uint32_t>(f.real("N0002", a));
    }
    machine_on_slot_ = f.nc("N_MACHINE_ON", 1);
    emergency_slot_ = f.nc("N_ESTOP", 1);
    couple_time_s_ = f.real("PT_COUPLE_TIMEOUT", 1);
    in_stop_ = f.whole("PT_IN_ESTOP", 1);
    stop_slot_ = f.plc("PLC_ESTOP", 1);
    in_power_ = f.whole("PT_IN_POWER", 1);
    power_slot_ = f.plc("PLC_POWER", 1);
    message_slot_ = f.plc("PLC_ALARM", 1);
    key_slot_ = f.plc("PLC_KEY", 1);
    in_key_ = f.whole("PT_IN_KEY", 1);
    tick_s_ = host.tick_s;
    return f.missing;
}

const char* LathePlc::resolve_fast(const PolyturnPlcInt0Host& host) {
    copies_ = 0;
    for (std::uint32_t s = 1; s <= kSpindles; ++s) {
        if (spindle_settings_[s - 1].in_orient <= 0) continue;
        const Copied one{
            host.read_input(static_cast<std::uint32_t>(spindle_settings_[s - 1].in_orient - 1)),
            host.write_signal("SP_OSW", s)};
        if (one.from < 0 || one.to < 0) return "an input of PT_IN_ORIENT, or SP_OSW";
        copied_[copies_++] = one;
    }
    return nullptr;
}

void LathePlc::run_fast(const std::int32_t* read, std::int32_t* write) const {
    for (std::size_t i = 0; i < copies_; ++i) write[copied_[i].to] = read[copied_[i].from] != 0;
}

}  // namespace polyturn::plc
