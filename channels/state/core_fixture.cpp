// The fixture offset of a rotary table in the channel's coordinates (fixture.hpp).
#include <cmath>

#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {

namespace f = five_axis;

using Vector = std::array<double, 3>;

Vector turned_by_table(const Kinematics& k, const std::array<double, 2>& angle, Vector v,
                       double sense) {
    const bool first = k.value[f::kFirstIsHead] == 0 && f::exists(k, f::kFirstDirection);
    const bool second = k.value[f::kSecondIsHead] == 0 && f::exists(k, f::kSecondDirection);
    if (sense < 0 && first) v = f::turned(&k.value[f::kFirstDirection], -angle[0], v);
    if (second) v = f::turned(&k.value[f::kSecondDirection], sense * angle[1], v);
    if (sense > 0 && first) v = f::turned(&k.value[f::kFirstDirection], angle[0], v);
    for (double& c : v) c = std::round(c * 1e9) / 1e9;  // quarter turns give integers
    return v;
}

}  // namespace

void Core::set_fixture(const FixtureOffset& fixture) {
    fixture_off();
    path.fixture = fixture;
    path.fixture.on = true;
    fixture_step_ = {};
    path.fixture.now = fixture_at(path.programmed);
    shift_by(path.fixture.now, 1.0);
    rebase_all();
    refresh_surface_zero();
}

void Core::fixture_off() {
    if (!path.fixture.on) return;
    shift_by(path.fixture.now, -1.0);
    path.fixture = {};
    fixture_step_ = {};
    rebase_all();
    refresh_surface_zero();
}

void Core::shift_by(const std::array<double, 3>& vector, double sense) {
    for (std::size_t k = 0; k < 3; ++k)
        if (geo_[k] >= 0) path.shift[static_cast<std::size_t>(geo_[k])] += sense * vector[k];
}

// V with the table where that point has it.
std::array<double, 3> Core::fixture_at(const AxisValues& point) const {
    const FixtureOffset& fixture = path.fixture;
    std::array<double, 2> angle{};
    for (std::size_t r = 0; r < 2; ++r) {
        const std::uint8_t place = fixture.table.axis[3 + r];
        if (place >= view_->axis_count)
            angle[r] = fixture.table.centre[3 + r];  // a fixed angle
        else
            angle[r] = point[place] + path.turns_deg[place] + path.zero[place] + path.shift[place] +
                       path.wanted[place];
    }
    return turned_by_table(fixture.table, angle,
                           turned_by_table(fixture.table, fixture.at_deg, fixture.measured, -1.0),
                           1.0);
}

// What the move that is begun adds to the shift. An arc cannot be driven from one vector to
// another.
bool Core::follow_fixture(const AxisValues& target, MoveKind kind) {
    fixture_step_ = {};
    const bool names_linear = [&] {
        for (const int place : geo_)
            if (place >= 0 && (fixture_named_ >> place & 1u)) return true;
        return false;
    }();
    if (path.fixture.rotary_alone && !names_linear) return true;
    const std::array<double, 3> wanted = fixture_at(target);
    bool changes = false;
    for (std::size_t k = 0; k < 3; ++k) {
        fixture_step_[k] = wanted[k] - path.fixture.now[k];
        changes = changes || std::fabs(fixture_step_[k]) > 1e-9;
    }
    const bool arc = kind == MoveKind::ArcCw || kind == MoveKind::ArcCcw;
    return changes && arc ? fail(Alarm::TransformPlace, 'G', "G54.2") : true;
}

void Core::take_fixture_step() {
    for (std::size_t k = 0; k < 3; ++k) path.fixture.now[k] += fixture_step_[k];
    shift_by(fixture_step_, 1.0);
    fixture_step_ = {};
}

}  // namespace polyturn::channels
