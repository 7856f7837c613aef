#include <cmath>

#include "channels/path/blend.hpp"
#include "channels/path/quintic.hpp"

namespace polyturn::channels {

bool fit_parameter(std::size_t axes, const std::array<bool, kMaxCurveAxes>& measured,
                   BlendPiece& piece) {
    const auto speed = [&](double u) {
        double sum = 0;
        for (std::size_t k = 0; k < axes; ++k)
            if (measured[k]) {
                const double x = slope_at(piece.position[k], u);
                sum += x * x;
            }
        return std::sqrt(sum);
    };
    const auto growth = [&](double u, double speed_there) {  // d speed / du
        double sum = 0;
        for (std::size_t k = 0; k < axes; ++k)
            if (measured[k]) sum += slope_at(piece.position[k], u) * bend_at(piece.position[k], u);
        return sum / speed_there;
    };
    // Gauss-Legendre, five points.
    static constexpr double x[] = {0.0469100770306680, 0.2307653449471585, 0.5, 0.7692346550528415,
                                   0.9530899229693320};
    static constexpr double w[] = {0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
                                   0.2393143352496832, 0.1184634425280945};
    double length = 0;
    for (int n = 0; n < 5; ++n) length += w[n] * speed(x[n]);
    const double v0 = speed(0), v1 = speed(1);
    if (!(v0 > 0) || !(v1 > 0) || !(length > 0)) return false;
    const Quintic unit =
        hermite({0, length / v0, -length * length * growth(0, v0) / (v0 * v0 * v0)},
                {1, length / v1, -length * length * growth(1, v1) / (v1 * v1 * v1)});
    piece.length = length;
    double power = 1;
    for (std::size_t k = 0; k < 6; ++k) {
        piece.parameter[k] = unit[k] * power;
        power /= length;
    }
    for (double y : {0.13, 0.25, 0.5, 0.75, 0.87})
        if (std::abs(speed(at(unit, y)) * slope_at(unit, y) / length - 1) > 0.6 * kSpeedError)
            return false;
    return true;
}

}  // namespace polyturn::channels
