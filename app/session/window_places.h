// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <optional>
#include <span>

// Rectangular clip windows that are laid on something in one step: the page, the selection, a
// layer.

namespace app {

/// Something that a clip window can be laid on. Its texts are to be translated.
struct LayingPlace {
    std::string_view key;   ///< of the command
    std::string_view text;  ///< of the command, with its mnemonic
    std::string_view step;  ///< in Undo
    std::string_view needs; ///< why there is nothing to lay it on; may be empty
    std::optional<clipping::Window> (*box)(const Session& session);
    QString (*name)(const Session& session); ///< of the window; may be empty
};

/// Every place, in the order of menus; the page is the first.
std::span<const LayingPlace> windowPlaces();

/// Lays a clip window there. If the drawing has one window only, and that is a rectangle which is
/// not rotated, it moves there; otherwise a window is added. Does nothing without such a place.
void layWindow(Session& session, const LayingPlace& place);

/// Margins of the page, in user units. A negative one is outside it.
struct PageMargins {
    double left, top, right, bottom;
    static PageMargins same(double margin) { return {margin, margin, margin, margin}; }
};
/// The same on the page without margins. Returns why not, as a sentence, if nothing of the page
/// would be left.
std::optional<QString> layWindowInside(Session& session, const PageMargins& margins);

} // namespace app
