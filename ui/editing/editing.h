// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/copy_selection.h"
#include "app/session/image_steps.h"
#include "app/session/pasted_text.h"
#include "app/session/session.h"

#include <cstddef>

class QMimeData;

namespace ui {

// The Edit menu's functions on the selection and the clipboard (SVG, text or an image). Each is one
// undo step.

void copySelection(const app::Session& session);
void cutSelection(app::Session& session);
/// Pastes the drawing of the clipboard or of another program's drag, or its text as an object in
/// the font and at the place of `text`, whose own text does not count, or hands an image to
/// `placing`. Empty, or why nothing was pasted, or what of the drawing could not be.
QString paste(app::Session& session, const QMimeData* data, app::PastePlace place,
              app::PastedText text, app::ImagePlacing& placing,
              const std::optional<clipping::Window>& seen = {});
/// Whether what is dragged may be pasted: a drawing, a text or an image.
bool canPaste(const QMimeData& data);
void deleteSelection(app::Session& session);
/// Selects every object that is visible and not locked, in the entered group if there is one.
void selectAll(app::Session& session);

// A copied style is kept apart from the system's clipboard, so that copied objects stay there. Like
// the clipboard it belongs to the program: it may be pasted into another drawing.

void copyStyle(const app::Session& session);
bool hasCopiedStyle();
/// Does nothing without a copied style.
void pasteStyle(app::Session& session);

/// The memory in MB (10^6 bytes) that the steps to undo may use: a setting, 1,000 unless changed.
int undoMegabytes();
void setUndoMegabytes(int megabytes);

constexpr std::size_t bytesOf(int megabytes) { return std::size_t(megabytes) * 1'000'000; }

} // namespace ui
