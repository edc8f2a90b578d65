// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QRect>

class QAbstractItemModel;

namespace ui {

/// Draws numbers so that they do not jump: if the font's digits differ in width, every digit gets
/// the width of 0.
void drawTabular(QPainter& painter, const QRect& rect, Qt::Alignment alignment,
                 const QString& text);
int tabularWidth(const QFontMetrics& metrics, const QString& text);

/// Copies cells as tab-separated text below the headings of their columns. `area`: columns are x,
/// rows are y.
void copyCells(const QAbstractItemModel& model, const QRect& area);

} // namespace ui
