// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/stroke_scale.h"

#include "app/document/flatten.h"
#include "app/formats/svg/path_walk.h"

#include <algorithm>
#include <cmath>

namespace app::svg {

constexpr double slack = 0.01; // that is not seen

bool StrokeScale::round() const { return std::abs(across - along) <= slack * along; }

// Along a direction u, lengths are multiplied by |Mu| and widths by |det M| / |Mu|.
StrokeScale strokeScale(const Matrix& matrix, std::span<const Subpath> transformed)
{
    const double plain = matrix.scale();
    const StrokeScale usual{plain, plain, matrix.keepsShapes()};
    const auto back = inverse(matrix);
    if (usual.even || !back)
        return usual;
    std::vector<Chord> chords;
    for (const Subpath& path : transformed)
        flatten(path, flatteningTolerance(transformed), chords);
    double length = 0, before = 0, least = 0, most = 0;
    bool upright = true; // whether ends stay at right angles
    for (const Chord& chord : chords) {
        const Point step = chord.segment.b - chord.segment.a;
        const Point own{back->a * step.x + back->c * step.y, back->b * step.x + back->d * step.y};
        const double now = std::hypot(step.x, step.y), then = std::hypot(own.x, own.y);
        if (!(then > 0 && now > 0))
            continue;
        least = before == 0 ? now / then : std::min(least, now / then);
        most = std::max(most, now / then);
        const Point across{matrix.a * -own.y + matrix.c * own.x,
                           matrix.b * -own.y + matrix.d * own.x};
        upright = upright
                  && std::abs(across.x * step.x + across.y * step.y)
                         <= slack * now * std::hypot(across.x, across.y);
        length += now;
        before += then;
    }
    if (!(before > 0 && length > 0))
        return usual;
    const double along = length / before;
    return {std::abs(matrix.determinant()) / along, along, upright && most <= least * (1 + slack)};
}

} // namespace app::svg
