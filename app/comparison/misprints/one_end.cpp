// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/misprints/misprint.h"

#include <QCoreApplication>

namespace app {
namespace {

/// Like the published form of Liang and Barsky, but of each piece only the first end is used.
std::size_t clipAll(std::span<const clipping::Segment> in, const clipping::Window& window,
                    std::span<clipping::Clipped> out)
{
    const auto* meant = clipping::findAlgorithm("liang-barsky");
    const std::size_t count = meant->published->clipAll(in, window, out);
    for (clipping::Clipped& piece : out.first(count))
        piece.segment.b = in[piece.source].b;
    return count;
}

} // namespace

Misprint oneEnd()
{
    return {QStringLiteral("lb-one-end"),
            QCoreApplication::translate("MisprintTexts", "LB without its second cut"),
            QCoreApplication::translate("MisprintTexts",
                                        "The line that moves End 2 to u1 is missing, so End 2 may "
                                        "stay outside the window."),
            clipping::findAlgorithm("liang-barsky"), clipAll};
}

} // namespace app
