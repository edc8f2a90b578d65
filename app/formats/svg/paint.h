// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/report.h"
#include "app/formats/svg/style.h"

#include <unordered_map>

namespace app::svg {

/// Follows fills and strokes to plain colours: a gradient is replaced by its first colour and
/// reported, a pattern by nothing.
class Paints {
public:
    Paints(const Tree& tree, Styles& styles, Report& report)
        : tree_(tree), styles_(styles), report_(report)
    {
    }

    /// What of the style does not depend on a transform: all but widths and dashes, which are
    /// multiplied by `scale`.
    Style style(const Properties& properties, double opacity, double scale);

private:
    std::optional<Colour> colour(const Paint& paint, double opacity, const Properties& properties);
    std::optional<Colour> referenced(const Paint& paint);

    struct Gradient {
        std::optional<Colour> first;
        bool plain = false; ///< one colour only, so nothing is lost
    };
    const Gradient& gradient(Node node);

    const Tree& tree_;
    Styles& styles_;
    Report& report_;
    std::unordered_map<Node, Gradient> gradients_;
};

} // namespace app::svg
