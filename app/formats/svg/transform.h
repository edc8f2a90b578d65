// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/formats/svg/length.h"

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
    double scale() const;     ///< mean scale of lengths: the square root of |determinant|
    bool keepsShapes() const; ///< whether there is no shear or uneven scaling, so that strokes keep
                              ///< an even width
    friend Matrix operator*(const Matrix& outer, const Matrix& inner);
    friend bool operator==(const Matrix&, const Matrix&) = default;
};

Matrix translation(const Point& by);
AffineMap mapOf(const Matrix& matrix);
std::optional<Matrix> inverse(const Matrix& matrix); ///< empty if it flattens the plane

/// The units of the numbers of a transform.
struct TransformUnits {
    const Lengths& lengths;
    Point box{};        ///< the size that percentages refer to
    bool isCss = false; ///< in CSS, lengths and angles other than 0 need units
};

/// A length along x (axis 0) or y (axis 1); empty if the text is none.
std::optional<double> transformLength(std::string_view text, const TransformUnits& units, int axis);

/// Parses the list of an attribute or style "transform"; empty if any part of it is not understood.
std::optional<Matrix> parseTransform(std::string_view text, const TransformUnits& units);

/// Maps all points of a path.
void transform(Subpath& path, const Matrix& matrix);

/// A rectangle in SVG's form: x, y, width, height.
struct Box {
    Point min{}, size{};
};

/// Parses "min-x min-y width height"; the sizes must be positive.
std::optional<Box> parseViewBox(std::string_view text);

/// The value of preserveAspectRatio: how a view box lies in a viewport of different proportions.
struct AspectRatio {
    enum class Fit : std::uint8_t { Meet, Slice, Stretch };
    Fit fit = Fit::Meet;
    Point alignment{0.5, 0.5}; ///< share of the free space to the left of and above the drawing
};
AspectRatio parseAspectRatio(std::string_view text);

/// The transformation from the view box to the viewport that preserveAspectRatio specifies.
Matrix viewBoxTransform(const Box& viewBox, const Box& viewport,
                        std::string_view preserveAspectRatio);

} // namespace app::svg
