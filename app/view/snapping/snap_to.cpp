// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/snap_to.h"

#include "app/base/text.h"

#include <QStringList>

#include <algorithm>

namespace app {

SnapTo SnapTo::usual()
{
    SnapTo usual = Nothing;
    for (const SnapKind& kind : snapKinds())
        if (kind.usual)
            usual = usual.with(kind.key);
    return usual;
}

std::size_t SnapTo::size() const
{
    return std::size_t(
        std::ranges::count_if(snapKinds(), [this](const SnapKind& kind) { return has(kind); }));
}

QString SnapTo::text() const
{
    QStringList words;
    for (const SnapKind& kind : snapKinds())
        words << (has(kind) ? u'+' : u'-') + latin(kind.key);
    return words.join(u' ');
}

SnapTo SnapTo::fromText(const QString& text)
{
    SnapTo to = usual();
    const QStringList words = text.left(1000).split(u' ');
    for (const SnapKind& kind : snapKinds()) {
        const auto key = latin(kind.key);
        if (words.contains(u'+' + key))
            to = to.with(kind.key);
        else if (words.contains(u'-' + key))
            to = to.without(kind.key);
    }
    return to;
}

} // namespace app
