/* A PLC with the faults that a PLC can have; FAULT says which. It behaves for a hundred cycles (a
 * second), then shows it. */
#include "plc_api.h"

static int init(void* state, const PolyturnPlcHost* host, const char** why) {
    (void)state;
    (void)host;
#if FAULT == 3
    *why = "no hydraulic pressure";
    return 1;
#else
    (void)why;
    return 0;
#endif
}

static void cycle(void* state, const PolyturnPlcInputs* in, PolyturnPlcOutputs* out) {
    (void)state;
    out->output[0] = 1;
    if (in->cycle <= 100) return;
#if FAULT == 1 /* writes where it should not */
    *(volatile int*)16 = 1;
#elif FAULT == 2 /* does not come back */
    for (volatile int forever = 1; forever;) {
    }
#elif FAULT == 4 /* writes into what the kernel has told it */
    ((int32_t*)in->signal)[-(1 << 26)] = 1;
#endif
}

static const PolyturnPlc plc = {
#if FAULT == 5 /* built for another version */
    POLYTURN_PLC_API + 1,
#else
    POLYTURN_PLC_API,
#endif
    "faulty", 64, init, cycle};
const PolyturnPlc* polyturn_plc(void) { return &plc; }
