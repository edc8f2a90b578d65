// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <QStringList>

namespace app {

/// The families of outline fonts that are installed on the computer, in alphabetic order. Read
/// once; empty in a program without a QGuiApplication.
const QStringList& outlineFonts();

/// The nearest to the wanted face among those that the family has; plain for a font of strokes. For
/// any other face Qt would slant or thicken the plain letters by itself.
FontFace faceOf(const QString& family, const FontFace& wanted);

/// Whether letters can be written in this font: one of strokes, or an installed one.
bool hasFont(const QString& name);

/// The font that replaces one that is not installed: the one that the system takes for it, or else
/// the first font of strokes.
QString fontInsteadOf(const QString& name);

} // namespace app
