// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <string>

namespace app::svg {

/// The style as presentation attributes, without those that have SVG's default value.
std::string styleText(const Style& style);

} // namespace app::svg
