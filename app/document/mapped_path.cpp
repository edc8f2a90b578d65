// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/mapped_path.h"

#include "app/document/path_points.h"
#include "app/document/recipe_outline.h"

namespace app {

Path mapped(const Path& path, const AffineMap& map)
{
    if (const auto line = path.singleLine())
        return Path(clipping::Segment{map(line->a), map(line->b)});
    std::vector<Subpath> subpaths = path.subpaths();
    for (Subpath& subpath : subpaths)
        forEachPoint(subpath, [&](Point& p) { p = map(p); });
    return Path(subpaths);
}

void transform(Path& path, Recipe& recipe, const AffineMap& map)
{
    recipe = mapped(recipe, map);
    const auto where = map.placement();
    const bool turns = !where || where->scale.x < 0 || where->scale.y < 0;
    const auto outline = turns ? outlineOf(recipe) : std::nullopt;
    path = outline ? Path(std::span(&*outline, 1)) : mapped(path, map);
}

} // namespace app
