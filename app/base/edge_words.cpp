// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/edge_words.h"

#include <QCoreApplication>

#include <array>

namespace app {

QString edgeWords(clipping::Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> up{"", "the left edge", "the right edge",
                                                   "the bottom edge", "the top edge"};
    auto at = std::size_t(edge);
    if (at >= up.size())
        return {};
    if (y == YAxis::Down && at >= 3)
        at = 7 - at;
    return at == 0 ? QString() : QCoreApplication::translate("narration", up[at]);
}

} // namespace app
