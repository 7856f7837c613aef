#include "kernel/tick/table_watch.hpp"

#include "ipc/memory/segment.hpp"

namespace polyturn::kernel {

TableWatch::TableWatch(std::string file, const StoreSegment& store, Core& core)
    : file_(std::move(file)), store_(store), core_(core) {
    seen_ = settled_ = stamp();
}

TableWatch::Stamp TableWatch::stamp() const {
    Stamp out;
    std::error_code none;
    out.size = std::filesystem::file_size(file_, none);
    out.there = !none;
    if (out.there) out.when = std::filesystem::last_write_time(file_, none);
    return out;
}

bool TableWatch::look() {
    const Stamp now = stamp();
    if (now == settled_) return false;
    // perhaps it is still being written: once more the same
    if (!(now == seen_)) {
        seen_ = now;
        return false;
    }
    // the last one waits for the axes to rest
    // P7: taken
    if (core_.next_compensation.load(std::memory_order_acquire) != nullptr) return false;
    settled_ = now;
    std::vector<Diagnosis> faults;
    auto tables = std::make_unique<CompensationTables>(load_compensation(file_, faults));
    const auto parameters = std::make_unique<params::Table>();
    while (!store_.parameters.read(*parameters)) sleep_ms(1);
    check_compensation_tables(*parameters, *tables, file_, faults);
    if (!faults.empty()) {
        // P3: a flag, announces nothing (the order is stronger than needed)
        core_.compensation_refused.store(true, std::memory_order_release);
        return true;
    }
    // P7: offered, complete
    core_.next_compensation.store(tables.get(), std::memory_order_release);
    handed_.push_back(std::move(tables));
    // what was taken before the last one is no longer looked at
    if (handed_.size() > 2) handed_.erase(handed_.begin());
    return true;
}

void TableWatch::run(const std::atomic<bool>& stop) {
    constexpr int kLookMs = 100;
    // P3: a flag (the order is stronger than needed)
    while (!stop.load(std::memory_order_acquire)) {
        sleep_ms(kLookMs);
        (void)look();
    }
}

}  // namespace polyturn::kernel
