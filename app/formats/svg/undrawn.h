// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace app::svg {

/// Elements that draw nothing where they stand; with * at its end: all with this beginning. Any
/// element that is neither drawn nor in this list is told.
std::span<const std::string_view> undrawnElements();

bool isUndrawn(std::string_view element);

} // namespace app::svg
