// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QMimeData>

#include <memory>

namespace app {

/// Objects as other programs and this one take them: SVG, as such and as text.
std::unique_ptr<QMimeData> copied(const Document& document, const ObjectRanges& objects);

/// The objects in there, at the size on paper that they had, without their ids; none if there are
/// none.
Objects pasted(const QMimeData& data, const Page& page);

} // namespace app
