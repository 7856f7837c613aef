/* The smallest useful drive.so: an axis that moves exactly as it is told, one cycle later. Put what
 * talks to your hardware where turn() is; the state machine is what every CiA 402 drive does.
 *
 *   cc -shared -fPIC -I kernel/drives examples/drives/minimal_drive.c -o MACHINE/drive.so
 *
 * and PT_DRIVE A1=1. */
#include <stdlib.h>

#include "drive.h"

typedef struct Drive {
    PolyturnDriveSetup setup;
    uint16_t state;
    double position; /* increments */
} Drive;

static void* open_drive(const PolyturnDriveSetup* setup) {
    if (setup->version != POLYTURN_DRIVE_VERSION) return NULL;
    Drive* drive = calloc(1, sizeof *drive);
    if (!drive) return NULL;
    drive->setup = *setup;
    drive->state = POLYTURN_DRIVE_SWITCH_ON_DISABLED;
    drive->position = (double)setup->start_position;
    return drive;
}

static void close_drive(void* memory) { free(memory); }

/* A state at a time: 06h ready, 07h switched on, 0Fh operating. */
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

static void turn(Drive* drive, const PolyturnDriveCommand* command) {
    if (command->mode == POLYTURN_DRIVE_MODE_POSITION)
        drive->position = (double)command->target_position;
    else drive->position += (double)command->target_velocity * 1e-3 * drive->setup.tick_s;
}

static void exchange(void* memory, const PolyturnDriveCommand* command,
                     PolyturnDriveStatus* status) {
    Drive* drive = memory;
    drive->state = next_state(drive->state, command->control);
    const PolyturnDriveStatus nothing = {0};
    *status = nothing;
    status->status = drive->state;
    status->position = (int64_t)drive->position; /* as this exchange begins */
    status->brake_open = command->brake_release;
    if (drive->state == POLYTURN_DRIVE_OPERATING) turn(drive, command);
}

const PolyturnDriveApi* polyturn_drive_api(void) {
    static const PolyturnDriveApi api = {POLYTURN_DRIVE_VERSION, open_drive, close_drive, exchange};
    return &api;
}
