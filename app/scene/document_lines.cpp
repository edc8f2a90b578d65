// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/document_lines.h"

#include "app/document/flatten.h"

namespace app {

SceneLines linesOf(const Document& document)
{
    return linesOf(document.objects(), document.containers().hiddenRanges(),
                   usualTolerance(document.page()));
}

} // namespace app
