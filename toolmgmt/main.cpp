// polyturn-toolmgmt: the only writer of the store. Started by polyturn before kernel, PLC and
// channels, which read what it publishes. Exit status: 0 ended by SIGTERM, 1 the store cannot be
// used, 2 machine or setup cannot be read.
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#include <optional>

#include "ipc/memory/life_line.hpp"
#include "ipc/memory/segment.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/operations/backup_files.hpp"
#include "toolmgmt/options.hpp"
#include "toolmgmt/service.hpp"
#include "toolmgmt/start_values.hpp"

namespace {

using namespace polyturn;
using namespace polyturn::toolmgmt;

// P3: a flag, announces nothing
std::atomic<bool> stop{false};

void catch_signals() {
    struct sigaction action {};
    action.sa_handler = [](int) { stop = true; };
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);
    // A full disk or a closed standard error is a diagnosis, not an end.
    action.sa_handler = SIG_IGN;
    sigaction(SIGXFSZ, &action, nullptr);
    sigaction(SIGPIPE, &action, nullptr);
}

void complain(const Diagnosis& diagnosis) {
    std::fprintf(stderr, "polyturn-toolmgmt: %s", render(diagnosis, Dialect::Polyturn, "").c_str());
}

// A store that cannot be used any more comes back from a backup; nothing may run on it.
int restore_offline(const Options& options) {
    std::string file = options.restore;
    if (file == "newest") {
        auto newest = newest_good_backup(options.store);
        if (!newest) {
            complain(newest.diagnosis());
            return 2;
        }
        file = *newest;
    }
    {
        auto in_use = Database::open(options.store);
        if (!in_use && in_use.diagnosis().alarm == Alarm::StoreBusy) {
            complain(in_use.diagnosis());
            return 2;
        }
    }
    std::vector<Database::File> files;
    {
        // Everything is checked before anything is written.
        auto values = std::make_unique<StoreValues>();
        clear(*values);
        std::vector<Diagnosis> warnings;
        if (const Result<void> read = Database::read_backup(file, *values, files, warnings);
            !read) {
            complain(read.diagnosis());
            return 2;
        }
    }
    const RestoreTo to{options.machine_folder, options.store};
    std::vector<RestoredFile> targets;
    for (const auto& one : files) {
        auto judged = judge_file(one, to);
        if (!judged) {
            complain(judged.diagnosis());
            return 2;
        }
        if (judged->native && !options.with_plc && differs_from_disk(one, judged->target)) {
            complain({Alarm::BackupNative, {}, {}, judged->target});
            return 2;
        }
        targets.push_back(std::move(*judged));
    }
    files.clear();
    const auto kept = Database::put_back(options.store, file, files);
    if (!kept) {
        complain(kept.diagnosis());
        return 2;
    }
    std::printf("restored %s\n", file.c_str());
    if (!kept->empty()) std::printf("the old store is kept as %s\n", kept->c_str());
    for (std::size_t i = 0; i < std::min(files.size(), targets.size()); ++i) {
        if (!differs_from_disk(files[i], targets[i].target)) continue;
        if (const Result<void> put = put_file(targets[i], files[i].bytes); !put) {
            complain(put.diagnosis());
            return 2;
        }
        std::printf("restored %s\n", targets[i].target.c_str());
    }
    return 0;
}

// Production goes on with what is left of a damaged store: for whoever owns its files.
int confirm_offline(const Options& options) {
    auto disk = Database::open(options.store);
    if (!disk) {
        complain(disk.diagnosis());
        return 2;
    }
    if (disk->condition().unfit) complain(*disk->condition().unfit);
    if (const Result<void> done = disk->confirm(); !done) {
        complain(done.diagnosis());
        return 2;
    }
    std::printf("confirmed %s\n", options.store.c_str());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    if (options.exit_status >= 0) return options.exit_status;
    catch_signals();

    if (!options.restore.empty()) return restore_offline(options);
    if (options.confirm) return confirm_offline(options);

    end_with_kernel(options.instance);
    std::optional<Database> disk;
    if (!options.memory) {
        auto opened = Database::open(options.store);
        if (!opened) {
            complain(opened.diagnosis());
            return 1;
        }
        disk.emplace(std::move(*opened));
    }
    auto values = std::make_unique<StoreValues>();
    std::vector<Diagnosis> diagnoses;
    const Result<void> started =
        load_start_values(options, disk ? &*disk : nullptr, *values, diagnoses);
    for (const Diagnosis& diagnosis : diagnoses) complain(diagnosis);
    if (!started) {
        complain(started.diagnosis());
        return 1;
    }
    if (any_error(diagnoses)) return 2;

    auto supervisor =
        PeerSegment<SupervisorSegment>::attach(options.instance, 0, std::chrono::seconds(5));
    if (!supervisor) {
        complain(supervisor.diagnosis());
        return 1;
    }
    auto image = StoreImage::create(options.instance, (*supervisor)->header);
    if (!image) {
        complain(image.diagnosis());
        return 1;
    }

    Service service(options.instance, std::move(*supervisor), std::move(*image), *values,
                    disk ? &*disk : nullptr,
                    {options.machine_folder, options.memory ? std::string() : options.store});
    while (!stop)
        if (!service.step()) service.wait();
    service.finish();
    return 0;
}
