#include "channels/cycles/contour.hpp"

#include <cmath>

namespace polyturn::channels::cycles {

void ContourRecorder::move(const Move& move, const BlockContext& at) {
    const AxisSet plane = 1u << z_ | 1u << x_;
    const bool arc = move.kind == MoveKind::ArcCw || move.kind == MoveKind::ArcCcw;
    const bool line = move.kind == MoveKind::Rapid || move.kind == MoveKind::Linear;
    if (only_plane && line && !(move.moved & plane)) return;
    if ((!arc && !line) || (!only_plane && (move.moved & ~plane)) ||
        (arc && (move.plane_p != z_ || move.plane_q != x_ || move.turns != 0))) {
        foreign = at;
        return;
    }
    Element element;
    element.from = here_;
    element.to = {move.pos[z_], move.pos[x_]};
    element.rapid = move.kind == MoveKind::Rapid;
    element.at = at;
    if (arc) {
        element.form = move.kind == MoveKind::ArcCw ? Element::Form::ArcCw : Element::Form::ArcCcw;
        element.centre = {move.pos_centre_p, move.pos_centre_q};
        element.radius = move.radius;
        element.first_angle = std::atan2(here_.x - element.centre.x, here_.z - element.centre.z);
        element.sweep = move.sweep;
    }
    here_ = element.to;
    contour.elements.push_back(element);
}

void ContourRecorder::alarm(const Diagnosis& diagnosis, const BlockContext&) {
    if (diagnosis.severity() == Severity::Error && !error) error = diagnosis;
}

}  // namespace polyturn::channels::cycles
