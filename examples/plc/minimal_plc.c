/* The smallest useful PLC: M8 and M9 switch the coolant of channel L1, every other M code is
 * finished at once.
 *     cc -shared -fPIC -I<polyturn>/kernel/plc minimal_plc.c -o plc.so */
#include "plc_api.h"

typedef struct {
    int32_t m_count, m_code, m_done, b_count, b_done; /* slots */
    int32_t seen;                    /* the last M code taken */
} State;

static int init(void* memory, const PolyturnPlcHost* host, const char** why) {
    State* s = memory;
    s->m_count = host->nc_slot("CN_MSTR", 1);
    s->m_code = host->nc_slot("CN_MCODE", 1);
    s->m_done = host->plc_slot("CP_MFIN", 1);
    s->b_count = host->nc_slot("CN_BSTR", 1);
    s->b_done = host->plc_slot("CP_BFIN", 1);
    if (s->b_count < 0 || s->b_done < 0 || s->m_count < 0 || s->m_code < 0 || s->m_done < 0) {
        *why = "a signal is missing";
        return 1;
    }
    return 0;
}

static void cycle(void* memory, const PolyturnPlcInputs* in, PolyturnPlcOutputs* out) {
    State* s = memory;
    out->signal[s->b_done] = in->signal[s->b_count]; /* second auxiliary functions need nothing */
    if (in->signal[s->m_count] == s->seen) return; /* no new M code */
    s->seen = in->signal[s->m_count];
    if (in->signal[s->m_code] == 8) out->output[0] = 1;
    if (in->signal[s->m_code] == 9) out->output[0] = 0;
    out->signal[s->m_done] = s->seen; /* finished */
}

static const PolyturnPlc plc = {POLYTURN_PLC_API, "minimal example", sizeof(State), init, cycle};
const PolyturnPlc* polyturn_plc(void) { return &plc; }
