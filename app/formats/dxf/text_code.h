// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/header.h"

#include <QString>

namespace app::dxf {

/// Text of a file: UTF-8 or Western European, with characters as \U+03B1.
QString textOf(std::string_view bytes, const Header& header);

/// Whether a text is neither, so that textOf() may read other letters than the file means.
bool isForeign(std::string_view bytes, const Header& header);

/// The text of an entity TEXT: without %%u, with signs for %%d, %%p, %%c and %%176.
QString plainText(const QString& text);

/// The paragraphs of an entity MTEXT, without formatting. Stacked fractions are written with /.
QStringList paragraphs(const QString& text);

} // namespace app::dxf
