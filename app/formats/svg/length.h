// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
#include <string_view>

namespace app::svg {

constexpr double pixel = 25.4 / 96; ///< millimetres of a user unit without a viewBox

/// What the lengths at one place of a drawing are relative to.
struct Lengths {
    Point viewport{}; ///< the size that percentages refer to
    double fontSize = 16, rootFontSize = 16;
    Point screen{}; ///< of the whole drawing, in pixels; 100vw and 100vh

    /// A length in user units; empty if the text is not a length. `of` is what 100 % means.
    std::optional<double> parse(std::string_view text, double of) const;
    std::optional<double> x(std::string_view text) const { return parse(text, viewport.x); }
    std::optional<double> y(std::string_view text) const { return parse(text, viewport.y); }
    std::optional<double> other(std::string_view text) const { return parse(text, diagonal()); }
    /// The units of CSS that depend on the place: how large they are in user units. Empty for
    /// others.
    std::optional<double> unit(std::string_view suffix) const;
    double diagonal() const; ///< what 100 % means for radii and stroke widths
};

/// Whether a number other than 0 has no unit, which CSS accepts only in attributes.
bool lacksUnit(std::string_view text);

/// The degrees of a unit of angles; empty if there is no such unit. No unit means degrees.
std::optional<double> degreesOf(std::string_view unit);

} // namespace app::svg
