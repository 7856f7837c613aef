// The given data of a group of elements, as equations: residuals in mm that are zero where
// everything given is true.
//
// Unknowns: of a line its end (2), of an arc its end and its centre (4). Each datum is one
// equation; an arc has one of its own (both ends are equally far from the centre), or two where its
// sweep is given. An angle is an equation of the straight line, so what points the wrong way is a
// root too: fits() sorts those out.
#pragma once
#include <Eigen/Dense>

#include "hmi/contour/contour.hpp"

namespace polyturn::contour {

class Group {
public:
    // Elements first..last of the contour behind the point `from`; `before`: the direction there,
    // if anything lies before.
    Group(const Contour& contour, std::size_t first, std::size_t last, Point from,
          std::optional<double> before);
    int unknowns() const { return unknowns_; }
    int equations() const { return equations_; }
    Eigen::VectorXd residuals(const Eigen::VectorXd& u) const;
    // Everything goes the way that is given, and no element is a point.
    bool fits(const Eigen::VectorXd& u) const;
    std::vector<Piece> pieces(const Eigen::VectorXd& u) const;
    double size() const { return size_; }  // how far apart things are, mm
    // somewhere to begin from; the same for the same seed
    Eigen::VectorXd begin(unsigned seed) const;

private:
    void count();
    bool told_tangent(std::size_t i) const;
    const Contour* contour_;
    std::size_t first_, last_;
    Point from_;
    std::optional<double> before_;
    int unknowns_ = 0, equations_ = 0;
    double size_ = 10.0;
};

}  // namespace polyturn::contour
