// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/gradient.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/stroke_scale.h"
#include "app/formats/svg/style.h"

#include <functional>
#include <span>
#include <unordered_map>

namespace app::svg {

/// What is painted, for paints whose colours differ from place to place.
struct PaintedShape {
    std::span<const Subpath> paths{}; ///< in the document's coordinates
    Matrix matrix{};                  ///< to these from the element's
    Lengths lengths{};                ///< of the element
};

/// Resolves fills and strokes to plain colours: a gradient is replaced by its mean colour on the
/// shape, and a pattern by that of its tile; both are reported.
class Paints {
public:
    /// The mean colour of a pattern for a shape with this box, in the shape's coordinates and
    /// units.
    using PatternColour =
        std::function<std::optional<Colour>(Node, const Box& box, const Lengths& lengths)>;
    Paints(const Tree& tree, Styles& styles, Report& report, PatternColour patternColour)
        : tree_(tree), styles_(styles), report_(report), patternColour_(std::move(patternColour))
    {
    }

    /// The style, as far as it does not depend on a transform: widths and dashes are multiplied by
    /// `scale`.
    Style style(const Properties& properties, double opacity, const StrokeScale& scale,
                const PaintedShape& shape = {});

private:
    /// How a paint is used: inside the shape, or along its lines.
    enum class Part : std::uint8_t { Fill, Stroke };
    std::optional<Colour> colour(const Paint& paint, double opacity, const Properties& properties,
                                 const PaintedShape& shape, Part part);
    std::optional<Colour> referenced(const Paint& paint, const Properties& properties,
                                     const PaintedShape& shape, Part part);
    std::optional<Colour> gradientColour(Node gradient, const Properties& properties,
                                         const PaintedShape& shape, Part part);
    int rows(); ///< of the points at which the next shape is looked at

    const Tree& tree_;
    Styles& styles_;
    Report& report_;
    PatternColour patternColour_;
    std::unordered_map<Node, GradientStops> stops_;
    std::size_t shapes_ = 0; ///< painted with gradients so far
};

} // namespace app::svg
