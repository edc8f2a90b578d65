// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

// Colours of CSS Color 4 in sRGB. Parts beyond 0 to 1 are outside what a screen of sRGB shows.

namespace app::svg {

using SrgbParts = std::array<double, 3>;

/// CIE Lab with the white D50: lightness 0 to 100.
SrgbParts srgbOfLab(const std::array<double, 3>& lab);
/// Oklab: lightness 0 to 1.
SrgbParts srgbOfOklab(const std::array<double, 3>& lab);
/// Lightness, chroma and hue in degrees as lightness and two axes.
std::array<double, 3> fromPolar(const std::array<double, 3>& lch);
/// The spaces of color(): "srgb", "srgb-linear", "display-p3", "xyz", "xyz-d50", "xyz-d65".
std::optional<SrgbParts> srgbOfSpace(std::string_view space, const std::array<double, 3>& parts);

} // namespace app::svg
