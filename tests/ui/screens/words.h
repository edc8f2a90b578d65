// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QComboBox>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>
#include <QWidget>

#include "tests/ui/fresh/shown_by.h"

// What a screen says: the words on it, and those that it tells under the pointer and to a screen
// reader; one line for each widget, item and action.

namespace ui {

namespace screen_words {

/// What is said of a widget, beside what is painted.
inline QStringList of(const QWidget& widget)
{
    static constexpr std::array names{
        "text",           "title",   "currentText",          "value", "placeholderText",
        "accessibleName", "toolTip", "accessibleDescription"};
    QStringList words;
    for (const char* name : names)
        if (const QString said = widget.property(name).toString();
            !said.isEmpty() && !words.contains(said))
            words << said;
    if (widget.property("checked").toBool())
        words << QStringLiteral("[checked]");
    if (!words.isEmpty() && !widget.isEnabled())
        words << QStringLiteral("[disabled]");
    return words;
}

inline QStringList of(const QModelIndex& index)
{
    QStringList words;
    for (const int role : {int(Qt::DisplayRole), int(Qt::AccessibleTextRole), int(Qt::ToolTipRole)})
        if (const QString said = index.data(role).toString();
            !said.isEmpty() && !words.contains(said))
            words << said;
    if (index.data(Qt::CheckStateRole).toInt() == Qt::Checked)
        words << QStringLiteral("[checked]");
    return words;
}

inline void add(QStringList& lines, int depth, const QStringList& words)
{
    if (!words.isEmpty())
        lines << QString(depth, u' ')
                     + words.join(QStringLiteral(" | ")).replace(u'\n', QStringLiteral("\\n"));
}

inline void add(QStringList& lines, int depth, const QList<QAction*>& actions)
{
    for (const QAction* action : actions) {
        QStringList words{action->isSeparator() ? QStringLiteral("-") : action->text()};
        if (!action->shortcut().isEmpty())
            words << action->shortcut().toString();
        if (action->toolTip() != QString(action->text()).remove(u'&'))
            words << action->toolTip();
        if (action->isChecked())
            words << QStringLiteral("[checked]");
        if (!action->isEnabled())
            words << QStringLiteral("[disabled]");
        if (action->isVisible())
            add(lines, depth, words);
        if (action->menu())
            add(lines, depth + 1, action->menu()->actions());
    }
}

inline void add(QStringList& lines, int depth, const QAbstractItemModel& model)
{
    constexpr int most = 20; // rows
    for (int row = 0; row < std::min(model.rowCount(), most); ++row) {
        QStringList words;
        for (int column = 0; column < model.columnCount(); ++column)
            for (const QString& said : of(model.index(row, column)))
                if (!words.contains(said))
                    words << said;
        add(lines, depth, words);
    }
}

inline void add(QStringList& lines, int depth, const QWidget& widget)
{
    if (qobject_cast<const QScrollBar*>(&widget))
        return;
    add(lines, depth, of(widget));
    if (const auto* menu = qobject_cast<const QMenu*>(&widget))
        return add(lines, depth, menu->actions());
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->model())
        add(lines, depth + 1, *view->model());
    if (const auto* button = qobject_cast<const QToolButton*>(&widget); button && button->menu())
        add(lines, depth + 1, button->menu()->actions());
    for (const QWidget* part : shown_by::partsOf(widget))
        add(lines, depth + 1, *part);
}

} // namespace screen_words

inline QString wordsOf(const QWidget& widget)
{
    QStringList lines;
    screen_words::add(lines, 0, widget);
    return lines.join(u'\n') + u'\n';
}

} // namespace ui
