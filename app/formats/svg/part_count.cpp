// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/part_count.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/flatten.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"

#include <cmath>

namespace app::svg {

void PartCount::add(const Object& object)
{
    const Style& style = object.style;
    const auto fits = [](double length) { return std::abs(length) <= largestCoordinate; };
    if (!(fits(style.width) && fits(style.dashOffset) && std::ranges::all_of(style.dashes, fits)))
        throw Refused{Text::tr("has a stroke that is too large to be drawn.")};
    parts_ += partsOf(object);
    const std::size_t most = allowed(mostParts);
    if (parts_ > most)
        throw Refused{
            Text::tr("exceeds the limit of %1 points in a drawing.").arg(countText(most))};
}

void PartCount::remove(const Object& object) { parts_ -= partsOf(object); }

std::size_t PartCount::partsOf(const Object& object) const
{
    std::size_t parts = 1 + object.style.dashes.size();
    if (object.path.singleLine())
        return parts + 2;
    for (const Subpath& path : object.path.subpaths())
        parts += 1 + chordCount(path, tolerance_);
    return parts;
}

} // namespace app::svg
