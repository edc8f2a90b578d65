// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"

#include <QRectF>

namespace app {

/// Where the numbers of a hard case are in a picture of 1 by 1, y up. Where true distances would
/// hide what matters, or numbers are too far apart, only their order is true: then neighbours on
/// an axis are drawn equally far apart, and straight lines bend where they meet the window.
class CaseScale {
public:
    /// Shows the case, and an answer if there is one (NaNs and infinities are left out).
    explicit CaseScale(const HardCase& hard, const CaseAnswer* answer = nullptr);

    bool isTrue() const { return isTrue_; }
    /// What of the picture is used: all of it, unless the scale is true.
    QRectF extent() const;
    /// Of a number that is one of the case's or the answer's; between them, in proportion.
    QPointF at(const glm::dvec2& point) const;
    /// From End 1 to End 2; nothing if one of them is nowhere.
    const std::vector<QPointF>& way() const { return way_; }

private:
    using Real = long double; // a line may pass a corner by less than a double can tell
    struct Axis {
        std::vector<Real> levels; ///< ascending
        std::vector<double> shares;
        double at(Real level) const;
    };
    void rank(Axis& axis, double low, double high) const;
    void spread(const HardCase& hard);

    Axis x_, y_;
    std::vector<QPointF> way_;
    bool isTrue_ = true;
};

} // namespace app
