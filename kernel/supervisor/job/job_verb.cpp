#include "kernel/supervisor/job/job_verb.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/store/job_differences.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"

namespace polyturn::supervisor {

namespace {

// One value that the job wants otherwise than it is entered, and the operation of the store that
// enters it.
struct Entry {
    std::string name;                // "L1 G54 Z", "L2 3 wear X"
    double wanted = 0, entered = 0;  // NaN: this machine has no such place
    nlohmann::json operation;
};

class JobEntries {
public:
    // What is wrong with the job or with reaching the controller.
    static Result<JobEntries> read(const std::string& file, const std::string& instance) {
        auto job = text::load_job(file);
        if (!job) return job.diagnosis();
        text::Setup setup;
        if (!job->setup.empty()) {
            auto loaded = text::load_setup(job->setup);
            if (!loaded) return loaded.diagnosis();
            setup = std::move(*loaded);
        }
        const auto store = PeerSegment<StoreSegment>::attach(instance);
        if (!store) return store.diagnosis();
        const auto table = std::make_unique<params::Table>();
        if (!(*store)->parameters.read(*table))
            return Diagnosis{Alarm::SegmentNotReady, {}, {}, instance};
        const MachineConfig machine = derive_machine_config(*table);
        std::map<unsigned, std::unique_ptr<ChannelStore>> channels;
        const StoreOf store_of = [&](unsigned channel) -> const ChannelStore* {
            if (channel < 1 || channel > kMaxChannels) return nullptr;
            auto& own = channels[channel];
            if (!own) own = std::make_unique<ChannelStore>();
            return (*store)->channels[channel - 1].read(*own) ? own.get() : nullptr;
        };
        JobEntries out;
        for (const JobZero& zero : job_zeros(*job, setup, machine, store_of))
            if (!zero.same())
                out.entries_.push_back(
                    {fmt::format("L{} {} {}", zero.channel, zero.system, zero.axis),
                     zero.wanted,
                     zero.entered,
                     {{"do", "zeros.set"},
                      {"channel", std::to_string(zero.channel)},
                      {"zero", zero.system},
                      {"field", zero.axis},
                      {"value", fmt::format("{:.9f}", zero.wanted)}}});
        for (const JobOffset& offset : job_offsets(setup, machine, store_of))
            for (const JobOffset::Value& one : offset.values) {
                const char* table_name = one.wear ? "wear" : "geometry";
                if (one.same()) continue;
                out.entries_.push_back({fmt::format("L{} {} {} {}", offset.channel, offset.number,
                                                    table_name, one.name),
                                        one.wanted,
                                        one.entered,
                                        {{"do", "offsets.set"},
                                         {"channel", std::to_string(offset.channel)},
                                         {"number", std::to_string(offset.number)},
                                         {"table", table_name},
                                         {"field", std::string(one.name)},
                                         {"value", fmt::format("{:.9f}", one.wanted)}}});
            }
        return out;
    }

    const std::vector<Entry>& all() const { return entries_; }

private:
    std::vector<Entry> entries_;
};

void tell_entry(const Entry& entry) {
    if (std::isnan(entry.entered))
        print(fmt::format(fmt::runtime(say("{}: {:.4f}, which this machine does not have\n")),
                          entry.name, entry.wanted));
    else
        print(fmt::format("{}: {:.4f} -> {:.4f}\n", entry.name, entry.entered, entry.wanted));
}

}  // namespace

int job_verb(const JobVerbOptions& options) {
    const std::string instance = options.instance.empty() ? "polyturn" : options.instance;
    const std::string file = std::filesystem::absolute(options.file).string();
    // Selected first: that is refused while a program runs, and then nothing is entered either.
    if (options.action == "load" &&
        !ask(instance,
             nlohmann::json{{"do", "press"}, {"words", "select " + file}, {"folder", "/"}}.dump()))
        return 2;
    const auto entries = JobEntries::read(file, instance);
    if (!entries) return refuse(entries.diagnosis());
    bool all_entered = true;
    for (const Entry& entry : entries->all()) {
        const bool possible = !std::isnan(entry.entered);
        if (options.action == "load" && possible &&
            !ask(instance, nlohmann::json{{"do", "store"}, {"op", entry.operation}}.dump()))
            return 2;
        all_entered = all_entered && possible;
        tell_entry(entry);
    }
    if (entries->all().empty()) print(say("The zeros and offsets of the job are entered.\n"));
    return options.action == "diff" ? (entries->all().empty() ? 0 : 1) : all_entered ? 0 : 1;
}

}  // namespace polyturn::supervisor
