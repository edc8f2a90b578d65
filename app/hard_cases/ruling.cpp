// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hard_cases/ruling.h"

#include <array>

namespace app {

static constexpr std::array<const char*, 8> keys{"right",   "allowed", "lost",         "shown",
                                                 "outside", "moved",   "not-a-number", "endless"};

QString keyOf(Ruling ruling) { return QLatin1StringView(keys[std::size_t(ruling)]); }

std::optional<Ruling> findRuling(const QString& key)
{
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (key == QLatin1StringView(keys[i]))
            return Ruling(i);
    return std::nullopt;
}

} // namespace app
