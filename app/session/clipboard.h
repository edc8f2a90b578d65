// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QMimeData>

#include <memory>

namespace app {

/// Objects in formats for this and other programs: SVG as image and as text.
std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects);

/// The objects on the clipboard, at their original size on paper, without ids; empty if there are
/// none.
Objects pasted(const QMimeData& data, const Page& page);

} // namespace app
