// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"
#include "app/formats/svg/transform.h"
#include "app/formats/svg/tree.h"

namespace app::svg {

/// The page that the root element describes.
struct RootPage {
    Page page;
    Matrix matrix;        ///< from the root's coordinates to the sheet's; usually the identity
    bool unsized = false; ///< neither a view box nor a size: the page is what is drawn
};
RootPage readPage(const Tree& tree);

/// The clip window that Clearcut wrote into the metadata; nothing if it is none (inside out).
std::optional<clipping::Window> readWindow(const Tree& tree);

} // namespace app::svg
