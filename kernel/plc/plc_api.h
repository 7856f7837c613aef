/* The interface between Polyturn and a machine builder's PLC: a shared object that polyturn-plc
 * loads.
 *
 * The object exports one function, polyturn_plc(), which returns a description of itself. Plain C,
 * so that it can be written in any language that makes shared objects.
 *
 *   polyturn-plc                                   the shared object
 *     |-- polyturn_plc() ------------------------->  its name, the size of its state
 *     |-- init(state, host) ---------------------->  asks for the slots of its signals, keeps them
 *     |-- cycle(state, inputs n, outputs n) ------>  each PT_PLC_CYCLE: reads, decides, writes
 *     |-- Int0 (optional): run(state, ...) ------->  every tick: a few values (see below)
 *
 * Rules
 *   R1  cycle() must return within a fraction of the cycle: no sleeping, no files, no waiting.
 *       A cycle that does not return or crashes stops the machine along its paths, with an alarm.
 *   R2  outputs keep their values from cycle to cycle; write what changes. They act exactly one
 *       PLC cycle later.
 *   R3  Everything that must survive from cycle to cycle lies in `state`: `state_size` bytes,
 *       zero at init(). In virtual time two runs must be identical: no clock but inputs->tick, no
 *       random numbers.
 *   R4  A code from the program (M, S, T) is a counter: while CN_MSTR L1 differs from what you
 *       last saw, CN_MCODE L1 holds a new code. Answer by setting CP_MFIN L1 to that count when the
 *       function is done. S and T likewise.
 *   R5  The names of signals and what they mean: ipc/image/signals.csv, and the builder's
 *       chapter of the manual.
 */
#ifndef POLYTURN_PLC_API_H
#define POLYTURN_PLC_API_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define POLYTURN_PLC_API 1u

/* What polyturn-plc offers during init(). The functions may be called in init() only, those of
 * memory in cycle() only. */
typedef struct PolyturnPlcHost {
    uint32_t api;      /* POLYTURN_PLC_API of polyturn-plc */
    uint32_t channels; /* instances of signals: capacities of the image, not of the machine */
    uint32_t axes;
    uint32_t spindles;
    uint32_t points; /* digital inputs, and digital outputs */
    double tick_s;   /* seconds from one value of inputs->tick to the next */
    /* Slot of a signal that the NC writes (in inputs->signal) or the PLC writes (in
     * outputs->signal); instance counts from 1 and is ignored for global ones. -1: there is no such
     * signal. */
    int32_t (*nc_slot)(const char* name, uint32_t instance);
    int32_t (*plc_slot)(const char* name, uint32_t instance);
    /* Value of a parameter ("PT_CHUCK_TIME", "N1203"); instance counts from 1 and is ignored for
     * global ones. 0: there is no such number, *value is unchanged. A PLC reads its parameters at
     * its start. */
    int (*parameter)(const char* number, uint32_t instance, double* value);
    /* Memory that outlives the PLC: blocks 0 to 255 of up to 4096 bytes, in a file beside the
     * machine's store. Unlike the others these two are for cycle(): keep the pointers. What is
     * written is on the disk soon after the cycle.
     * Read: the whole block, of the length it was written with. N1274 #0 = 1: QUEUED, ask again in
     * the next cycle; 0: at once, but only one in a cycle (TIMEOUT).
     * Both return POLYTURN_PLC_MEMORY_... */
    int (*memory_read)(uint32_t block, void* to, size_t size);
    int (*memory_write)(uint32_t block, const void* from, size_t size);
} PolyturnPlcHost;
#define POLYTURN_PLC_MEMORY_DONE 1
#define POLYTURN_PLC_MEMORY_QUEUED 0
#define POLYTURN_PLC_MEMORY_NONE (-1)    /* no such block, never written, or of another length */
#define POLYTURN_PLC_MEMORY_TIMEOUT (-2) /* N1274 #0 = 0, and another one was read in this cycle */

typedef struct PolyturnPlcInputs {
    uint64_t cycle; /* counts PLC cycles from 1; a gap: cycles were missed */
    int64_t tick;   /* the machine's time */
    const int32_t* signal;
    const uint8_t* input; /* digital inputs, 0 or 1 */
} PolyturnPlcInputs;

typedef struct PolyturnPlcOutputs {
    int32_t* signal;
    uint8_t* output; /* digital outputs, 0 or 1 */
} PolyturnPlcOutputs;

typedef struct PolyturnPlc {
    uint32_t api;     /* POLYTURN_PLC_API the object was built with */
    const char* name; /* shown to the operator */
    size_t state_size;
    /* 0: ready. Otherwise the PLC is not started, and *why (may stay unset) says the reason. */
    int (*init)(void* state, const PolyturnPlcHost* host, const char** why);
    void (*cycle)(void* state, const PolyturnPlcInputs* inputs, PolyturnPlcOutputs* outputs);
} PolyturnPlc;

/* The one function that the shared object exports. */
#define POLYTURN_PLC_SYMBOL "polyturn_plc"
typedef const PolyturnPlc* (*PolyturnPlcFunction)(void);

/* Optional: the bytes of `state` that survive power-off. While N1274 #1 is on, polyturn-plc keeps
 * them in a file beside the machine's store when the controller is shut down, and puts them back
 * behind init(), before the first cycle. */
typedef struct PolyturnPlcRetained {
    size_t offset, size;
} PolyturnPlcRetained;
#define POLYTURN_PLC_RETAINED_SYMBOL "polyturn_plc_retained"
typedef const PolyturnPlcRetained* (*PolyturnPlcRetainedFunction)(void);

/* Optional: Int0, the fast task, for what cannot wait for a cycle (the switch that orients a
 * spindle). It is called at every tick of the interpolation, between two cycles of the PLC and
 * never within one, sees up to 64 signals and inputs as they are at that tick, and what it answers
 * acts at the next one. It finds its values by place, in the order in which it has asked for them.
 * Of the signals that it writes it is the only writer: cycle() leaves them alone. A task that
 * writes nothing is never called. It should need a few microseconds; without an answer for a whole
 * PLC cycle the machine stops. */
#define POLYTURN_PLC_INT0_MOST 64u
typedef struct PolyturnPlcInt0Host {
    uint32_t api;
    /* For init() of the task only. Its place in `read` or `write`; -1: there is no such signal or
     * input, or no room. */
    int32_t (*read_signal)(const char* name, uint32_t instance); /* one that the NC writes */
    int32_t (*read_input)(uint32_t number);                      /* digital input, from 0 */
    int32_t (*write_signal)(const char* name, uint32_t instance);
} PolyturnPlcInt0Host;
typedef struct PolyturnPlcInt0 {
    /* Behind the PLC's own init(), with the same state. 0: ready; otherwise the PLC is not started,
     * *why says the reason. */
    int (*init)(void* state, const PolyturnPlcInt0Host* host, const char** why);
    void (*run)(void* state, int64_t tick, const int32_t* read, int32_t* write);
} PolyturnPlcInt0;
#define POLYTURN_PLC_INT0_SYMBOL "polyturn_plc_int0"
typedef const PolyturnPlcInt0* (*PolyturnPlcInt0Function)(void);

#ifdef __cplusplus
}
#endif
#endif
