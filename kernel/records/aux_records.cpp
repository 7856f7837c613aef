#include "kernel/records/aux_records.hpp"

#include <cmath>
#include <cstring>

#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kToolChangeCode = 6;  // M06
constexpr double kToolTimeoutS = 5;    // a store that died is started again meanwhile

struct Lines {
    NcSignal strobe, code;
    PlcSignal finished;
};
Lines lines_of(const PathRecord& r, const std::array<char, 3>& letters) noexcept {
    const NcSignal second = r.code == letters[2]   ? signals::cn_aux3c
                            : r.code == letters[1] ? signals::cn_aux2c
                                                   : signals::cn_aux1c;
    return r.code == 'S'   ? Lines{signals::cn_sstr, signals::cn_scode, signals::cp_sfin}
           : r.code == 'T' ? Lines{signals::cn_tstr, signals::cn_tcode, signals::cp_tfin}
           : r.code == 'M' ? Lines{signals::cn_mstr, signals::cn_mcode, signals::cp_mfin}
                           : Lines{signals::cn_bstr, second, signals::cp_bfin};
}

// Which tool it is, and its station: asked of the store before the PLC gets the T. A refusal is
// reported once; it is not asked again before a reset, so that nothing moves by itself when the
// reason is gone.
bool tool_is_known(Channel& c, const PathRecord& r) noexcept {
    const ToolClient::Call call = c.core.tools.call(c.index);
    if (call == ToolClient::Call::Answered) return true;
    if (c.program.interrupted()) return false;
    if (call == ToolClient::Call::None) {
        (void)c.core.tools.ask(c.core, c.index, r);
    } else if (call == ToolClient::Call::Refused) {
        const ToolAnswer& answer = c.core.tools.answer(c.index);
        c.raise(static_cast<Alarm>(answer.alarm),
                {answer.text.data(), ::strnlen(answer.text.data(), answer.text.size())});
    } else if (c.core.store_dead &&
               c.core.tick - c.core.tools.asked_at(c.index) >
                   static_cast<std::int64_t>(kToolTimeoutS / c.core.config.tick_s)) {
        c.raise(Alarm::ToolsUnserved, "the store does not run");
    }
    return false;
}

}  // namespace

void strobe_function(Channel& c, const PathRecord& r) noexcept {
    // A spindle code that comes before the first S means the spindle of N0604 as well.
    if (const long code = std::lround(r.value); r.code == 'M' &&
                                                ((code >= 3 && code <= 5) || code == 19) &&
                                                c.core.signals.nc(signals::cn_ssel(c.number)) == 0)
        c.core.signals.set_nc(
            signals::cn_ssel(c.number),
            static_cast<std::int32_t>(c.core.config.channels[c.index].default_spindle));
    const Lines lines = lines_of(r, c.core.config.channels[c.index].aux_letters);
    c.standing.handshake.strobe = c.core.signals.nc(lines.strobe(c.number)) + 1;
    if (r.code == 'T' && ToolClient::managed(c.core))
        c.core.tools.show(c.core, c.index);
    else if (r.code == 'T')
        c.core.signals.set_nc(signals::cn_mgzno(c.number), 0);
    c.core.signals.set_nc(lines.code(c.number), static_cast<std::int32_t>(std::lround(r.value)));
    c.core.signals.set_nc(lines.strobe(c.number), c.standing.handshake.strobe);
    if (r.code == 'M') {
        c.standing.handshake.m_code = static_cast<std::int32_t>(std::lround(r.value));
        c.core.newest_m = {c.standing.handshake.m_code, c.number};
    }
}

void strobe_program_end(Channel& c, StopReason reason) noexcept {
    if (reason != StopReason::M02 && reason != StopReason::M30) return;
    PathRecord r{};
    r.code = 'M';
    r.value = reason == StopReason::M02 ? 2.0 : 30.0;
    strobe_function(c, r);
}

bool give_function(Channel& c, const PathRecord& r) noexcept {
    const Lines lines = lines_of(r, c.core.config.channels[c.index].aux_letters);
    const bool managed = r.code == 'T' && ToolClient::managed(c.core);
    if (managed && c.standing.phase != RecordPhase::Handshake && !tool_is_known(c, r)) return false;
    if (r.plane[2] != 0) {  // passed by a restart: the PLC hears nothing of it
        if (managed || r.code == 'M') c.core.tools.pass(c.core, c.index, r.code == 'M');
        if (managed) c.core.tools.forget(c.index);
        return true;
    }
    if (managed && c.standing.phase != RecordPhase::Handshake && c.core.tools.differs(c.index)) {
        if (!c.program.interrupted())
            c.raise(
                Alarm::ToolNotFound,
                "since the search for the block another sister has taken its place; restart again");
        return false;
    }
    if (c.standing.phase != RecordPhase::Handshake) {
        // the code before is still to be seen
        if (c.standing.handshake.unfinished && c.core.signals.plc(lines.finished(c.number)) !=
                                                   c.core.signals.nc(lines.strobe(c.number)))
            return false;
        c.standing.handshake.unfinished =
            (c.program.control & kControlNoFinish) != 0 || (r.flags & kPositioning) != 0;
        c.standing.phase = RecordPhase::Handshake;
        if (c.standing.handshake.early != c.path.cursor) {
            strobe_function(c, r);
            c.standing.since = c.core.tick;
            return false;
        }
    }
    // Its end is not waited for, but the PLC has to see it while the spindle that it means is the
    // selected one.
    if ((r.flags & kPositioning) && c.core.tick <= c.standing.since + c.core.config.plc_cycle_ticks)
        return false;
    if (!c.standing.handshake.unfinished &&
        c.core.signals.plc(lines.finished(c.number)) != c.standing.handshake.strobe)
        return false;
    c.standing.handshake.early =
        kNoRecord;  // until here: the axes may still be coming to rest while the turret turns
    if (managed) {
        if (!c.core.tools.in_place(c.core, c.index)) return false;  // the store's ring is full
        c.core.tools.forget(c.index);
    } else if (r.code == 'T') {
        c.core.signals.set_nc(signals::cn_potno(c.number),
                              static_cast<std::int32_t>(std::lround(r.value)));
    } else if (r.code == 'M' && r.value == kToolChangeCode && ToolClient::managed(c.core)) {
        return c.core.tools.changed(c.core, c.index);
    }
    return true;
}

}  // namespace polyturn::kernel
