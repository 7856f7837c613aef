// A machine builder's PLC in this process: the shared object, its state, and the slots and
// parameters it asks for.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/params/table.hpp"
#include "kernel/plc/plc_api.h"
#include "kernel/plc/plc_memory.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::plc {

class BuilderPlc {
public:
    // Loads the object; it stays loaded while the process lives (its code may have registered
    // whatever it likes).
    static Result<BuilderPlc> load(const std::string& library);
    // Fresh state, then the builder's init().
    // memory: of the two functions that read and write it; it lives as long as the PLC runs.
    Result<void> init(const params::Table& parameters, double tick_s, PlcMemory& memory);
    void cycle(const PlcInputs& inputs, PlcOutputs& outputs);
    // The fast task: what it reads and writes (after init(); writes 0: there is none), and one call
    // of it.
    const PlcFastPlan& fast_plan() const { return plan_; }
    void fast(const PlcFastInputs& inputs, PlcFastOutputs& outputs);
    const char* name() const { return plc_->name; }
    // What of its state survives power-off; empty: nothing, or before init().
    std::span<std::byte> retained() const;

private:
    struct Free {
        void operator()(void* memory) const noexcept;
    };
    const PolyturnPlc* plc_ = nullptr;
    Result<void> init_fast();

    PolyturnPlcRetained retained_{};
    const PolyturnPlcInt0* int0_ = nullptr;
    PlcFastPlan plan_{};
    std::string library_;
    std::unique_ptr<void, Free> state_;
};

}  // namespace polyturn::plc
