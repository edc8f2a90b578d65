// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/session.h"

namespace ui {

// What the Edit menu does with the selection and the clipboard (SVG). Each is one undo step.

void copySelection(const app::Session& session);
void cutSelection(app::Session& session);
/// Nothing, or the sentence that says what is wrong with what is on the clipboard.
std::optional<QString> paste(app::Session& session);
void duplicateSelection(app::Session& session);
void deleteSelection(app::Session& session);
/// All that can be seen and is not locked.
void selectAll(app::Session& session);

} // namespace ui
