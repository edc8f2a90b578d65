// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// A lesson's text as HTML in UTF-8, understood as the lessons' pages in the window understand it:
/// paragraphs, headings, lists, code, bold, italic. Links become their text; HTML in it is shown as
/// it is written. Needs a QGuiApplication.
QByteArray markdownHtml(const QString& markdown);

} // namespace app
