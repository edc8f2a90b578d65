// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace app::svg {

/// Whether the condition of an @supports rule holds: "(fill: red) and (not (color: lab(1 2 3)))".
/// A property holds if it is known, in any table of property.h, and its value, if it is evaluated.
/// Empty: the condition is not understood.
std::optional<bool> isSupported(std::string_view condition);

} // namespace app::svg
