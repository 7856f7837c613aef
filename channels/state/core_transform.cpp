// Transformations of the channel: what changes in Core when one is switched.
#include <cmath>
#include <limits>

#include "channels/pipeline/transform_sink.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels {

bool Core::transform(const Transformation& wanted) {
    if (reads_ahead()) return fail(Alarm::TransformPlace, 'G', "G41 G42");
    if (path.fixture.on) return fail(Alarm::TransformPlace, 'G', "G54.2 P0");
    if (vector_pending()) take_wanted();  // the tool's offset is in the centre
    if (!transforms_) {
        transforms_ = std::make_unique<TransformSink>(*view_, path.transformation);
        for (unsigned i = 0; i < view_->axis_count; ++i) transforms_->axes()[i] = path.machine[i];
        refresh_routes();
    }
    if (transformed()) transform_off();
    transforms_->forget_failure();
    double preset_deg = 0.0;
    if (wanted.counts_from_here) {
        const auto c = static_cast<std::size_t>(wanted.rotary_place());
        preset_deg = path.machine[c] - path.zero[c] - path.shift[c] - path.wanted[c];
        path.preset[c] += preset_deg;
        sum_zeros();
    }
    AxisValues& axes = transforms_->axes();
    for (unsigned i = 0; i < view_->axis_count; ++i) axes[i] = path.machine[i];
    path.transformation = wanted;
    path.transformation.preset_deg = preset_deg;
    Kinematics& k = path.transformation.kinematics;
    k.sign.fill(1.0);
    k.shift.fill(0.0);
    transformation_offsets_ = centre_offsets();
    if (kind_of(k) != KinematicsKind::FiveAxis) {
        k.centre[0] += transformation_offsets_[0];
        k.centre[1] += transformation_offsets_[1];
    }
    show_transformation();
    AxisValues coordinates = axes;
    places_to_path(path.transformation, coordinates);
    for (unsigned i = 0; i < view_->axis_count; ++i) path.machine[i] = coordinates[i];
    path.turns_deg = {};
    rebase_all();
    // constant surface speed looks at an axis that may mean something else now
    surface_zero_told_ = std::numeric_limits<double>::quiet_NaN();
    refresh_surface_zero();
    return true;
}

// How far zeros and tool move the centre of the roles: a linear axis is at its centre where its
// programmed coordinate is 0 (or the machine's), a rotary one counts from the zero of its angle.
std::array<double, 2> Core::centre_offsets() const {
    const Transformation& t = path.transformation;
    const Kinematics& k = t.kinematics;
    std::array<double, 2> offsets{};
    // the tool's length is in its arms: any change of it shows in one of the two
    if (kind_of(k) == KinematicsKind::FiveAxis) {
        constexpr double kApart = 0.70710678118654752;
        const auto of = [&](std::size_t r) {
            return path.shift[k.axis[r]] + path.wanted[k.axis[r]];
        };
        return {of(0), of(2) + kApart * of(1)};
    }
    if (kind_of(k) != KinematicsKind::Polar && kind_of(k) != KinematicsKind::Cylinder)
        return offsets;
    for (std::size_t r = 0; r < role_count(kind_of(k)); ++r) {
        const unsigned i = k.axis[r];
        const bool of_machine = t.about_machine_zero && static_cast<int>(i) != t.rotary_place();
        offsets[r] = (of_machine ? 0.0 : path.zero[i]) + path.shift[i] + path.wanted[i];
    }
    return offsets;
}

void Core::transform_off() {
    if (!transformed()) return;
    if (const int c = path.transformation.rotary_place(); c >= 0)
        path.preset[static_cast<std::size_t>(c)] -= path.transformation.preset_deg;
    path.transformation = {};
    show_transformation();
    for (unsigned i = 0; i < view_->axis_count; ++i) path.machine[i] = transforms_->axes()[i];
    sum_zeros();
    surface_zero_told_ = std::numeric_limits<double>::quiet_NaN();
    refresh_surface_zero();
}

void Core::transformation_restored() {
    if (transforms_) transforms_->forget_failure();
    show_transformation();
    show_factors();
}

// A rotary axis that takes part counts millimetres, and replaces Y where the transformation says
// so.
void Core::show_transformation() {
    const int rotary = path.transformation.rotary_place();
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        ChannelAxis& axis = view_->axes[i];
        if (axis.turns && static_cast<int>(i) != rotary) {
            axis.rotary = true;
            axis.rollover = axis.rolls_over;
            axis.turns = axis.rolls_over = axis.named_y = false;
        } else if (!axis.turns && static_cast<int>(i) == rotary) {
            axis.named_y = path.transformation.named_y;
            axis.turns = true;
            axis.rolls_over = axis.rollover;
            axis.rotary = axis.rollover = false;
        }
    }
    geo_[1] = path.transformation.virtual_y >= 0 ? path.transformation.virtual_y
                                                 : view_->axis_by_role(PlaneRole::BasicY);
}

bool Core::on_machine(AxisValues& values) const {
    if (!transformed()) return true;
    const Kinematics& k = path.transformation.kinematics;
    const bool negative =
        kind_of(k) == KinematicsKind::Polar && transforms_->axes()[k.axis[0]] < k.centre[0];
    const Branch branch{kind_of(k) == KinematicsKind::Polar ? transforms_->axes()[k.axis[1]] : 0.0,
                        negative ? SideOfPole::Negative : SideOfPole::Positive};
    return places_to_axes(path.transformation, branch, values);
}

bool Core::transformation_failed() {
    if (!transforms_) return false;
    if (transformed() && centre_offsets() != transformation_offsets_) {
        fail(Alarm::TransformPlace, 0, "T, zero offset");  // the centre would not be where it was
        return true;
    }
    if (!transforms_->failed()) return false;
    fail(Alarm::TransformPole, 0, {}, transforms_->failed_at());
    return true;
}

}  // namespace polyturn::channels
