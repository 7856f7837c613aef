// The built-in lathe PLC behind the interface that any builder's PLC has.
#include <new>
#include <type_traits>

#include "kernel/plc/lathe/lathe_plc.hpp"

using polyturn::plc::LathePlc;
static_assert(std::is_trivially_destructible_v<LathePlc>,
              "polyturn-plc frees the state without asking");

namespace {

int init(void* state, const PolyturnPlcHost* host, const char** why) {
    auto* plc = new (state) LathePlc;
    *why = plc->resolve(*host);
    return *why ? 1 : 0;
}

void cycle(void* state, const PolyturnPlcInputs* inputs, PolyturnPlcOutputs* outputs) {
    static_cast<LathePlc*>(state)->cycle(*inputs, *outputs);
}

const PolyturnPlc kLathe{POLYTURN_PLC_API, "Polyturn lathe", sizeof(LathePlc), init, cycle};

int init_fast(void* state, const PolyturnPlcInt0Host* host, const char** why) {
    *why = static_cast<LathePlc*>(state)->resolve_fast(*host);
    return *why ? 1 : 0;
}

void run_fast(void* state, std::int64_t, const std::int32_t* read, std::int32_t* write) {
    static_cast<const LathePlc*>(state)->run_fast(read, write);
}

const PolyturnPlcInt0 kInt0{init_fast, run_fast};

const PolyturnPlcRetained kKept = LathePlc::retained();

}  // namespace

extern "C" __attribute__((visibility("default"))) const PolyturnPlcInt0* polyturn_plc_int0(void) {
    return &kInt0;
}
extern "C" __attribute__((visibility("default"))) const PolyturnPlcRetained* polyturn_plc_retained(
    void) {
    return &kKept;
}
extern "C" __attribute__((visibility("default"))) const PolyturnPlc* polyturn_plc(void) {
    return &kLathe;
}
