// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/dashes.h"

#include "app/document/dash_parts.h"

#include <cmath>

namespace app {

std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest)
{
    std::vector<double> lengths;
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        const QPointF along = polyline[i] - polyline[i - 1];
        lengths.push_back(std::hypot(along.x(), along.y()));
    }
    const auto parts = dashParts(lengths, pattern, phase, shortest);
    if (!parts)
        return {{polyline.begin(), polyline.end()}};
    std::vector<std::vector<QPointF>> all;
    for (const DashPart& part : *parts) {
        const QPointF from = polyline[part.line], along = polyline[part.line + 1] - from;
        if (part.begins)
            all.push_back({from + along * part.from});
        all.back().push_back(from + along * part.to);
    }
    return all;
}

} // namespace app
