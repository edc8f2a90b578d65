// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/reader.h"
#include "app/formats/svg/writer.h"

namespace app {

Format svgFormat()
{
    return {
        "svg",
        Text::tr("SVG drawing"),
        svg::read,
        svg::write,
        Holds::Paths,
        StoresHidden::Yes,
        Text::tr("elements nested %1 deep; %2 points, or one for each byte of a larger file; %3 "
                 "layers (further layers become one)")
            .arg(countText(svg::deepestNesting), countText(svg::mostParts),
                 countText(Containers::mostLayers)),
        Text::tr("edit again"),
        {.precision = true, .paper = true, .plain = true, .clipPaths = true},
        svg::read};
}

} // namespace app
