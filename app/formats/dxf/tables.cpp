// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/tables.h"

#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/losses.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace app::dxf {

std::string inCapitals(std::string_view name)
{
    std::string capitals(name);
    for (char& c : capitals)
        if (c >= 'a' && c <= 'z')
            c = char(c - 'a' + 'A');
    return capitals;
}

namespace {

constexpr int nameCode = 2, flagsCode = 70;

void readLayer(const Record& record, Tables& tables)
{
    LayerEntry layer{.name = record.text(nameCode)};
    const int colour = record.integer(62, layer.colour), flags = record.integer(flagsCode);
    layer.off = colour < 0;
    layer.frozen = (flags & 1) != 0;
    layer.locked = (flags & 4) != 0;
    layer.colour = std::abs(colour);
    if (record.has(420))
        layer.trueColour = record.integer(420);
    layer.lineType = inCapitals(record.text(6, layer.lineType));
    layer.weight = record.integer(370, layer.weight);
    tables.layers.push_back(std::move(layer));
}

void readLineType(const Record& record, Tables& tables)
{
    LineType type{numbersOf(record, 49)};
    if (type.dashes.size() > mostDashes)
        throw BadValue{};
    for (const auto& [code, value] : record.pairs)
        type.complex |= code == 74 && integerOf(value) != 0;
    tables.lineTypes.insert_or_assign(inCapitals(record.text(nameCode)), std::move(type));
}

void readTextStyle(const Record& record, Tables& tables)
{
    const int flags = record.integer(71);
    TextStyle style{record.number(40), record.number(41, 1), record.number(50), (flags & 2) != 0,
                    (flags & 4) != 0};
    if (!(style.widthFactor > 0))
        style.widthFactor = 1;
    tables.textStyles.insert_or_assign(inCapitals(record.text(nameCode)), style);
}

struct Table {
    std::string_view type;
    void (*read)(const Record& record, Tables& tables);
};
constexpr std::array tableRows{
    Table{"LAYER", readLayer},
    Table{"LTYPE", readLineType},
    Table{"STYLE", readTextStyle},
};

} // namespace

void readTableEntry(const Record& record, Tables& tables, Report& report)
{
    const auto row = std::ranges::find(tableRows, record.type, &Table::type);
    if (row == tableRows.end() || !record.has(nameCode))
        return;
    try {
        row->read(record, tables);
    } catch (const BadValue&) {
        report.turnTo(record.line);
        report.add(losses::badTableEntry);
    }
}

} // namespace app::dxf
