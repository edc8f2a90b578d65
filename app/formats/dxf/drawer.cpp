// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/drawer.h"

#include "app/base/finite.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/flatten.h"
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/svg/refused.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app::dxf {

Drawer::Drawer(const Header& header, const Tables& tables, const Blocks& blocks, Report& report,
               std::size_t bytes)
    : header_(header), tables_(tables), blocks_(blocks), report_(report),
      pens_(header, tables, report), layers_(tables, header),
      mostParts_(std::max(mostParts, bytes)), tolerance_(units(flatteningMillimetres))
{
}

static bool endsEntities(std::string_view type)
{
    static constexpr std::array<std::string_view, 6> ends{"",      "ENDBLK",  "ENDSEC",
                                                          "BLOCK", "SECTION", "EOF"};
    return std::ranges::find(ends, type) != ends.end();
}

void Drawer::drawAll(Records records, const Place& place)
{
    Record record;
    std::size_t before = records.pairsRead();
    while (!endsEntities(records.nextType())) {
        records.next(record);
        if (records.nextType().empty())
            break; // the file ends here, perhaps within this entity
        report_.turnTo(record.line);
        draw({record, records, place, *this});
        if (place.depth > 0)
            countRepeated(records.pairsRead() - std::exchange(before, records.pairsRead()));
    }
}

void Drawer::draw(const Entity& entity)
{
    const Record& record = entity.record;
    try {
        if (record.integer(67) == 1) {
            if (isWhole(record.type))
                report_.add(losses::paperSpace);
            return;
        }
        if (const EntityType* const type = findEntityType(record.type))
            type->draw(entity);
        else
            report_.add(losses::unread, record.type);
    } catch (const BadValue&) {
        report_.turnTo(record.line);
        report_.add(losses::badEntity, record.type);
    }
}

std::size_t Drawer::layerOf(const Entity& entity)
{
    const std::string_view name = entity.record.text(8, "0");
    return name == "0" && entity.place.layer ? *entity.place.layer : layers_.indexOf(name);
}

bool Drawer::isHidden(const Entity& entity) const
{
    return entity.place.hidden || entity.record.integer(60) == 1;
}

StyleEntry Drawer::styleOf(const Entity& entity, std::size_t layer, Paint paint, double width)
{
    const Pen pen = pens_.penOf(entity.record, layers_[layer], entity.place.pen);
    if (pen.lineType && pen.lineType->complex && paint == Paint::Stroke)
        report_.add(losses::complexLineType);
    Style style = pens_.styleOf(pen, paint, width);
    if (!lastEntry_ || style != last_) {
        lastEntry_ = layers_.style(style);
        last_ = std::move(style);
    }
    return *lastEntry_;
}

void Drawer::addLine(const Entity& entity, const clipping::Segment& line)
{
    if (!isFinite(line))
        throw BadValue{};
    if (isHidden(entity) || line.a == line.b) {
        add(entity, {{{line.a, {{line.b}}, false}}});
        return;
    }
    count(2);
    const std::size_t layer = layerOf(entity);
    layers_.addLine(layer, line, styleOf(entity, layer, Paint::Stroke, 0));
}

void Drawer::add(const Entity& entity, Shape shape)
{
    for (Subpath& path : shape.paths) {
        bool finite = true, moves = false;
        forEachPoint(path, [&](const Point& p) {
            finite = finite && isFinite(p);
            moves = moves || p != path.start;
        });
        if (!finite)
            throw BadValue{};
        if (!moves)
            path = {path.start, {}, false}; // a point
        count(1 + chordCount(path, tolerance_));
    }
    if (shape.paths.empty()) {
        report_.add(losses::sizeless);
        return;
    }
    const std::size_t layer = layerOf(entity);
    const StyleEntry style = styleOf(entity, layer, shape.paint, shape.width);
    ObjectRow row{Path(shape.paths), style, isHidden(entity)};
    if (!std::holds_alternative<std::monostate>(shape.recipe))
        row.particulars = Shared(Particulars{.recipe = std::move(shape.recipe)});
    layers_.add(layer, row);
}

void Drawer::insert(const Entity& entity, std::string_view name, const Insertion& insertion)
{
    const auto found = blocks_.find(inCapitals(name));
    if (found == blocks_.end() || found->second.other) {
        report_.add(found == blocks_.end() ? losses::missingBlock : losses::otherDrawing);
        return;
    }
    const Block& block = found->second;
    const bool again = std::ranges::find(open_, &block) != open_.end();
    if (again || entity.place.depth >= deepestInsert) {
        report_.add(again ? losses::selfInsert : losses::deepInsert);
        return;
    }
    const std::size_t layer = layerOf(entity);
    Place inside{.layer = layer,
                 .pen = pens_.penOf(entity.record, layers_[layer], entity.place.pen),
                 .hidden = isHidden(entity) || layers_[layer].frozen,
                 .depth = entity.place.depth + 1};
    open_.push_back(&block);
    const auto& [place, size, columns, rows, right, up] = insertion;
    const Space content = size * moved(-block.base);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            countRepeated(pairsOfInsert);
            inside.space = place * moved({double(column) * right, double(row) * up, 0}) * content;
            drawAll(block.content, inside);
        }
    open_.pop_back();
}

void Drawer::count(std::size_t parts)
{
    parts_ += parts;
    if (parts_ > mostParts_)
        throw svg::Refused{
            Text::tr("exceeds the limit of %1 points in a drawing.").arg(countText(mostParts_)),
            report_.line()};
}

void Drawer::countRepeated(std::size_t pairs)
{
    repeated_ += pairs;
    if (repeated_ > mostRepeatedPairs)
        throw svg::Refused{Text::tr("inserts blocks too often: more than %1 values of their "
                                    "entities would be read.")
                               .arg(countText(mostRepeatedPairs)),
                           report_.line()};
}

Document Drawer::take()
{
    report_.turnTo(0);
    report_.add(losses::layers, layers_.beyond());
    return layers_.take();
}

} // namespace app::dxf
