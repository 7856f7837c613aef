#include "channels/fanuc/macro/variables.hpp"

#include <algorithm>

namespace polyturn::channels::fanuc {

VariableStatus VariableSet::read(std::int64_t number, double& value) {
    if (number == 0) {
        value = kNull;
        return VariableStatus::Ok;
    }
    if (number > 0 && number < static_cast<std::int64_t>(kLocals)) {
        value = levels_.back()[static_cast<std::size_t>(number)];
        return VariableStatus::Ok;
    }
    if (number < 1000 && is_shared(number)) return host_->shared_variable(number, false, value);
    const std::int64_t common = number - common_first_;
    if (common >= 0 && common < static_cast<std::int64_t>(common_.size())) {
        value = common_[static_cast<std::size_t>(common)];
        return VariableStatus::Ok;
    }
    if (number >= 500 && number < 1000) {
        value = store_->variables[number - 500];
        return VariableStatus::Ok;
    }
    return number >= 1000 ? host_->read_system(number, value) : VariableStatus::Unknown;
}

VariableStatus VariableSet::write(std::int64_t number, double value) {
    if (number == 0) return VariableStatus::ReadOnly;
    if (number > 0 && number < static_cast<std::int64_t>(kLocals)) {
        levels_.back()[static_cast<std::size_t>(number)] = value;
        return VariableStatus::Ok;
    }
    if (number < 1000 && is_shared(number)) return host_->shared_variable(number, true, value);
    const std::int64_t common = number - common_first_;
    if (common >= 0 && common < static_cast<std::int64_t>(common_.size())) {
        note_cell(common_[static_cast<std::size_t>(common)]);
        common_[static_cast<std::size_t>(common)] = value;
        return VariableStatus::Ok;
    }
    if (number >= 500 && number < 1000) {
        note_cell(store_->variables[static_cast<std::size_t>(number - 500)]);
        store_->variables[static_cast<std::size_t>(number - 500)] = value;
        return VariableStatus::Ok;
    }
    return number >= 1000 ? host_->write_system(number, value) : VariableStatus::Unknown;
}

void VariableSet::clear() {
    levels_.assign(1, empty_locals());
    std::fill(common_.begin(), common_.end(), kNull);
}

}  // namespace polyturn::channels::fanuc
