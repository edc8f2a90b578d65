// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/header.h"

#include <QString>

#include <map>
#include <string>
#include <vector>

namespace app::dxf {

/// Names of layers, blocks, line types and text styles are the same in capitals.
std::string inCapitals(std::string_view name);

struct LayerEntry {
    std::string_view name{};             ///< as written
    int colour = 7;                      ///< of the index
    std::optional<int> trueColour{};     ///< 0xrrggbb
    std::string lineType = "CONTINUOUS"; ///< in capitals
    int weight = -3;                     ///< hundredths of a millimetre; -3: usual
    bool off = false, frozen = false, locked = false;
};

/// Dashes (positive), gaps (negative) and points (0), in drawing units.
struct LineType {
    std::vector<double> dashes{};
    bool complex = false; ///< with texts or symbols
};

struct TextStyle {
    double height = 0; ///< 0: each text has its own
    double widthFactor = 1, oblique = 0;
    bool backwards = false, upsideDown = false;
};

/// The tables of a file: what entities refer to by name.
struct Tables {
    std::vector<LayerEntry> layers{}; ///< in the order of the file
    std::map<std::string, LineType, std::less<>> lineTypes{};
    std::map<std::string, TextStyle, std::less<>> textStyles{};
};

/// Takes the record if it is an entry of a table.
void readTableEntry(const Record& record, Tables& tables, Report& report);

} // namespace app::dxf
