// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/style.h"
#include "app/formats/svg/transform.h"

namespace app::svg {

/// The page that the root element describes: the whole sheet of paper. It is larger than a view box
/// of different proportions (or smaller, with "slice").
struct RootPage {
    Page page;
    Matrix matrix;    ///< from the root's coordinates to the document's; usually the identity
    Point viewport{}; ///< what percentages refer to, in the root's coordinates
    bool openX = false, openY = false; ///< no view box and no size along this axis: see `closed`
};
RootPage readPage(const Tree& tree, Styles& styles, Report& report);

/// An element's viewBox. One that is no rectangle is reported, and counts as missing.
std::optional<Box> readViewBox(const Tree& tree, Node node, Report& report);

/// The page for a root with an open size: along each open axis it reaches from the user origin,
/// where programs put the corner of such a drawing, to the right or lower end of the drawing.
Page closed(const RootPage& root, const Objects& objects);

} // namespace app::svg
