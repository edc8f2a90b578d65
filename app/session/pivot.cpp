// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/pivot.h"

#include "app/session/session.h"
#include "app/view/handles.h"

namespace app {

bool Pivot::isMoved() const
{
    const auto& bounds = session_.selectionBounds();
    return put_ && bounds && bounds->min == bounds_.min && bounds->max == bounds_.max
           && selection_ == session_.selection();
}

Point Pivot::at() const
{
    return isMoved() ? *put_
                     : placeOf(Handle{}, session_.selectionBounds().value_or(clipping::Window{}));
}

void Pivot::put(const Point& place)
{
    put_ = place;
    selection_ = session_.selection();
    bounds_ = session_.selectionBounds().value_or(clipping::Window{});
}

} // namespace app
