// What a fagor program can write and read back: arithmetic parameters, tool tables, PLC resources,
// kept variables.
//
//   P0..P25 local, one set a level   P100..P299 global   P1000..P1255 user   P2000..P2255 of the machine's maker
//
// Every cell is a double that outlives the undo log, so that a discarded block can be taken back.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "channels/state/undo_log.hpp"

namespace polyturn::channels::fagor {

inline constexpr std::size_t kLocals = 26;
using LocalSet = std::array<double, kLocals>;

enum class ToolField : std::uint8_t {
    NoseAngle,
    NoseWidth,
    CutAngle,
    Offset,
    Family,
    Life,
    Used,
    Pocket,
    Count
};
inline constexpr std::size_t kTools = 256;

class Values {
public:
    Values() : levels_(1, LocalSet{}) {}

    static bool exists(std::int64_t number) {
        return (number >= 0 && number < 26) || (number >= 100 && number < 300) ||
               (number >= 1000 && number < 1256) || (number >= 2000 && number < 2256);
    }
    static bool of_maker(std::int64_t number) { return number >= 2000; }
    double& parameter(std::int64_t number) {
        const auto n = static_cast<std::size_t>(number);
        if (n < kLocals) return levels_.back()[n];
        if (n < 1000) return global_[n - 100];
        return n < 2000 ? user_[n - 1000] : maker_[n - 2000];
    }
    void write(double& cell, double value) {
        undo_.note(serial_, cell);
        cell = value;
    }
    // Local sets are part of a resume state: no undo.
    static bool is_local(std::int64_t number) { return number >= 0 && number < 26; }
    const std::vector<LocalSet>& levels() const { return levels_; }
    void set_levels(const std::vector<LocalSet>& levels) { levels_ = levels; }
    void push_level(const LocalSet& set) { levels_.push_back(set); }
    void pop_level() {
        if (levels_.size() > 1) levels_.pop_back();
    }
    LocalSet& locals() { return levels_.back(); }

    double& tool(ToolField field, std::size_t n) {
        return tools_[static_cast<std::size_t>(field)][n];
    }
    double& mark(std::size_t n) { return marks_[n]; }
    double& plc_register(std::size_t n) { return registers_[n]; }
    double& input(std::size_t n) { return inputs_[n]; }
    double& output(std::size_t n) { return outputs_[n]; }
    double& timer(std::size_t n) { return timers_[n]; }
    double& counter(std::size_t n) { return counters_[n]; }
    double& kept(std::size_t row, std::size_t place) { return kept_[row][place]; }

    UndoLog& undo() { return undo_; }
    void begin_block(std::uint64_t serial) { serial_ = serial; }
    std::uint64_t serial() const { return serial_; }
    // The values of `other`, for a reader that only looks at a profile; without its undo log.
    void take_values(const Values& other) {
        levels_ = other.levels_;
        global_ = other.global_;
        user_ = other.user_;
        maker_ = other.maker_;
        tools_ = other.tools_;
    }

    // Everything of `other` but the local parameters and the undo log: for the next program.
    void take_tables(const Values& other) {
        global_ = other.global_;
        user_ = other.user_;
        maker_ = other.maker_;
        tools_ = other.tools_;
        marks_ = other.marks_;
        registers_ = other.registers_;
        inputs_ = other.inputs_;
        outputs_ = other.outputs_;
        timers_ = other.timers_;
        counters_ = other.counters_;
        kept_ = other.kept_;
    }

    // Each parameter that is not 0, with its number.
    template <class Show>
    void each_parameter(Show show) const {
        const auto all = [&](const auto& set, std::size_t first) {
            for (std::size_t n = 0; n < set.size(); ++n)
                if (set[n] != 0.0) show(first + n, set[n]);
        };
        all(levels_.back(), 0);
        all(global_, 100);
        all(user_, 1000);
        all(maker_, 2000);
    }

    static constexpr std::size_t kMarks = 5958, kRegisters = 500, kPins = 513, kTimers = 513,
                                 kCounters = 257, kKeptRows = 200, kKeptPlaces = 18;
    static constexpr std::size_t kNoPlace = kKeptPlaces - 1;  // of a row that has one value

private:
    std::vector<LocalSet> levels_;
    std::array<double, 200> global_{};
    std::array<double, 256> user_{}, maker_{};
    std::vector<std::array<double, kTools>> tools_ =
        std::vector<std::array<double, kTools>>(static_cast<std::size_t>(ToolField::Count));
    std::vector<double> marks_ = std::vector<double>(kMarks),
                        registers_ = std::vector<double>(kRegisters);
    std::vector<double> inputs_ = std::vector<double>(kPins), outputs_ = std::vector<double>(kPins),
                        timers_ = std::vector<double>(kTimers),
                        counters_ = std::vector<double>(kCounters);
    std::vector<std::array<double, kKeptPlaces>> kept_ =
        std::vector<std::array<double, kKeptPlaces>>(kKeptRows);
    UndoLog undo_;
    std::uint64_t serial_ = 0;
};

}  // namespace polyturn::channels::fagor
