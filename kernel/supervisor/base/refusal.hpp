// What a program on the socket is answered when its request was refused:
// {"ok":false,"number","text","remedy"}, and of several faults each one under "faults".
#pragma once
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::supervisor {
std::string refusal(const Diagnosis& diagnosis);
std::string refusal(const std::vector<Diagnosis>& diagnoses);
}  // namespace polyturn::supervisor
