#include "hmi/machine/bodies/scope_record.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace polyturn::hmi {

void ScopeRecord::clear() {
    samples_.clear();
    at_ = 0;
    ++began_;
}

void ScopeRecord::add(const std::vector<ScopeSample>& fresh, double window_ticks) {
    if (mode_ == Mode::Stopped) return;
    for (const ScopeSample& sample : fresh) {
        if (mode_ == Mode::Armed && !samples_.empty()) {
            const double before = samples_.back().value[trigger.trace],
                         now = sample.value[trigger.trace];
            if (trigger.rising ? before < trigger.level && now >= trigger.level
                               : before > trigger.level && now <= trigger.level) {
                mode_ = Mode::Triggered;
                at_ = sample.tick;
            }
        }
        samples_.push_back(sample);
        if (samples_.size() > kMost) samples_.pop_front();
        // Four fifths of the window lie behind the trigger.
        if (mode_ == Mode::Triggered &&
            static_cast<double>(sample.tick - at_) >= window_ticks * 0.8) {
            mode_ = Mode::Stopped;
            return;
        }
    }
}

std::string ScopeRecord::csv(const std::deque<ScopeSample>& samples,
                             const std::array<std::string, kScopeTraces>& names, double tick_s) {
    std::string out = "t";
    for (const std::string& name : names)
        if (!name.empty()) out += "," + name;
    out += "\n";
    const auto number = [&](double value) {
        char text[40];
        const auto end = std::to_chars(text, text + sizeof text, value);
        out.append(text, end.ptr);
    };
    for (const ScopeSample& sample : samples) {
        number(static_cast<double>(sample.tick - samples.front().tick) * tick_s);
        for (std::size_t i = 0; i < kScopeTraces; ++i)
            if (!names[i].empty()) {
                out += ',';
                number(sample.value[i]);
            }
        out += "\n";
    }
    return out;
}

// The circle through the commands by least squares: x2 + z2 + a x + b z + c = 0 (Kasa), about the
// mean for the sake of the digits.
std::optional<Roundness> roundnessOf(const std::deque<ScopeSample>& samples) {
    // The last piece without a rest, in which the commands move.
    std::vector<const ScopeSample*> used;
    for (std::size_t i = samples.size(); i-- > 1;) {
        const bool moves = std::hypot(samples[i].value[0] - samples[i - 1].value[0],
                                      samples[i].value[1] - samples[i - 1].value[1]) > 1e-7;
        if (moves)
            used.push_back(&samples[i]);
        else if (used.size() > 20)
            break;
        else
            used.clear();
    }
    if (used.size() < 50) return std::nullopt;
    const auto fit = [](const std::vector<const ScopeSample*>& points, Roundness& out,
                        double& worst) {
        double mx = 0, mz = 0;
        for (const ScopeSample* p : points) {
            mx += p->value[0];
            mz += p->value[1];
        }
        mx /= static_cast<double>(points.size());
        mz /= static_cast<double>(points.size());
        double xx = 0, xz = 0, zz = 0, xr = 0, zr = 0, r = 0;
        for (const ScopeSample* p : points) {
            const double x = p->value[0] - mx, z = p->value[1] - mz, q = x * x + z * z;
            xx += x * x;
            xz += x * z;
            zz += z * z;
            xr += x * q;
            zr += z * q;
            r += q;
        }
        const double d = xx * zz - xz * xz;
        if (std::abs(d) < 1e-12) return false;
        const double a = (xr * zz - zr * xz) / d / 2, b = (zr * xx - xr * xz) / d / 2;
        out.x = mx + a;
        out.z = mz + b;
        out.radius = std::sqrt(a * a + b * b + r / static_cast<double>(points.size()));
        worst = 0;
        for (const ScopeSample* p : points)
            worst = std::max(
                worst, std::abs(std::hypot(p->value[0] - out.x, p->value[1] - out.z) - out.radius));
        return true;
    };
    // What leads to the circle and away from it is no part of it: the ends are cut off as long as
    // they do not fit.
    Roundness out;
    double worst = 0;
    const std::size_t step = std::max<std::size_t>(1, used.size() / 40);
    std::size_t from = 0, to = used.size();
    for (;;) {
        const std::vector<const ScopeSample*> part(used.begin() + static_cast<std::ptrdiff_t>(from),
                                                   used.begin() + static_cast<std::ptrdiff_t>(to));
        if (part.size() < 50 || !fit(part, out, worst)) return std::nullopt;
        if (worst <= 0.002 + out.radius * 1e-4) {
            used = part;
            break;
        }
        const auto off = [&](const ScopeSample* p) {
            return std::abs(std::hypot(p->value[0] - out.x, p->value[1] - out.z) - out.radius);
        };
        if (off(part.front()) > off(part.back()))
            from += step;
        else
            to -= step;
        if (to <= from + 50) return std::nullopt;
    }
    // A tangent leaves the circle so gently that its first part still fitted: the ends keep to what
    // the command of the circle itself shows.
    const auto off = [&](const ScopeSample* p) {
        return std::abs(std::hypot(p->value[0] - out.x, p->value[1] - out.z) - out.radius);
    };
    std::vector<double> offs;
    // each fit without the tangents is nearer to the circle than the one before
    for (int again = 0; again < 3; ++again) {
        offs.clear();
        for (const ScopeSample* p : used) offs.push_back(off(p));
        std::nth_element(offs.begin(), offs.begin() + static_cast<std::ptrdiff_t>(offs.size() / 2),
                         offs.end());
        const double fits = 4 * offs[offs.size() / 2] + 1e-6;
        auto first = used.begin(), last = used.end();
        while (last - first > 50 && off(*first) > fits) ++first;
        while (last - first > 50 && off(last[-1]) > fits) --last;
        used = std::vector<const ScopeSample*>(first, last);
        if (!fit(used, out, worst)) return std::nullopt;
    }
    double turned = 0, last = 0;
    out.most = -1e9;
    out.least = 1e9;
    for (std::size_t i = 0; i < used.size(); ++i) {
        const double angle = std::atan2(used[i]->value[0] - out.x, used[i]->value[1] - out.z);
        if (i > 0) turned += std::remainder(angle - last, 2 * 3.141592653589793);
        last = angle;
        const double deviation =
            std::hypot(used[i]->value[2] - out.x, used[i]->value[3] - out.z) - out.radius;
        out.most = std::max(out.most, deviation);
        out.least = std::min(out.least, deviation);
        out.points.emplace_back(std::atan2(used[i]->value[2] - out.x, used[i]->value[3] - out.z),
                                deviation);
    }
    if (std::abs(turned) < 1.5 * 3.141592653589793) return std::nullopt;
    return out;
}

}  // namespace polyturn::hmi
