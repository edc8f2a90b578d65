// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/session/session.h"

namespace app {

/// How a text from the clipboard becomes an object.
struct PastedText {
    QString text;
    QString font;
    double millimetres = 0; ///< the height of capital letters on paper
    Point centre{};         ///< of its letters, in user units
};

/// A drawing of that text, in the pen of the session; without lines of nothing but space around it.
Result<Document> drawingOf(const Session& session, const PastedText& text);

} // namespace app
