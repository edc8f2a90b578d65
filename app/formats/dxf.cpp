// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/containers.h"
#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/reader.h"
#include "app/formats/dxf/write_drawing.h"

namespace app {

Format dxfFormat()
{
    return {"dxf",
            Text::tr("DXF drawing"),
            [](QIODevice& in) { return dxf::read(in, {}); },
            dxf::writing::write,
            Holds::Outlines,
            StoresHidden::Yes,
            Text::tr("blocks nested %1 deep; %2 points, or one for each byte of a larger file; %3 "
                     "layers (further layers become one)")
                .arg(countText(std::size_t(dxf::deepestInsert)), countText(dxf::mostParts),
                     countText(Containers::mostLayers)),
            Text::tr("CAD, laser"),
            {.precision = true, .dxf = true, .unit = true},
            dxf::read};
}

} // namespace app
