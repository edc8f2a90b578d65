// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/document/guide.h"
#include "app/document/page_sheets.h"
#include "app/document/subpath.h"

#include <optional>

namespace app {

/// The page: its rectangle in user units (the whole sheet of paper; the viewBox of an SVG) and its
/// size on paper. Lengths with a unit are measured from `min`, the top left corner of the paper.
struct Page {
    Point min{0, 0};
    Point size{297, 210};
    Length width{297, Unit::Mm}, height{210, Unit::Mm};
    Guides guides{};
    std::optional<PageSheets> sheets{}; ///< how it is divided, if a person has chosen it
    friend bool operator==(const Page&, const Page&) = default;

    /// The size of a user unit in millimetres; 25.4 / 96 (1 px) if the file does not give it.
    double millimetresPerUnit() const;
    /// The unit in which lengths are displayed: the unit of the page width, or pixels if the width
    /// has none.
    Unit usualUnit() const;
    clipping::Window rectangle() const { return {min, min + size}; }
};

} // namespace app
