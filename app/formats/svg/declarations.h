// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <QString>

namespace app::svg {

/// A style as CSS declarations: "fill:none;stroke:#ff0000;stroke-width:2". Reading it back gives
/// the same style.
QString declarations(const Style& style);

/// The style of declarations, with SVG's defaults for what they do not say. Empty: they are too
/// long, or not CSS.
std::optional<Style> styleOf(const QString& declarations);

} // namespace app::svg
