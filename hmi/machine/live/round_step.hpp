// Divisions that people count by: those of the scope and of the graph of a compensation.
#pragma once
#include <cmath>

namespace polyturn::hmi {

// The least of 1, 2, 5, 10 ... that is not less; least > 0.
inline double roundStep(double least) {
    const double ten = std::pow(10.0, std::floor(std::log10(least)));
    for (const double one : {1.0, 2.0, 5.0})
        if (one * ten >= least * (1 - 1e-9)) return one * ten;
    return 10 * ten;
}

}  // namespace polyturn::hmi
