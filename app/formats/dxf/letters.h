// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/drawer.h"

#include <QStringList>

namespace app::dxf {

/// A line of letters in the plane of its text, y up.
struct TextLine {
    QString text{};
    double size = 1; ///< the height of capital letters
    Point shift{0};  ///< of the begin of its baseline
};

double widthOf(const TextLine& line);
/// Breaks paragraphs at blanks, so that no line is wider than `width`; 0: as wide as they are.
QStringList wrapped(const QStringList& paragraphs, double size, double width);
Space slanted(double degrees);

/// Whether a text is too long to be drawn, which is reported.
bool refusesText(const Entity& entity, qsizetype letters);
/// Adds the lines as one shape of strokes. One line that is not distorted stays a text.
void addLetters(const Entity& entity, const std::vector<TextLine>& lines, const Space& space);

} // namespace app::dxf
