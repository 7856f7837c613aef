#include "kernel/plc/builder_plc.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "ipc/image/segments.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/model/files/regular_file.hpp"

namespace polyturn::plc {

namespace {

constexpr std::size_t kLargestState = 256u << 20;

// What init() may ask. The C interface has no place for a context: one init() at a time, in one
// thread.
const params::Table* asked_parameters = nullptr;
// Nor have the functions that cycle() may call: one PLC in a process.
PlcMemory* memory_in_use = nullptr;

std::size_t instances_of(SignalScope scope) {
    switch (scope) {
        case SignalScope::Global:
            return 1;
        case SignalScope::Channel:
            return kMaxChannels;
        case SignalScope::Axis:
            return kMaxAxes;
        case SignalScope::Spindle:
            return kMaxSpindles;
    }
    return 0;
}

std::int32_t slot(SignalWriter writer, const char* name, std::uint32_t instance) {
    for (const SignalRow& row : signal_rows()) {
        if (row.writer != writer || row.name != name) continue;
        if (row.scope == SignalScope::Global) instance = 1;
        if (instance < 1 || instance > instances_of(row.scope)) return -1;
        return static_cast<std::int32_t>(row.slot + instance - 1);
    }
    return -1;
}

// Of the fast task, likewise while its init() runs.
PlcFastPlan* asked_plan = nullptr;

// A signal that is asked for again has the place it has.
std::int32_t place(std::array<std::uint32_t, kFastSignals>& slots, std::uint32_t& count,
                   std::uint32_t slot) {
    const auto end = slots.begin() + count;
    const auto there = std::find(slots.begin(), end, slot);
    if (there == end && count == slots.size()) return -1;
    if (there == end) slots[count++] = slot;
    return static_cast<std::int32_t>(there - slots.begin());
}

int parameter(const char* number, std::uint32_t instance, double* value) {
    const params::Row* row = params::find(number);
    if (!row || row->type == params::Type::Text || !asked_parameters) return 0;
    if (row->scope == params::Scope::Global) instance = 1;
    if (instance < 1 || instance > params::instances(row->scope)) return 0;
    *value = asked_parameters->numbers[row->first_slot + (instance - 1) * row->array];
    return 1;
}

Diagnosis fault(Alarm alarm, const std::string& library, std::string why) {
    // dlerror() names the file too
    if (why.rfind(library + ": ", 0) == 0) why.erase(0, library.size() + 2);
    return Diagnosis{alarm, Place{library, 0, 0, 0}, {}, std::move(why)};
}

}  // namespace

void BuilderPlc::Free::operator()(void* memory) const noexcept { std::free(memory); }

Result<BuilderPlc> BuilderPlc::load(const std::string& library) {
    // dlopen() would wait for the writer of a pipe. It opens by name once more: the folder is the
    // machine builder's own.
    if (auto file = text::RegularFile::open(library, text::kLargestLibrary); !file)
        return fault(Alarm::PlcLoad, library, file.diagnosis().detail);
    void* object = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!object) return fault(Alarm::PlcLoad, library, dlerror());
    const auto describe = reinterpret_cast<PolyturnPlcFunction>(dlsym(object, POLYTURN_PLC_SYMBOL));
    if (!describe)
        return fault(Alarm::PlcLoad, library, "exports no function " POLYTURN_PLC_SYMBOL);
    BuilderPlc out;
    out.library_ = library;
    out.plc_ = describe();
    if (!out.plc_)
        return fault(Alarm::PlcLoad, library, POLYTURN_PLC_SYMBOL " gave no description");
    if (out.plc_->api != POLYTURN_PLC_API)
        return fault(Alarm::PlcVersion, library,
                     "built for interface " + std::to_string(out.plc_->api) + ", this is " +
                         std::to_string(POLYTURN_PLC_API));
    if (!out.plc_->name || !out.plc_->init || !out.plc_->cycle ||
        out.plc_->state_size > kLargestState)
        return fault(Alarm::PlcLoad, library, "its description is incomplete");
    if (const auto keeps = reinterpret_cast<PolyturnPlcRetainedFunction>(
            dlsym(object, POLYTURN_PLC_RETAINED_SYMBOL)))
        if (const PolyturnPlcRetained* what = keeps()) {
            if (what->offset > out.plc_->state_size ||
                what->size > out.plc_->state_size - what->offset)
                return fault(Alarm::PlcLoad, library,
                             "what it wants kept does not lie in its state");
            out.retained_ = *what;
        }
    if (const auto fast =
            reinterpret_cast<PolyturnPlcInt0Function>(dlsym(object, POLYTURN_PLC_INT0_SYMBOL))) {
        out.int0_ = fast();
        if (!out.int0_ || !out.int0_->init || !out.int0_->run)
            return fault(Alarm::PlcLoad, library, POLYTURN_PLC_INT0_SYMBOL " gave no fast task");
    }
    return out;
}

Result<void> BuilderPlc::init_fast() {
    plan_ = {};
    if (!int0_) return {};
    const PolyturnPlcInt0Host host{
        POLYTURN_PLC_API,
        [](const char* name, std::uint32_t instance) {
            const std::int32_t at = slot(SignalWriter::Nc, name, instance);
            return at < 0
                       ? -1
                       : place(asked_plan->read, asked_plan->reads, static_cast<std::uint32_t>(at));
        },
        [](std::uint32_t number) {
            return number < kInputs
                       ? place(asked_plan->read, asked_plan->reads, kFastInput + number)
                       : -1;
        },
        [](const char* name, std::uint32_t instance) {
            const std::int32_t at = slot(SignalWriter::Plc, name, instance);
            return at < 0 ? -1
                          : place(asked_plan->write, asked_plan->writes,
                                  static_cast<std::uint32_t>(at));
        }};
    asked_plan = &plan_;
    const char* why = nullptr;
    const int status = int0_->init(state_.get(), &host, &why);
    asked_plan = nullptr;
    if (status != 0)
        return fault(Alarm::PlcStart, library_, why ? why : "its fast task gave no reason");
    return {};
}

Result<void> BuilderPlc::init(const params::Table& parameters, double tick_s, PlcMemory& memory) {
    const std::size_t size = (plc_->state_size + 63) / 64 * 64 + 64;
    state_.reset(std::aligned_alloc(64, size));
    if (!state_) return fault(Alarm::PlcStart, library_, "no memory for its state");
    std::memset(state_.get(), 0, size);
    const PolyturnPlcHost host{POLYTURN_PLC_API,
                               kMaxChannels,
                               kMaxAxes,
                               kMaxSpindles,
                               kInputs,
                               tick_s,
                               [](const char* name, std::uint32_t instance) {
                                   return slot(SignalWriter::Nc, name, instance);
                               },
                               [](const char* name, std::uint32_t instance) {
                                   return slot(SignalWriter::Plc, name, instance);
                               },
                               parameter,
                               [](std::uint32_t block, void* to, std::size_t length) {
                                   return memory_in_use->read(block, to, length);
                               },
                               [](std::uint32_t block, const void* from, std::size_t length) {
                                   return memory_in_use->write(block, from, length);
                               }};
    memory_in_use = &memory;
    asked_parameters = &parameters;
    const char* why = nullptr;
    const int status = plc_->init(state_.get(), &host, &why);
    asked_parameters = nullptr;
    if (status != 0) return fault(Alarm::PlcStart, library_, why ? why : "it gave no reason");
    return init_fast();
}

void BuilderPlc::fast(const PlcFastInputs& inputs, PlcFastOutputs& outputs) {
    int0_->run(state_.get(), inputs.tick, inputs.value.data(), outputs.value.data());
}

std::span<std::byte> BuilderPlc::retained() const {
    if (!state_ || retained_.size == 0) return {};
    return {static_cast<std::byte*>(state_.get()) + retained_.offset, retained_.size};
}

void BuilderPlc::cycle(const PlcInputs& inputs, PlcOutputs& outputs) {
    const PolyturnPlcInputs in{inputs.cycle, inputs.tick, inputs.signal.data(),
                               inputs.input.data()};
    PolyturnPlcOutputs out{outputs.signal.data(), outputs.output.data()};
    plc_->cycle(state_.get(), &in, &out);
}

}  // namespace polyturn::plc
