// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/formats/svg/transform.h"
#include "app/formats/svg/tree.h"

namespace app::svg {

/// The page that the root element describes: the whole sheet of paper, which is larger than a view
/// box of another proportion (or smaller, with "slice").
struct RootPage {
    Page page;
    Matrix matrix;    ///< from the root's coordinates to the document's; usually the identity
    Point viewport{}; ///< what percents are of, in the root's coordinates
    bool openX = false, openY = false; ///< no view box, and no size that way: see `closed`
};
RootPage readPage(const Tree& tree);

/// The page of a root whose size is open in a direction: from the user origin, where programs put
/// the corner of such a drawing, to the right and lower end of what is drawn.
Page closed(const RootPage& root, const Objects& objects);

} // namespace app::svg
