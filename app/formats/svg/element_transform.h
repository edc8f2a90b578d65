// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/style.h"
#include "app/formats/svg/transform.h"

namespace app::svg {

/// The matrix from an element's coordinates to those around it. Percentages and the origin refer to
/// `box`. Empty if a text is not understood.
std::optional<Matrix> matrixOf(const TransformTexts& texts, const Lengths& lengths, const Box& box);

/// Whether the element is not transformed at all.
bool isPlain(const TransformTexts& texts);

/// Whether the reference box is the element's bounding box, not the viewport.
bool refersToBounds(const TransformTexts& texts);

} // namespace app::svg
