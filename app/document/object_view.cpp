// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_view.h"

namespace app {

bool hasArea(const ObjectView& object) { return !object.singleLine() && object.path().hasArea(); }

std::optional<Colour> lineColour(const ObjectView& object)
{
    const Style& style = object.style();
    return style.stroke || !hasArea(object) ? style.stroke : style.fill;
}

std::optional<Colour> lineColour(const Object& object)
{
    const Style& style = object.style;
    return style.stroke || !object.path.hasArea() ? style.stroke : style.fill;
}

} // namespace app
