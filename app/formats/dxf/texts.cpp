// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/letters.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/dxf/text_code.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app::dxf {
namespace {

TextStyle styleOf(const Entity& entity)
{
    const auto& styles = entity.drawer.tables().textStyles;
    const auto found = styles.find(inCapitals(entity.record.text(7, "STANDARD")));
    return found == styles.end() ? TextStyle{} : found->second;
}

QString entityText(const Entity& entity, std::string_view bytes)
{
    const Header& header = entity.drawer.header();
    if (isForeign(bytes, header))
        entity.drawer.report().add(losses::otherCodePage, header.codePage);
    return textOf(bytes, header);
}

double heightOf(const Entity& entity, const TextStyle& style)
{
    const double usual = style.height > 0 ? style.height : 1;
    const double height = entity.record.number(40, usual);
    return height > 0 ? height : usual;
}

/// The values of group 72 of a text.
enum Horizontal { Left, Centre, Right, Aligned, Middle, Fit };

// The share of a line's width, and of the height of capitals, that is before its point.
double shareBefore(int horizontal)
{
    return horizontal == Centre || horizontal == Middle ? 0.5 : horizontal == Right ? 1 : 0;
}
double shareBelow(int horizontal, int vertical)
{
    constexpr double depth = -1.0 / 3; // of letters below the line
    constexpr std::array shares{0.0, depth, 0.5, 1.0};
    return horizontal == Middle ? 0.5 : shares[std::size_t(std::clamp(vertical, 0, 3))];
}

} // namespace

void drawText(const Entity& entity)
{
    const Record& record = entity.record;
    constexpr int invisible = 1, backwards = 2, upsideDown = 4;
    if (record.type == "ATTRIB" && (record.integer(70) & invisible) != 0)
        return;
    const TextStyle style = styleOf(entity);
    const int horizontal = record.integer(72);
    const int vertical = record.integer(record.type == "ATTRIB" ? 74 : 73);
    const bool aligned = (horizontal != Left || vertical != 0) && record.has(11);
    const glm::dvec3 first = record.point(10), second = record.point(11);
    const int generation =
        record.integer(71, (style.backwards ? backwards : 0) | (style.upsideDown ? upsideDown : 0));
    TextLine line{plainText(entityText(entity, record.text(1)))};
    if (refusesText(entity, line.text.size()))
        return;
    line.size = heightOf(entity, style);
    const double width = widthOf(line);
    double angle = record.number(50), wide = record.number(41, style.widthFactor);
    if (aligned && (horizontal == Aligned || horizontal == Fit) && width > 0) {
        const glm::dvec3 along = second - first;
        const double length = std::hypot(along.x, along.y);
        angle = glm::degrees(std::atan2(along.y, along.x));
        if (horizontal == Aligned)
            line.size *= length / (width * wide);
        else
            wide = length / width;
    }
    const bool between = horizontal == Aligned || horizontal == Fit;
    line.shift = {-widthOf(line) * shareBefore(horizontal),
                  -line.size * shareBelow(horizontal, vertical)};
    const Space space = entity.plane() * moved(aligned && !between ? second : first) * turned(angle)
                        * slanted(record.number(51, style.oblique))
                        * scaled({(generation & backwards) != 0 ? -wide : wide,
                                  (generation & upsideDown) != 0 ? -1 : 1, 1});
    addLetters(entity, {line}, space);
}

void drawDefinition(const Entity& entity)
{
    constexpr int constant = 2;
    if ((entity.record.integer(70) & constant) != 0)
        drawText(entity);
    else if (entity.place.depth == 0)
        entity.drawer.report().add(losses::unread, entity.record.type);
}

void drawMText(const Entity& entity)
{
    const Record& record = entity.record;
    std::string bytes;
    for (const auto& [code, value] : record.pairs)
        if (code == 1 || code == 3)
            bytes += value;
    const QStringList text = paragraphs(entityText(entity, bytes));
    if (refusesText(entity, text.join(u'\n').size()))
        return;
    const TextStyle style = styleOf(entity);
    const double size = heightOf(entity, style);
    double angle = record.number(50);
    if (record.has(11)) {
        const glm::dvec3 along = record.point(11);
        angle = glm::degrees(std::atan2(along.y, along.x));
    }
    std::vector<TextLine> lines;
    for (const QString& line : wrapped(text, size, record.number(41)))
        lines.push_back({line, size});
    const int place = std::clamp(record.integer(71, 1), 1, 9) - 1;
    constexpr double pitch = 5.0 / 3;
    const double step = size * pitch * record.number(44, 1);
    const double height = size + step * double(lines.size() - 1);
    const double top = height * (place / 3) / 2 - size;
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i].shift = {-widthOf(lines[i]) * (place % 3) / 2, top - step * double(i)};
    addLetters(entity, lines,
               entity.plane() * moved(record.point(10)) * turned(angle) * slanted(style.oblique)
                   * scaled({style.widthFactor, 1, 1}));
}

} // namespace app::dxf
