// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/losses.h"

#include <algorithm>

namespace app::dxf {

void drawInsert(const Entity& entity)
{
    const Record& record = entity.record;
    const auto count = [&](int code) { return std::size_t(std::max(record.integer(code, 1), 1)); };
    const Space place = entity.plane() * moved(record.point(10)) * turned(record.number(50));
    const Space size = scaled({record.number(41, 1), record.number(42, 1), record.number(43, 1)});
    entity.drawer.report().add(losses::insert);
    entity.drawer.insert(entity, record.text(2),
                         {place, size, count(70), count(71), record.number(44), record.number(45)});
}

// The program that wrote the file drew it in a block.
void drawDimension(const Entity& entity)
{
    const std::string_view name = entity.record.text(2);
    if (!entity.drawer.hasBlock(name)) {
        entity.drawer.report().add(losses::plainDimension);
        return;
    }
    entity.drawer.report().add(losses::dimension);
    entity.drawer.insert(entity, name,
                         {.place = entity.place.space * moved(entity.record.point(12))});
}

} // namespace app::dxf
