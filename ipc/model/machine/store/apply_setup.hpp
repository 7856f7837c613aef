// What a setup enters into the store of one channel: offsets, zeros, kept variables. Done alike by
// the store itself and by the channel in check mode, so that a program finds the same tables in
// both. Values are taken as the file has them, which is how the tables show and hold them:
// millimetres and degrees, X as a diameter where the axis is a diameter axis.
#pragma once

#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/setup.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

// An empty store: all zero, variables empty, offset 0 zero.
void clear_channel_store(ChannelStore& store);

// Enters what the setup says about channel `number`; everything that does not fit the machine is
// diagnosed (PT0920) and left out. Variables that are not kept (#1..#499, inputs ...) are not this
// function's: the channel takes them itself.
void apply_setup(const text::Setup& setup, const MachineConfig& machine, unsigned number,
                 ChannelStore& store, std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn
