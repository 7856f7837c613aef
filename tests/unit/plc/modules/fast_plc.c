/* A PLC with a fast task: SP_OSW S2 is digital input 3 while A1 rests, PLC_NOTE counts the runs of
 * the task; output 0 tells how often it ran before the cycle of the same tick (odd or even), output
 * 1 that what does not exist was refused. */
#include "plc_api.h"

typedef struct {
    uint32_t runs;
    int32_t switch_at, axis_at, osw_at, count_at, refused;
} State;

static int init(void* memory, const PolyturnPlcHost* host, const char** why) {
    (void)memory, (void)host, (void)why;
    return 0;
}

static void cycle(void* memory, const PolyturnPlcInputs* in, PolyturnPlcOutputs* out) {
    const State* s = memory;
    (void)in;
    out->output[0] = s->runs % 2;
    out->output[1] = s->refused != 0;
}

static int init_fast(void* memory, const PolyturnPlcInt0Host* host, const char** why) {
    State* s = memory;
    s->switch_at = host->read_input(3);
    s->axis_at = host->read_signal("AN_MOVE", 1);
    s->osw_at = host->write_signal("SP_OSW", 2);
    s->count_at = host->write_signal("PLC_NOTE", 1);
    s->refused = host->read_input(100000) < 0 && host->read_signal("NO_SUCH", 1) < 0 &&
                 host->write_signal("AN_MOVE", 1) < 0 &&
                 host->write_signal("SP_OSW", 2) == s->osw_at;
    if (s->switch_at >= 0 && s->axis_at >= 0 && s->osw_at >= 0 && s->count_at >= 0) return 0;
    *why = "a signal is missing";
    return 1;
}

static void run_fast(void* memory, int64_t tick, const int32_t* read, int32_t* write) {
    State* s = memory;
    (void)tick;
    ++s->runs;
    write[s->osw_at] = read[s->switch_at] != 0 && read[s->axis_at] == 0;
    write[s->count_at] = (int32_t)s->runs;
}

static const PolyturnPlcInt0 fast = {init_fast, run_fast};
const PolyturnPlcInt0* polyturn_plc_int0(void) { return &fast; }
static const PolyturnPlc plc = {POLYTURN_PLC_API, "fast", sizeof(State), init, cycle};
const PolyturnPlc* polyturn_plc(void) { return &plc; }
