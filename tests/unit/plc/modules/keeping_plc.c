/* A PLC that keeps: `starts` by polyturn_plc_retained(), two memory blocks by itself.
 *   outputs 0 .. : as many as it was started        16 ..: as many as memory block 7 counts
 *   output 30: block 7 was read in the first cycle  31: and block 8 as well
 *   output 32: a read was refused as a timeout */
#include "plc_api.h"

typedef struct {
    uint32_t starts;
    uint32_t count7, count8;
    int have7, have8, begun, first_cycle;
    int (*read)(uint32_t, void*, size_t);
    int (*write)(uint32_t, const void*, size_t);
} State;

static int init(void* memory, const PolyturnPlcHost* host, const char** why) {
    State* s = memory;
    (void)why;
    s->read = host->memory_read;
    s->write = host->memory_write;
    return 0;
}

static void look(State* s, PolyturnPlcOutputs* out, uint32_t block, uint32_t* count, int* have,
                 int first_output) {
    if (*have) return;
    const int got = s->read(block, count, sizeof *count);
    if (got == POLYTURN_PLC_MEMORY_TIMEOUT) out->output[32] = 1;
    if (got != POLYTURN_PLC_MEMORY_DONE && got != POLYTURN_PLC_MEMORY_NONE) return;
    *have = 1;
    if (got == POLYTURN_PLC_MEMORY_DONE && s->first_cycle) out->output[first_output] = 1;
    ++*count;
    s->write(block, count, sizeof *count);
}

static void cycle(void* memory, const PolyturnPlcInputs* in, PolyturnPlcOutputs* out) {
    State* s = memory;
    uint32_t n;
    (void)in;
    s->first_cycle = !s->begun;
    if (!s->begun) s->begun = 1, ++s->starts;
    look(s, out, 7, &s->count7, &s->have7, 30);
    look(s, out, 8, &s->count8, &s->have8, 31);
    for (n = 0; n < 8; ++n) out->output[n] = n < s->starts, out->output[16 + n] = n < s->count7;
}

static const PolyturnPlcRetained kept = {offsetof(State, starts), sizeof(uint32_t)};
const PolyturnPlcRetained* polyturn_plc_retained(void) { return &kept; }
static const PolyturnPlc plc = {POLYTURN_PLC_API, "keeps", sizeof(State), init, cycle};
const PolyturnPlc* polyturn_plc(void) { return &plc; }
