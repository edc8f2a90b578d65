// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTextBlockFormat;
class QTextDocument;

namespace app {

/// Says that a paragraph belongs to what follows it: a heading, the title of a table.
void setBelongsToNext(QTextBlockFormat& format);

/// Ends pages of a document that has a page size earlier where a heading would stand alone at the
/// foot of one, or a single row of a table at the foot or at the top.
void keepTogether(QTextDocument& document);

} // namespace app
