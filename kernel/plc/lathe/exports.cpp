// The built-in lathe PLC behind the interface that any builder's PLC has.
#include <new>
#include <type_traits>

#include "kernel/plc/lathe/lathe_plc.hpp"

using polyturn::plc::LathePlc;
static_assert(std::is_trivially_destructible_v<LathePlc>, "polyturn-plc frees the state without asking");

namespace {

int init(void* state, const PolyturnPlcHost* host, const char** why) {
    auto* plc = new (state) LathePlc;
    *why = plc->resolve(*host);
    return *why ? 1 : 0;
}

void cycle(void* state, const PolyturnPlcInputs* inputs, PolyturnPlcOutputs* outputs) { static_cast<LathePlc*>(state)->cycle(*inputs, *outputs); }

const PolyturnPlc kLathe{POLYTURN_PLC_API, "Polyturn lathe", sizeof(LathePlc), init, cycle};

const PolyturnPlcRetained kKept = LathePlc::retained();

}  // namespace

extern "C" __attribute__((visibility("default"))) const PolyturnPlcRetained* polyturn_plc_retained(void) { return &kKept; }
extern "C" __attribute__((visibility("default"))) const PolyturnPlc* polyturn_plc(void) { return &kLathe; }
