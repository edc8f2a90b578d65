// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

namespace ui {

/// Draws numbers so that they do not jump: if the font's digits differ in width, every digit gets
/// the width of 0.
void drawTabular(QPainter& painter, const QRect& rect, Qt::Alignment alignment,
                 const QString& text);
int tabularWidth(const QFontMetrics& metrics, const QString& text);

} // namespace ui
