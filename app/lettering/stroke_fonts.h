// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lettering/hershey_file.h"

#include <QString>

#include <span>

namespace app {

/// A font of strokes: a plotter follows each of them once. The letters were drawn by A. V. Hershey
/// at the U.S. National Bureau of Standards, the format of the files is by James Hurt, Cognition,
/// Inc. They come from Debian's package hershey-fonts-data.
struct StrokeFont {
    QString name;               ///< for the person, and in files
    std::string_view file;      ///< of its ASCII characters
    std::string_view greekFile; ///< of Greek letters in the same weight
};

/// The catalogue, in the order of lists.
std::span<const StrokeFont> strokeFonts();
const StrokeFont* findStrokeFont(const QString& name); ///< null: there is none of this name

/// The glyphs of a file by its name, compiled into the program; empty if it was built without the
/// package. Read once.
const std::vector<HersheyGlyph>& hersheyGlyphs(std::string_view file);

/// A glyph in the font's units, scaled.
struct FoundGlyph {
    const HersheyGlyph* glyph = nullptr;
    double scale = 1;
};
/// The glyph of a character: of the font itself, or for Greek and Cyrillic letters of their own
/// files. A null glyph: there is none.
FoundGlyph glyphOf(char32_t character, const StrokeFont& font);

} // namespace app
