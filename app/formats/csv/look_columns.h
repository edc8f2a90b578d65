// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <QString>

#include <string>

namespace app::csv {

/// The first line of a table, with its line break; with the column `source`, or without it.
std::string headerText(bool withSource);

/// The columns of a row between its coordinates and its source: ",layer,colour,width".
std::string lookColumns(const QString& layer, const Colour& strokeColour, double width);

/// The name of the layer of rows without one.
QString usualLayer();

} // namespace app::csv
