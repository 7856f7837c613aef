// `polyturn bench`: runs the benchmark programs of this build and prints their figures.
#pragma once
#include <string>
#include <vector>

namespace polyturn::supervisor {
int run_benchmarks(const std::vector<std::string>& arguments);
}
