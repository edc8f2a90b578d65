// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace app {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
    friend bool operator==(const Colour&, const Colour&) = default;
};

enum class Cap : std::uint8_t { Butt, Round, Square };
enum class Join : std::uint8_t { Miter, Round, Bevel };
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// How an object is painted, with the meaning and defaults of SVG. Widths and dashes are in user
/// units.
struct Style {
    std::optional<Colour> stroke{};
    std::optional<Colour> fill{};
    double width = 1;
    double miterLimit = 4;
    double dashOffset = 0;
    std::vector<double> dashes{};
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    FillRule fillRule = FillRule::NonZero;
    friend bool operator==(const Style&, const Style&) = default;
};

} // namespace app
