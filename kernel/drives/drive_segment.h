/* Drives in a process of their own: a field bus master, an analog card, an emulator. Plain C, as
 * drive.h.
 *
 *   kernel --/dev/shm/polyturn.<instance>.drives--> drive process
 *              setups, then a frame of commands each cycle
 *          <--/dev/shm/polyturn.<instance>.slaves--
 *              a frame of statuses each cycle
 *
 * Each of the two files has one writer; the other side maps it read-only. Nobody locks: a frame is
 * written into the half that is not published, then its number is stored (release). P1, P5, P6
 * below: docs/design/memory-orders.md. Slot a - 1 is axis a, slot 96 + s - 1 spindle s.
 *
 * One cycle (N0005):
 *   1. the kernel publishes commands n at the end of its tick n and raises `bell` (a futex word),
 *   2. the drive process takes them and moves its drives by them over tick n,
 *   3. it publishes statuses n: positions as they are when tick n + 1 begins,
 *   4. the kernel takes the newest statuses as its tick n + 1 begins.
 * Statuses that are older than n then are lost cycles: the kernel goes on with the last speed for
 * PT_DRIVE_LOST cycles, then it is an emergency stop. A drive that hears no new command for as long
 * must stop by itself. In virtual time (`is_virtual`) the kernel waits for statuses n, however long
 * that takes; so each command must be answered.
 *
 * Start: `polyturn` starts the program `drives` of the machine's folder (or its own emulator,
 * polyturn-drives) with --instance NAME once the command segment is there. It makes the other one,
 * answers the first command, and ends by SIGTERM. */
#ifndef POLYTURN_KERNEL_DRIVES_DRIVE_SEGMENT_H
#define POLYTURN_KERNEL_DRIVES_DRIVE_SEGMENT_H
#include <limits.h>
#include <linux/futex.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "drive.h"
#ifdef __cplusplus
extern "C" {
#endif

#define POLYTURN_DRIVES_MAGIC 0x534556495244544EULL
#define POLYTURN_DRIVE_AXES 96u
#define POLYTURN_DRIVE_SLOTS 128u

typedef struct PolyturnCommandFrame {
    uint64_t cycle;
    PolyturnDriveCommand command[POLYTURN_DRIVE_SLOTS];
} PolyturnCommandFrame;

typedef struct PolyturnDriveCommands {        /* written by the kernel only */
    uint64_t magic;
    uint32_t version;                         /* POLYTURN_DRIVE_VERSION */
    uint32_t size;                            /* of this structure */
    int32_t writer_pid;
    uint32_t is_virtual;
    uint64_t tick_ns;
    uint32_t ready;                           /* 1 when all before `bell` is written */
    uint32_t reserved;
    PolyturnDriveSetup setup[POLYTURN_DRIVE_SLOTS];   /* version 0: there is no such drive */
    uint32_t bell;
    uint32_t reserved2;
    uint64_t cycle;                           /* newest complete frame: frame[cycle & 1]; 0 none */
    PolyturnCommandFrame frame[2];
} PolyturnDriveCommands;

typedef struct PolyturnStatusFrame {
    uint64_t cycle;
    uint64_t answers[POLYTURN_DRIVE_SLOTS];   /* cycle that each drive's status is from */
    PolyturnDriveStatus status[POLYTURN_DRIVE_SLOTS];
} PolyturnStatusFrame;

typedef struct PolyturnDriveStatuses {        /* written by the drive process only */
    uint64_t magic;
    uint32_t version;
    uint32_t size;
    int32_t writer_pid;
    uint32_t ready;
    uint32_t bell;
    uint32_t reserved;
    uint64_t cycle;                           /* newest complete frame; commands so far are seen */
    PolyturnStatusFrame frame[2];
} PolyturnDriveStatuses;

/* The newest commands, whole; 0 when there are none newer than *seen. */
static inline int polyturn_take_commands(const PolyturnDriveCommands* from, uint64_t* seen,
                                         PolyturnCommandFrame* out) {
    int tries;
    for (tries = 0; tries < 3; ++tries) {
        /* P1: the frame is complete */
        const uint64_t cycle = __atomic_load_n(&from->cycle, __ATOMIC_ACQUIRE);
        if (cycle == *seen) return 0;
        memcpy(out, &from->frame[cycle & 1u], sizeof *out);
        /* P5: the copy counts when nobody has begun to write over the frame */
        __atomic_thread_fence(__ATOMIC_ACQUIRE);
        if (__atomic_load_n(&from->cycle, __ATOMIC_RELAXED) == cycle) {
            *seen = cycle;
            return 1;
        }
    }
    return 0;
}
/* Sleeps until the bell is no more what it was, at most so long; wakes all who sleep there. */
static inline void polyturn_bell_wait(const uint32_t* bell, uint32_t seen, int64_t timeout_us) {
    struct timespec limit;
    limit.tv_sec = (time_t)(timeout_us / 1000000);
    limit.tv_nsec = (long)(timeout_us % 1000000) * 1000;
    syscall(SYS_futex, bell, FUTEX_WAIT, seen, &limit, (void*)0, 0);
}
static inline void polyturn_bell_wake(const uint32_t* bell) {
    syscall(SYS_futex, bell, FUTEX_WAKE, INT_MAX, (void*)0, (void*)0, 0);
}
static inline void polyturn_put_statuses(PolyturnDriveStatuses* to,
                                         const PolyturnStatusFrame* frame) {
    /* P5: the frame is written behind the number of before: else a reader could miss it */
    __atomic_thread_fence(__ATOMIC_RELEASE);
    memcpy(&to->frame[frame->cycle & 1u], frame, sizeof *frame);
    /* P1: the frame, then its number. P6: then the bell */
    __atomic_store_n(&to->cycle, frame->cycle, __ATOMIC_RELEASE);
    __atomic_fetch_add(&to->bell, 1u, __ATOMIC_RELEASE);
    polyturn_bell_wake(&to->bell);
}

#ifdef __cplusplus
}
#endif
#endif
