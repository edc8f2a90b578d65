// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"

#include <algorithm>
#include <array>

namespace app {

std::span<const OverlayFamily> overlayFamilies()
{
    static constexpr std::array families{
        OverlayFamily{"cohen-sutherland", outcodeOverlay},
        OverlayFamily{"liang-barsky", parameterOverlay},
        OverlayFamily{"cyrus-beck", parameterOverlay},
        OverlayFamily{"nicholl-lee-nicholl", sectorOverlay},
        OverlayFamily{"skala", signOverlay},
        OverlayFamily{"kodituwakku-wijeweera-chamikara", pushOverlay},
        OverlayFamily{"matthes-drakopoulos", pushOverlay},
        OverlayFamily{"midpoint-subdivision", midpointOverlay},
        OverlayFamily{"sobkow-pospisil-yang", scriptOverlay},
        OverlayFamily{"slater-barsky", cellOverlay},
        OverlayFamily{"exact", turnOverlay},
    };
    return families;
}

namespace {

/// Where there is no row: a plug-in has no trace that we know, but the plane is the same.
Overlay (*familyOf(const clipping::Algorithm& algorithm))(const Seeing&)
{
    const auto all = overlayFamilies();
    const auto row = std::ranges::find(all, algorithm.key, &OverlayFamily::key);
    return row == all.end() ? outcodeOverlay : row->overlay;
}

bool isFinite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

} // namespace

Overlay overlayOf(const OverlaySubject& subject)
{
    const clipping::Segment some{subject.window.min, subject.window.max};
    if (const QString why = refusalOf({.clipper = subject.clipper,
                                       .line = subject.line.value_or(some),
                                       .window = subject.window});
        !why.isEmpty())
        return {.caption = why};
    Seeing seeing{subject};
    if (seeing.pointer && !isFinite(*seeing.pointer))
        seeing.pointer.reset();
    if (seeing.line)
        seeing.trace = seeing.traceOf(*seeing.line);
    return familyOf(*subject.clipper.algorithm)(seeing);
}

} // namespace app
