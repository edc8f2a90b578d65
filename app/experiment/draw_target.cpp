// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/draw_target.h"

#include "app/base/text.h"

#include <QtMath>

namespace app {

// THE CATALOGUE. To add a draw target: write its file in app/experiment/, and name it here.
std::vector<DrawTargetKind> drawTargetKinds()
{
    return {
        {"opengl", Text::tr("OpenGL"), openGlTarget},
        {"raster", Text::tr("Raster"), [] { return DrawTargetMaker(rasterTarget); }},
    };
}

DrawTargetMaker bestDrawTarget()
{
    for (const DrawTargetKind& kind : drawTargetKinds())
        if (DrawTargetMaker maker = kind.maker())
            return maker;
    return rasterTarget;
}

DrawTargetFit fitOf(const Field& field)
{
    const glm::dvec2 size = field.space.max - field.space.min;
    const double scale = std::min(1920 / size.x, 1440 / size.y);
    return {{qCeil(size.x * scale), qCeil(size.y * scale)}, scale};
}

} // namespace app
