// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look.h"

class QTextDocument;

namespace ui {

/// Sets a page that was read from Markdown as a book would: lines 1.4 high, room before headings,
/// code and tables on a ground of their own, links in the look's colour.
void styleMarkdown(QTextDocument& document, const Look& look);

} // namespace ui
