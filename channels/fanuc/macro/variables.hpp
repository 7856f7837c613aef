// Variables #n of custom macro B. Empty (null) is NaN in here and nowhere else.
//
//   #0 null   #1..#33 local, one set a macro level   #100.. common   #500..#999 kept (ChannelStore)   #1000.. system
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "channels/state/undo_log.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::channels::fanuc {

inline constexpr double kNull = std::numeric_limits<double>::quiet_NaN();
inline bool is_null(double value) { return std::isnan(value); }

inline constexpr std::size_t kLocals = 34;  // index is the variable's number; 0 stays null
using LocalSet = std::array<double, kLocals>;
inline LocalSet empty_locals() {
    LocalSet set;
    set.fill(kNull);
    return set;
}

enum class VariableStatus : std::uint8_t { Ok, Unknown, ReadOnly, NeedsBarrier, Fault };

// What lies behind system variables: the interpreter.
class VariableHost {
public:
    virtual ~VariableHost() = default;
    virtual VariableStatus read_system(std::int64_t number, double& value) = 0;
    virtual VariableStatus write_system(std::int64_t number, double value) = 0;
    virtual bool barrier_fresh() = 0;
    // of all channels
    virtual VariableStatus shared_variable(std::int64_t number, bool write, double& value) = 0;
};

class VariableSet {
public:
    VariableSet(VariableHost& host, ChannelStore& store, unsigned common_first,
                unsigned common_last)
        : host_(&host),
          store_(&store),
          common_first_(common_first),
          common_(common_last - common_first + 1, kNull),
          levels_{empty_locals()} {}

    VariableStatus read(std::int64_t number, double& value);
    VariableStatus write(std::int64_t number, double value);
    // How many from #100 and from #500 on belong to all channels.
    void share(std::int64_t from_100, std::int64_t from_500) {
        shared_100_ = from_100;
        shared_500_ = from_500;
    }
    bool is_shared(std::int64_t number) const {
        return (number >= 100 && number < 100 + shared_100_) ||
               (number >= 500 && number < 500 + shared_500_);
    }
    bool is_common(std::int64_t number) const {
        const auto first = static_cast<std::int64_t>(common_first_);
        return (number >= first && number < first + static_cast<std::int64_t>(common_.size())) ||
               (number >= 500 && number <= 999);
    }
    const std::vector<double>& common() const { return common_; }
    std::size_t common_first() const { return common_first_; }
    void take_common(const std::vector<double>& values) {
        if (values.size() == common_.size()) common_ = values;
    }
    LocalSet& locals() { return levels_.back(); }
    void push_locals(const LocalSet& set) { levels_.push_back(set); }
    void pop_locals() {
        if (levels_.size() > 1) levels_.pop_back();
    }
    std::size_t depth() const { return levels_.size(); }
    const std::vector<LocalSet>& levels() const { return levels_; }
    void set_levels(const std::vector<LocalSet>& levels) { levels_ = levels; }
    void take_values(const VariableSet& other) {
        common_ = other.common_;
        levels_ = other.levels_;
    }
    UndoLog& undo() { return undo_; }
    void begin_block(std::uint64_t serial) { serial_ = serial; }
    // before an offset or a zero is written
    void note_cell(double& cell) { undo_.note(serial_, cell); }
    // Reset and end of program: locals and commons become empty.
    void clear();

private:
    VariableHost* host_;
    ChannelStore* store_;
    unsigned common_first_;
    std::vector<double> common_;
    std::vector<LocalSet> levels_;
    std::int64_t shared_100_ = 0, shared_500_ = 0;
    UndoLog undo_;
    std::uint64_t serial_ = 0;
};

}  // namespace polyturn::channels::fanuc
