// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/edge_words.h"
#include "app/base/variant.h"

namespace app {

/// What is looked at through the microscope.
struct Specimen {
    Variant variant{};
    clipping::Segment line{};
    clipping::Window window{};
    YAxis y = YAxis::Down;
    QString origin{}; ///< where the line is from: "Line 217 of 420"
    friend bool operator==(const Specimen&, const Specimen&) = default;
};

/// Why there is nothing to trace, and what to do; empty: there is.
QString refusalOf(const Specimen& specimen);

} // namespace app
