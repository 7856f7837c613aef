/* The one interface behind which every drive lies (architecture 5.11): field bus, analog card or
 * simulation. Plain C, so that a machine builder's shared object can provide it; words, states and
 * modes are those of CiA 402.
 *
 * Each tick the kernel calls exchange() once: it hands over the command for the tick that begins
 * and takes what the drive measured. exchange() runs in the cyclic thread: it must not allocate,
 * lock, or enter the system. Increments are whole numbers; the kernel carries the remainder of its
 * doubles, so nothing is lost however long it runs. */
#ifndef POLYTURN_KERNEL_DRIVES_DRIVE_H
#define POLYTURN_KERNEL_DRIVES_DRIVE_H
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

#define POLYTURN_DRIVE_VERSION 5u

/* Control word (object 6040h). */
#define POLYTURN_DRIVE_SHUTDOWN 0x0006u
#define POLYTURN_DRIVE_SWITCH_ON 0x0007u
#define POLYTURN_DRIVE_ENABLE 0x000Fu
#define POLYTURN_DRIVE_QUICK_STOP 0x000Bu   /* bit 2 low: stop by the drive's own ramp */
#define POLYTURN_DRIVE_FAULT_RESET 0x0080u  /* rising edge */
#define POLYTURN_DRIVE_START_HOMING 0x0010u /* mode homing; rising edge */

/* Status word (object 6041h), under POLYTURN_DRIVE_STATE_MASK. */
#define POLYTURN_DRIVE_STATE_MASK 0x006Fu
#define POLYTURN_DRIVE_SWITCH_ON_DISABLED 0x0040u
#define POLYTURN_DRIVE_READY 0x0021u
#define POLYTURN_DRIVE_SWITCHED_ON 0x0023u
#define POLYTURN_DRIVE_OPERATING 0x0027u
#define POLYTURN_DRIVE_QUICK_STOPS 0x0007u
#define POLYTURN_DRIVE_FAULT_REACTION 0x000Fu
#define POLYTURN_DRIVE_FAULT 0x0008u
#define POLYTURN_DRIVE_HOMED 0x1000u        /* mode homing: attained; position counts from there */
#define POLYTURN_DRIVE_HOMING_FAILED 0x2000u

/* Modes of operation (object 6060h). */
#define POLYTURN_DRIVE_MODE_VELOCITY 9 /* cyclic synchronous velocity; the kernel closes the loop */
#define POLYTURN_DRIVE_MODE_POSITION 8 /* cyclic synchronous position */
#define POLYTURN_DRIVE_MODE_HOMING 6   /* the drive finds its zero by itself (N0900 = 24) */

/* Touch probe function (60B8h) and status (60B9h): bit 0 probe 1 armed / seen. */
#define POLYTURN_DRIVE_PROBE_ARMED 0x0001u
/* Trigger by the encoder's zero pulse or the next mark of a distance-coded scale; seen:
 * probe_position is the latched one, for the one exchange that follows its passing. */
#define POLYTURN_DRIVE_MARK_ARMED 0x0004u
#define POLYTURN_DRIVE_MARK_SEEN 0x0004u

/* What a simulated drive is to play (`set drive A3=...`). */
#define POLYTURN_SIMULATE_FAULT 1u
#define POLYTURN_SIMULATE_ENCODER_FAULT 2u
#define POLYTURN_SIMULATE_SILENCE 3u        /* it answers no more */
#define POLYTURN_SIMULATE_DEAD 4u           /* no supply: it never gets beyond switch on disabled */
#define POLYTURN_SIMULATE_DELAY 0x0100u     /* + n: its answers come n cycles late */
#define POLYTURN_SIMULATE_LOSES 0x0200u     /* + n: each n-th answer is lost */

typedef struct PolyturnDriveCommand {
    uint16_t control;
    int8_t mode;
    uint8_t brake_release;        /* 1: the holding brake may open */
    uint16_t torque_limit;        /* thousandths of the rated torque */
    uint16_t touch_probe;
    int64_t target_velocity;      /* thousandths of an increment per second */
    int64_t target_position;      /* increments; mode position only */
    uint16_t simulate;            /* POLYTURN_SIMULATE_...; a real drive ignores it */
    uint16_t reserved[3];
} PolyturnDriveCommand;

typedef struct PolyturnDriveStatus {
    uint16_t status;
    uint16_t error_code;          /* 603Fh, 0 none */
    uint16_t touch_probe;
    uint8_t brake_open;
    uint8_t limited;              /* 1: it gives no more torque than torque_limit */
    int64_t position;             /* increments, latched as exchange() begins, used a tick later */
    int64_t probe_position;       /* increments */
    int16_t torque;               /* 6077h, thousandths of the rated torque */
    uint16_t lost;                /* cycles that this answer is older than usual: the position is
                                     extrapolated; 0: new */
    int16_t reserved[2];
} PolyturnDriveStatus;

typedef struct PolyturnDriveSetup {
    uint32_t version;             /* POLYTURN_DRIVE_VERSION of the kernel */
    uint32_t number;              /* axis or spindle, from 1 */
    double tick_s;
    double increments_per_unit;   /* millimetre, degree or revolution */
    int64_t start_position;       /* simulated drives begin there */
    /* What follows concerns simulated drives only. */
    double frequency_hz, damping; /* how their speed follows the command */
    double backlash;              /* play between motor and slide, units */
    double friction;              /* standing, it does not break away below this command, units/s */
    double drift;                 /* speed without a command, units/s */
    double mark_distance;         /* units between zero pulses, or between the fixed marks of a
                                     coded scale; 0 none */
    double mark_periods;          /* coded scale: signal periods between fixed marks; 0 none */
    double mark_origin;           /* position of a mark, units; of the scale's zero */
    double stop_at;               /* an obstacle that the slide cannot push away going up; 0 with
                                     has_stop 0 */
    double hold_at;               /* once the slide was above it, it is held there going down; 0
                                     with has_hold 0 */
    uint8_t at_slide;             /* 1: measured behind the play */
    uint8_t motor_reversed, encoder_reversed;  /* wired so: the kernel's signs undo it */
    uint8_t has_stop, has_hold;
    uint8_t reserved[3];
} PolyturnDriveSetup;

typedef struct PolyturnDriveApi {
    uint32_t version;
    void* (*open)(const PolyturnDriveSetup* setup);  /* NULL when it cannot */
    void (*close)(void* drive);
    void (*exchange)(void* drive, const PolyturnDriveCommand* command, PolyturnDriveStatus* status);
} PolyturnDriveApi;

/* A fault, or on the way into it: bit 5 (quick stop) says nothing there. */
static inline int polyturn_drive_has_fault(uint16_t status) {
    return (status & 0x004Fu) == POLYTURN_DRIVE_FAULT ||
           (status & 0x004Fu) == POLYTURN_DRIVE_FAULT_REACTION;
}
static inline int polyturn_drive_operates(uint16_t status) {
    return (status & POLYTURN_DRIVE_STATE_MASK) == POLYTURN_DRIVE_OPERATING;
}
/* The next control word on the way to operation, a state at a time; off: voltage disabled by way of
 * ready. */
static inline uint16_t polyturn_drive_next(uint16_t status, int on) {
    if (!on) return POLYTURN_DRIVE_SHUTDOWN;
    switch (status & POLYTURN_DRIVE_STATE_MASK) {
        case POLYTURN_DRIVE_READY: return POLYTURN_DRIVE_SWITCH_ON;
        case POLYTURN_DRIVE_SWITCHED_ON:
        case POLYTURN_DRIVE_OPERATING: return POLYTURN_DRIVE_ENABLE;
        default: return POLYTURN_DRIVE_SHUTDOWN;
    }
}

/* A builder's shared object exports this. */
const PolyturnDriveApi* polyturn_drive_api(void);

#ifdef __cplusplus
}
#endif
#endif
