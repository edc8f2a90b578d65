// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <string>

namespace app::svg {

/// A style as presentation attributes, those only that are not what SVG takes anyhow.
std::string styleText(const Style& style);

} // namespace app::svg
