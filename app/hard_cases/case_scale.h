// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_answer.h"

#include <QRectF>

namespace app {

/// The positions of a hard case's numbers in a picture of 1 by 1, y up. If true distances would
/// hide what matters, or magnitudes differ too much, only the order of the numbers is kept:
/// neighbours on an axis are then equally far apart, and straight lines bend where they meet the
/// window.
class CaseScale {
public:
    /// The scale for the case and, if given, an answer (NaNs and infinities are left out).
    explicit CaseScale(const HardCase& hard, const CaseAnswer* answer = nullptr);

    bool isToScale() const { return isToScale_; }
    /// The used part of the picture: all of it, unless the scale is true.
    QRectF extent() const;
    /// The position of one of the case's or the answer's numbers; interpolated between them.
    QPointF at(const glm::dvec2& point) const;
    /// The path from End 1 to End 2; empty if one of them has no position.
    const std::vector<QPointF>& way() const { return way_; }

private:
    using Real = long double; // a double is too imprecise for a line that passes close to a corner
    struct Axis {
        std::vector<Real> levels; ///< ascending
        std::vector<double> shares;
        double at(Real level) const;
    };
    void rank(Axis& axis, double low, double high) const;
    void spread(const HardCase& hard);

    Axis x_, y_;
    std::vector<QPointF> way_;
    bool isToScale_ = true;
};

} // namespace app
