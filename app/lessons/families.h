// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/random.h"
#include "app/base/traced_line.h"

#include <QStringView>

#include <span>

namespace app {

/// A family of lines that a question can be about: what a lesson says of one of them is true of
/// all.
struct LineFamily {
    std::string_view key; ///< as written in lessons: "corner"
    /// A line at a window; it may belong to the family or not.
    clipping::Segment (*draw)(Random& random, const clipping::Window& window);
    /// Whether a line belongs to the family, also if rounding or the eye were a little wrong.
    bool (*fits)(const TracedLine& tracedLine);
};
std::span<const LineFamily> lineFamilies();
/// Null if there is none with this key.
const LineFamily* findLineFamily(QStringView key);

} // namespace app
