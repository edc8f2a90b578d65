// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
#include <string_view>

namespace app::svg {

/// x' = a x + c y + e, y' = b x + d y + f: SVG's matrix(a b c d e f).
struct Matrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point operator()(const Point& p) const
    {
        return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
    }
    double determinant() const { return a * d - b * c; }
    double scale() const;     ///< of lengths, on average: the square root of |determinant|
    bool keepsShapes() const; ///< no shear and no uneven scaling: strokes stay evenly wide
    friend Matrix operator*(const Matrix& outer, const Matrix& inner);
    friend bool operator==(const Matrix&, const Matrix&) = default;
};

Matrix translation(const Point& by);

/// The list of an attribute or style "transform"; nothing if any part of it is not understood.
std::optional<Matrix> parseTransform(std::string_view text);

/// A path with all its points mapped.
void transform(Subpath& path, const Matrix& matrix);

/// A rectangle as SVG writes it: x, y, width, height.
struct Box {
    Point min{}, size{};
};

/// "min-x min-y width height" with positive sizes.
std::optional<Box> parseViewBox(std::string_view text);

/// What preserveAspectRatio says: how a view box lies in a viewport of another proportion.
struct AspectRatio {
    enum class Fit : std::uint8_t { Meet, Slice, Stretch };
    Fit fit = Fit::Meet;
    Point alignment{0.5, 0.5}; ///< the part of the free space that is left of and above the drawing
};
AspectRatio parseAspectRatio(std::string_view text);

/// Maps the view box into the viewport as preserveAspectRatio says.
Matrix viewBoxTransform(const Box& viewBox, const Box& viewport,
                        std::string_view preserveAspectRatio);

} // namespace app::svg
