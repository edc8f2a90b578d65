// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace app::svg {

/// Whether a list of media, "screen and (prefers-color-scheme: light), print", includes a picture
/// on a screen with light colours. Empty if it has conditions that are not known.
std::optional<bool> appliesToScreens(std::string_view media);

} // namespace app::svg
