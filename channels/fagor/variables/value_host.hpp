// Where reader and expressions get values from: parameters, variables and the block skip switches
// of one execution.
#pragma once
#include <cstdint>
#include <optional>

#include "channels/fagor/grammar/expression.hpp"
#include "channels/fagor/grammar/reader.hpp"

namespace polyturn::channels::fagor {

struct Execution;

class ValueHost final : public ReaderHost, public VariableHost {
public:
    explicit ValueHost(Execution& x) : x_(x) {}

    bool block_skip(unsigned number) override;
    std::optional<Alarm> parameter_value(std::int64_t number, double& value) override;
    Access read(const Target& target, double& value) override;

private:
    Execution& x_;
};

}  // namespace polyturn::channels::fagor
