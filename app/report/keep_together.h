// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTextBlockFormat;
class QTextDocument;

namespace app {

/// Keeps a paragraph (a heading, the title of a table) on the page of the next one.
void setBelongsToNext(QTextBlockFormat& format);

/// Moves page breaks of a document that has a page size, so that no heading is alone at the foot of
/// a page, and no single row of a table at its foot or top.
void keepTogether(QTextDocument& document);

} // namespace app
