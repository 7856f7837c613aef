/* The smallest useful drive process: all axes and spindles of an instance with PT_DRIVE 2, moving
 * exactly as they are told. A field bus master has its cycle where this one has turn().
 *
 *   cc -std=gnu11 -I kernel/drives examples/drives/minimal_process.c -o MACHINE/drives
 *
 * and PT_DRIVE A1=2. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

#include "drive_segment.h"

static void* map(const char* instance, const char* name, size_t size, int create) {
    char path[128];
    snprintf(path, sizeof path, "/polyturn.%s.%s", instance, name);
    if (create) shm_unlink(path); /* a dead predecessor's */
    const int file = shm_open(path, create ? O_RDWR | O_CREAT | O_EXCL : O_RDONLY, 0660);
    if (file < 0 || (create && ftruncate(file, (off_t)size) != 0)) return NULL;
    void* at = mmap(NULL, size, create ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, file, 0);
    close(file);
    return at == MAP_FAILED ? NULL : at;
}

static uint16_t next_state(uint16_t state, uint16_t control) {
    switch (control & 0x0Fu) {
        case POLYTURN_DRIVE_SHUTDOWN: return POLYTURN_DRIVE_READY;
        case POLYTURN_DRIVE_SWITCH_ON:
            return state == POLYTURN_DRIVE_SWITCH_ON_DISABLED ? state : POLYTURN_DRIVE_SWITCHED_ON;
        case POLYTURN_DRIVE_ENABLE:
            return state == POLYTURN_DRIVE_SWITCHED_ON || state == POLYTURN_DRIVE_OPERATING
                       ? POLYTURN_DRIVE_OPERATING
                       : state;
        default: return POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    }
}

int main(int argc, char** argv) {
    static PolyturnCommandFrame commands;
    static PolyturnStatusFrame statuses;
    static double position[POLYTURN_DRIVE_SLOTS];
    const PolyturnDriveCommands* in = NULL;
    if (argc != 3) return 2; /* --instance NAME */
    for (int waited = 0; waited < 20000; ++waited, usleep(1000)) {
        if (!in) in = map(argv[2], "drives", sizeof *in, 0);
        if (in && __atomic_load_n(&in->ready, __ATOMIC_ACQUIRE)) break;
    }
    if (!in || in->version != POLYTURN_DRIVE_VERSION) return 2;
    PolyturnDriveStatuses* out = map(argv[2], "slaves", sizeof *out, 1);
    if (!out) return 2;
    out->magic = POLYTURN_DRIVES_MAGIC;
    out->version = POLYTURN_DRIVE_VERSION;
    out->size = sizeof *out;
    out->writer_pid = getpid();
    for (unsigned i = 0; i < POLYTURN_DRIVE_SLOTS; ++i) {
        statuses.status[i].status = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
        position[i] = (double)in->setup[i].start_position;
    }
    __atomic_store_n(&out->ready, 1u, __ATOMIC_RELEASE);
    for (uint64_t seen = 0;;) {
        const uint32_t bell = __atomic_load_n(&in->bell, __ATOMIC_ACQUIRE);
        if (!polyturn_take_commands(in, &seen, &commands)) {
            polyturn_bell_wait(&in->bell, bell, 5000);
            continue;
        }
        for (unsigned i = 0; i < POLYTURN_DRIVE_SLOTS; ++i) {
            const PolyturnDriveCommand* command = &commands.command[i];
            PolyturnDriveStatus* status = &statuses.status[i];
            status->status = next_state(status->status, command->control);
            if (status->status == POLYTURN_DRIVE_OPERATING) {
                if (command->mode == POLYTURN_DRIVE_MODE_POSITION)
                    position[i] = (double)command->target_position;
                else position[i] += (double)command->target_velocity * 1e-3 * in->setup[i].tick_s;
            }
            status->position = (int64_t)position[i]; /* as the next cycle begins */
            status->brake_open = command->brake_release;
            statuses.answers[i] = seen;
        }
        statuses.cycle = seen;
        polyturn_put_statuses(out, &statuses);
    }
}
