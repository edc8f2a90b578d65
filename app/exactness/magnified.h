// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/exactness.h"

#include <vector>

namespace app {

/// The surroundings of one end of a piece, in the drawing's units, relative to `centre` and
/// computed there, so that nothing jitters at any magnification.
struct Magnified {
    glm::dvec2 centre;     ///< the algorithm's end, or the double nearest to the true end
    bool returned = false; ///< whether the algorithm returned it
    std::optional<glm::dvec2> exactness; ///< the true end; empty: nothing is truly visible
    glm::dvec2 nearest{};                ///< the double nearest to the true end
    glm::dvec2 direction;                ///< of the line, of length 1; a point has none
    glm::dvec2 onLine;                   ///< the point of the line nearest to the centre
    clipping::Window window;             ///< the edges of the clip window
    glm::dvec2 ulp;                      ///< of each coordinate at the centre
    double largestUlp;                   ///< of the largest |coordinate| of line and window
};

/// The first end (0) or the second (1) of what an algorithm returned; for a lost line, of the true
/// piece. Empty if nothing is visible, or if the end is not a number.
std::optional<Magnified> magnified(const Variant& variant, const clipping::Segment& line,
                                   const clipping::Window& window, int end);

/// The number type of a coordinate.
enum class Lattice : std::uint8_t { Double, Single };
/// The numbers of that type between two offsets from `centre`, as offsets, ascending; empty if
/// there are more than `most`.
std::vector<double> latticeBetween(double centre, double from, double to, Lattice lattice,
                                   std::size_t most);

} // namespace app
