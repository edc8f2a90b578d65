// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/report.h"
#include "app/formats/svg/style.h"

#include <unordered_map>

namespace app::svg {

/// Resolves fills and strokes to plain colours: a gradient is replaced by its first colour and
/// reported; a pattern is removed.
class Paints {
public:
    Paints(const Tree& tree, Styles& styles, Report& report)
        : tree_(tree), styles_(styles), report_(report)
    {
    }

    /// The style, as far as it does not depend on a transform: only widths and dashes are
    /// multiplied by `scale`.
    Style style(const Properties& properties, double opacity, double scale);

private:
    std::optional<Colour> colour(const Paint& paint, double opacity, const Properties& properties);
    std::optional<Colour> referenced(const Paint& paint, const Properties& properties);

    struct Gradient {
        std::optional<Colour> first;
        bool plain = false; ///< whether it has a single colour, so that nothing is lost
    };
    const Gradient& gradient(Node node);

    const Tree& tree_;
    Styles& styles_;
    Report& report_;
    std::unordered_map<Node, Gradient> gradients_;
};

} // namespace app::svg
