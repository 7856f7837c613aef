// The questions of scanner and variables, answered by the language (hooks.hpp).
#pragma once
#include "channels/fanuc/macro/variables.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fanuc {

struct Execution;

class ProgramHooks final : public ScanHook, public VariableHost {
public:
    explicit ProgramHooks(Execution& x) : x_(&x) {}

    Read read_value(const char*& at, const char* end, double& value) override;
    bool block_skip(unsigned number) override;
    bool skip_sign_waits() override;
    std::size_t axis_name(const char* at, const char* end, int& axis) override;

    VariableStatus read_system(std::int64_t number, double& value) override;
    VariableStatus write_system(std::int64_t number, double value) override;
    bool barrier_fresh() override;
    VariableStatus shared_variable(std::int64_t number, bool write, double& value) override;

private:
    Execution* x_;
};

}  // namespace polyturn::channels::fanuc
