// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/truth.h"

#include <vector>

namespace app {

/// What there is around one end of a piece, in the drawing's units, all counted from `centre` and
/// computed there: so nothing jitters, however much it is magnified.
struct Magnified {
    glm::dvec2 centre;     ///< the algorithm's end, or else the double nearest the true one
    bool returned = false; ///< whether the algorithm returned it
    std::optional<glm::dvec2> truth; ///< the true end; nothing: truly nothing is visible
    glm::dvec2 nearest{};            ///< the double nearest to it
    glm::dvec2 direction;            ///< of the line, of length 1; a point has none
    glm::dvec2 onLine;               ///< the line's point that is nearest to the centre
    clipping::Window window;         ///< its edges
    glm::dvec2 ulp;                  ///< of each coordinate there
    double largestUlp;               ///< of the largest |coordinate| of line and window
};

/// Of what an algorithm returned, its first end (0) or its second (1); of a line that is lost, that
/// end of what is true. Nothing if nothing is visible, or if the end is no number.
std::optional<Magnified> magnified(const Variant& variant, const clipping::Segment& line,
                                   const clipping::Window& window, int end);

/// The numbers that a coordinate can be.
enum class Lattice : std::uint8_t { Double, Single };
/// Those between two offsets from a number, as offsets, ascending; none if there are more than
/// `most`.
std::vector<double> latticeBetween(double centre, double from, double to, Lattice lattice,
                                   std::size_t most);

} // namespace app
