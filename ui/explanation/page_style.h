// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

class QTextDocument;

namespace ui {

/// Styles a document read from Markdown like a book page: line height 1.4, space before headings,
/// code and tables on a background of their own, links in the look's colour.
void styleMarkdown(QTextDocument& document, const Look& look);

} // namespace ui
