// What the scope has recorded: the kernel's samples kept for a minute, the trigger, the export; and
// the roundness of a circle that was driven. No widget: the screens draw it, tests ask it.
#pragma once
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "polyturn/image_structs.hpp"

namespace polyturn::hmi {

class ScopeRecord {
public:
    enum class Mode : std::uint8_t { Runs, Armed, Triggered, Stopped };
    struct Trigger {
        std::size_t trace = 0;
        double level = 0;
        bool rising = true;
    };
    static constexpr std::size_t kMost = 60'000;  // samples

    void add(const std::vector<ScopeSample>& fresh, double window_ticks);
    void clear();
    void run() { mode_ = Mode::Runs; }
    void stop() { mode_ = Mode::Stopped; }
    void arm() {
        clear();
        mode_ = Mode::Armed;
    }
    Mode mode() const { return mode_; }
    Trigger trigger;
    const std::deque<ScopeSample>& samples() const { return samples_; }
    std::int64_t triggeredAt() const { return at_; }  // tick; 0: it has not
    // another number: another record, nothing of the one before is in it
    std::uint64_t began() const { return began_; }
    // One line a tick; the names are the columns.
    std::string csv(const std::array<std::string, kScopeTraces>& names, double tick_s) const {
        return csv(samples_, names, tick_s);
    }
    static std::string csv(const std::deque<ScopeSample>& samples,
                           const std::array<std::string, kScopeTraces>& names, double tick_s);

private:
    std::deque<ScopeSample> samples_;
    Mode mode_ = Mode::Runs;
    std::int64_t at_ = 0;
    std::uint64_t began_ = 1;
};

// How round a circle was driven: commands of two axes and what was measured, deviation from the
// commanded radius.
struct Roundness {
    double x = 0, z = 0, radius = 0;  // of the commanded circle
    // of the measured radius, from the commanded one
    double most = 0, least = 0;
    std::vector<std::pair<double, double>> points;  // angle, deviation
    double error() const { return most - least; }
};
// Traces: command X, command Z, measured X, measured Z. Nothing: no circle of at least three
// quarters of a turn was commanded.
std::optional<Roundness> roundnessOf(const std::deque<ScopeSample>& samples);

}  // namespace polyturn::hmi
