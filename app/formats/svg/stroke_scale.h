// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/transform.h"

#include <span>

namespace app::svg {

/// How a transform changes a stroke: its width and, along the path, its dashes.
struct StrokeScale {
    double across = 1, along = 1;
    bool even = true;   ///< the same everywhere, with ends at right angles
    bool round() const; ///< whether round and square caps stay what they are
};

/// For paths that were transformed by the matrix. Where widths differ, the mean along the paths.
StrokeScale strokeScale(const Matrix& matrix, std::span<const Subpath> transformed);

} // namespace app::svg
