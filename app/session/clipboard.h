// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QMimeData>

#include <memory>

namespace app {

/// Objects for this program, which reads them back bit for bit, and for others: SVG as image and as
/// text, in pixels, because Inkscape ignores the unit of what it pastes; PDF and a PNG picture
/// (300 dpi, at most 4,000 pixels a side), on paper as large as what is seen of them. Groups are
/// copied if they are chosen as a whole (TreeDraft).
std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered = 0);

/// A file of a format for other programs: as this kind of file and, where it is a text, as text.
std::unique_ptr<QMimeData> copiedFile(std::string_view format, const QByteArray& content);

/// The drawing on the clipboard, at its original size on paper, without ids of objects; without
/// objects if there is none.
Document pasted(const QMimeData& data, const Page& page);

} // namespace app
