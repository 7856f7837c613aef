// A contour seen in roughing direction: pieces along which both coordinates only rise or only fall.
//
//   s  along the roughing axis, grows in the direction of the cut
//   h  height, grows from the contour towards the tool's start
#pragma once
#include <optional>
#include <vector>

#include "channels/cycles/contour.hpp"

namespace polyturn::channels::cycles {

struct Level {
    double s = 0.0, h = 0.0;
};

struct Piece {
    Level from, to;
    bool arc = false;
    bool clockwise = false;  // as programmed, in the plane Z X
    Level centre;
    double radius = 0.0;
    std::size_t element = 0;  // of the contour
    // s where the piece has this height, for a height between its ends
    double at_height(double h) const;
};

// Where the contour is not higher than a level.
struct Opening {
    std::size_t first = 0, last = 0;  // pieces at whose inside it begins and ends
    double s1 = 0.0, s2 = 0.0;
    bool from_start = false, to_end = false;  // open: no flank there
};

class Profile {
public:
    // Signs: +1 the coordinate grows as s or h does. `offset` shifts the contour (allowance).
    Profile(const Contour& contour, bool facing, double s_sign, double h_sign, Point offset);

    const std::vector<Piece>& pieces() const { return pieces_; }
    Level first() const { return first_; }
    Level last() const { return pieces_.empty() ? first_ : pieces_.back().to; }
    double lowest() const;
    Level level(Point point) const;
    Point point(Level level) const;
    // The element in which s (or h) runs back by more than the tolerance.
    std::optional<std::size_t> runs_back(bool height, double tolerance) const;
    // Openings of a level among the pieces of `within`, in roughing direction.
    std::vector<Opening> openings(double h, const Opening& within) const;
    Opening whole() const;

private:
    void add_arc(const Element& element, std::size_t index, Point offset);

    bool facing_;
    double s_sign_, h_sign_;
    Level first_;
    std::vector<Piece> pieces_;
};

}  // namespace polyturn::channels::cycles
