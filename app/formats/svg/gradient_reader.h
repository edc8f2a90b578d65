// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/gradient.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/style.h"

namespace app::svg {

bool isGradient(const Tree& tree, Node node);

/// The colours of a gradient; of another one if it takes them from there. Empty if it has none.
GradientStops gradientStops(const Tree& tree, Node node, Styles& styles, Report& report);

/// How it lies, with what it takes from other gradients. `lengths` are those of what it paints.
GradientShape gradientShape(const Tree& tree, Node node, const Lengths& lengths);

} // namespace app::svg
