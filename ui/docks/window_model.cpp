// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_model.h"

#include "app/base/text.h"
#include "app/document/window_operations.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"
#include "ui/look/text.h"

#include <QColor>

#include <algorithm>

namespace ui {

namespace {

QString operationText(app::WindowOperation operation) { return app::infoOf(operation).verb; }

} // namespace

static bool looksAlike(const app::ClipWindow& a, const app::ClipWindow& b)
{
    return a.name == b.name && a.operation == b.operation && a.visible == b.visible
           && app::iconOf(a.shape) == app::iconOf(b.shape) && a.colour == b.colour;
}

WindowModel::WindowModel(app::Session& session, QObject* parent)
    : CheckedModel(parent), session_(session), shown_(session.windows())
{
    connect(&session, &app::Session::previewChanged, this, &WindowModel::follow);
}

// A drag changes shapes at every frame, but rarely a row.
void WindowModel::follow()
{
    const app::ClipWindows& now = session_.windows();
    const bool same = now.list.size() == shown_.list.size();
    const bool alike = std::ranges::equal(now.list, shown_.list, looksAlike);
    if (!same)
        beginResetModel();
    shown_ = now;
    if (!same)
        endResetModel();
    else if (!alike)
        tellChanged();
}

int WindowModel::rows() const { return int(shown_.list.size()); }

QVariant WindowModel::cell(int row, int, int role) const
{
    const app::ClipWindow& window = shown_.list[std::size_t(row)];
    const QString name = app::nameOf(window);
    const QString replaced = app::replacedText(shown_, std::size_t(row));
    switch (role) {
    case Qt::DisplayRole:
        return name;
    case Qt::EditRole:
        return window.name;
    case VisibleRole:
        return window.visible;
    case CountsRole:
        return window.visible && replaced.isEmpty();
    case OperationRole:
        return int(window.operation);
    case IconRole:
        return app::latin(app::iconOf(window.shape));
    case ColourRole:
        return window.colour ? QColor(window.colour->red, window.colour->green, window.colour->blue)
                             : QColor();
    case Qt::AccessibleTextRole:
        return !window.visible      ? Text::tr("%1, hidden").arg(name)
               : replaced.isEmpty() ? Text::tr("%1, %2").arg(name, operationText(window.operation))
                                    : Text::tr("%1, %2").arg(name, replaced);
    case Qt::ToolTipRole:
        if (!replaced.isEmpty())
            return replaced;
        return Text::tr(
                   "%1 %2. Windows apply from top to bottom. Drag, or Ctrl+Up, Ctrl+Down: move; "
                   "double click: rename")
            .arg(name, operationText(window.operation));
    default:
        return {};
    }
}

bool WindowModel::change(int row, const QVariant& value, int role)
{
    const auto change = [&](const QString& text, auto edit) {
        app::changeWindow(session_, std::size_t(row), text, edit);
        return true;
    };
    if (role == VisibleRole)
        return change(value.toBool() ? Text::tr("Show clip window") : Text::tr("Hide clip window"),
                      [&](app::ClipWindow& window) { window.visible = value.toBool(); });
    if (role == Qt::EditRole)
        return change(Text::tr("Rename clip window"),
                      [&](app::ClipWindow& window) { window.name = value.toString().trimmed(); });
    return false;
}

} // namespace ui

#include "moc_window_model.cpp"
