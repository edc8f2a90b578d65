// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/layer_colour.h"
#include "app/session/units.h"
#include "app/session/window_words.h"
#include "ui/docks/layer_model.h"
#include "ui/look/text.h"

#include <QColor>

// What a row of the tree shows and says.

namespace ui {

using Kind = app::TreeRow::Kind;

QVariant LayerModel::cell(int number, int, int role) const
{
    const app::TreeRow& row = rows_[std::size_t(number)];
    if (!session_.now().containers().contains(row.container)
        || (row.kind == Kind::Object && row.number >= session_.now().objects().size()))
        return {}; // the document has changed; follow() will be called
    if (role == DepthRole)
        return row.depth;
    if (role == SelectedRole || role == HoldsRole)
        return selectedCell(row, role);
    return row.kind == Kind::Object ? objectCell(row, role)
           : row.kind == Kind::More ? moreCell(row, role)
                                    : containerCell(row, role);
}

QVariant LayerModel::containerCell(const app::TreeRow& row, int role) const
{
    const app::Containers& containers = session_.now().containers();
    const app::Container& container = containers[row.container];
    const bool isLayer = row.kind == Kind::Layer;
    const app::ObjectRange objects = containers.rangeOf(row.container);
    switch (role) {
    case Qt::DisplayRole:
        return isLayer ? container.name : app::groupName(container);
    case Qt::EditRole:
        return container.name;
    case VisibleRole:
        return container.visible;
    case LockedRole:
        return container.locked;
    case CountRole:
        return qulonglong(objects.size());
    case OpenRole:
        return objects.empty() || search_ ? QVariant() : QVariant(tree_.isOpen(row.container));
    case IconRole:
        return !isLayer             ? QVariant(QStringLiteral("group"))
               : container.underlay ? QVariant(QStringLiteral("image"))
                                    : QVariant();
    case PenRole:
        return isLayer && session_.pen.layer == row.container;
    case Qt::DecorationRole:
        if (!isLayer)
            return {};
        if (auto colour = app::layerColour(session_.now(), row.container);
            colour || (colour = app::strokeColourOf(session_.now(), row.container)))
            return QColor(colour->red, colour->green, colour->blue);
        return {};
    case Qt::ToolTipRole:
        return container.underlay
                   ? Text::tr("A layer above an image, which nothing selects. Right click: remove "
                              "the image. Double click: rename. Alt+click on the eye: show only "
                              "this layer. Drag: move.")
               : isLayer
                   ? Text::tr("Double click: rename. Click the colour: choose that of new objects. "
                              "Alt+click on the eye: show only this layer. Drag: move.")
                   : Text::tr("Click: select the group. Double click: rename. Drag: to a layer.");
    case Qt::AccessibleTextRole:
        return spoken(row, {container.visible ? Text::tr("shown") : Text::tr("hidden"),
                            container.locked ? Text::tr("locked") : Text::tr("not locked"),
                            objects.empty() || search_    ? QString()
                            : tree_.isOpen(row.container) ? Text::tr("open")
                                                          : Text::tr("closed")});
    default:
        return {};
    }
}

/// What a screen reader says of a row: its name, its level and what is seen of it.
QString LayerModel::spoken(const app::TreeRow& row, const QStringList& states) const
{
    const QModelIndex at = index(int(&row - rows_.data()));
    QStringList words{at.data().toString()};
    words += states;
    if (at.data(SelectedRole).toBool() && row.kind != Kind::Layer)
        words << Text::tr("selected");
    if (row.depth > 1)
        words << Text::tr("level %1").arg(row.depth);
    words.removeAll(QString());
    return words.join(QStringLiteral(", "));
}

QVariant LayerModel::objectCell(const app::TreeRow& row, int role) const
{
    const std::size_t object = row.number;
    const app::ObjectView view = session_.now().objects()[object];
    switch (role) {
    case Qt::DisplayRole:
        return app::objectName(session_, object);
    case Qt::EditRole:
        return view.particulars().id;
    case IconRole:
        return app::latin(app::iconOf(view));
    case VisibleRole:
        return !view.hidden();
    case Qt::ToolTipRole:
        return Text::tr("%1. Click: select it. Double click: name it. Drag: to a layer.")
            .arg(app::nameOf(view));
    case Qt::AccessibleTextRole:
        return spoken(row, {view.hidden() ? Text::tr("hidden") : QString()});
    default:
        return {};
    }
}

QVariant LayerModel::moreCell(const app::TreeRow& row, int role) const
{
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole)
        return role == VisibleRole ? QVariant(false) : QVariant(); // muted
    return Text::tr("%1 more. Click to show some.").arg(app::countText(row.number));
}

QVariant LayerModel::selectedCell(const app::TreeRow& row, int role) const
{
    const app::ObjectRanges& selection = session_.selection();
    if (selection.empty())
        return role == SelectedRole && row.kind == Kind::Layer
               && row.container == session_.pen.layer;
    if (row.kind == Kind::Object)
        return role == SelectedRole && selection.contains(row.number);
    if (row.kind == Kind::More)
        return false;
    const app::ObjectRange in = session_.now().containers().rangeOf(row.container);
    const bool isWhole = row.kind == Kind::Group && !in.empty() && selection.contains(in);
    return role == SelectedRole ? isWhole : !isWhole && selection.intersects(in);
}

} // namespace ui
