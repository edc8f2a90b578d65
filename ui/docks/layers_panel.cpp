// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layers_panel.h"

#include "app/base/numbers.h"
#include "app/document/styles_in_use.h"
#include "app/session/layer_colour.h"
#include "app/session/recent_colours.h"
#include "app/view/colour_chart.h"
#include "ui/docks/algorithm_list.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/tabular.h"

#include <QMouseEvent>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

class LayerPainter : public RowPainter {
public:
    using RowPainter::RowPainter;

    void paint(QPainter* painter, const QStyleOptionViewItem& given,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(given.palette);
        drawRowGround(*painter, given);
        const QStyleOptionViewItem option = indented(given, index);
        const bool visible = index.data(LayerModel::VisibleRole).toBool();
        const bool locked = index.data(LayerModel::LockedRole).toBool();
        drawEye(*painter, option.rect, visible);
        icon(locked ? "lock" : "unlock")
            .paint(painter, lock(option.rect), Qt::AlignCenter,
                   locked ? QIcon::Normal : QIcon::Disabled);
        const QRect square = swatch(option.rect);
        if (const auto colour = index.data(Qt::DecorationRole).value<QColor>(); colour.isValid()) {
            painter->fillRect(square, colour);
        }
        painter->setPen(look.control); // a colour may be that of the row
        painter->drawRect(square.adjusted(0, 0, -1, -1));
        drawName(*painter, option, nameBox(option.rect), index.data().toString(), !visible);
        painter->setPen(look.muted);
        painter->setFont(captionFont(option.font));
        const QString count = app::countText(index.data(LayerModel::CountRole).toULongLong());
        drawTabular(*painter, option.rect.adjusted(0, 0, -38, 0), Qt::AlignRight | Qt::AlignVCenter,
                    count);
    }

    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override
    {
        editor->setGeometry(nameBox(indented(option, index).rect));
    }

    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& given,
                     const QModelIndex& index) override
    {
        const QStyleOptionViewItem option = indented(given, index);
        if (event->type() != QEvent::MouseButtonRelease)
            return false;
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        const QPoint at = mouse.position().toPoint();
        if (mouse.button() != Qt::LeftButton)
            return false;
        if (mouse.modifiers() & Qt::AltModifier && hits(eye(option.rect), at)) {
            static_cast<LayerModel*>(model)->showOnly(index);
            return true;
        }
        if (hits(swatch(option.rect), at)) {
            auto* list = static_cast<LayerList*>(parent());
            emit list->colourWanted(list->layerOf(index));
            return true;
        }
        for (const auto& [box, role] : {std::pair(eye(option.rect), LayerModel::VisibleRole),
                                        std::pair(lock(option.rect), LayerModel::LockedRole)})
            if (hits(box, at))
                return model->setData(index, !index.data(role).toBool(), role);
        return false;
    }

private:
    // Pixels per level; deeper levels are not indented further.
    static constexpr int indent = 14, deepest = 5;
    static QStyleOptionViewItem indented(QStyleOptionViewItem option, const QModelIndex& index)
    {
        const int depth = index.data(LayerModel::DepthRole).toInt();
        option.rect.adjust(std::min(depth - 1, deepest) * indent, 0, 0, 0);
        return option;
    }
    static QRect swatch(const QRect& row)
    {
        return {eye(row).right() + 9, row.center().y() - 5, 12, 12};
    }
    static QRect lock(const QRect& row)
    {
        return {row.right() - space::dockMargin - 15, row.center().y() - 7, 16, 16};
    }
    static QRect nameBox(const QRect& row)
    {
        return row.adjusted(space::dockMargin + 46, 0, -110, 0);
    }
};

} // namespace

LayersPanel::LayersPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new LayerModel(session, this)),
      list_(new LayerList(session, model_)), add_(iconButton("plus", Text::tr("Add layer"))),
      remove_(iconButton("bin", Text::tr("Delete layer"))), row_(new QWidget(list_->viewport())),
      colours_(new ColourPopup(this))
{
    row_->hide();
    colours_->hideEyedropper();
    connect(list_, &LayerList::colourWanted, this, &LayersPanel::chooseColour);
    connect(colours_, &ColourPopup::picked, this, [this](const std::optional<app::Colour>& colour) {
        if (session_.now().containers().contains(coloured_))
            app::setLayerColour(session_, coloured_, colour);
    });
    list_->setItemDelegate(new LayerPainter(list_));
    keepChoice(*list_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 4);
    column->setSpacing(2);
    column->addWidget(list_);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(space::dockMargin - 4, 0, space::dockMargin, 0);
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch();
    column->addLayout(buttons);
    connect(add_, &QToolButton::clicked, this, [this] {
        if (!model_->addLayer())
            return;
        list_->setCurrentIndex(model_->index(0));
        list_->edit(model_->index(0)); // to give it a name
    });
    connect(remove_, &QToolButton::clicked, this,
            [this] { model_->removeLayer(session_.pen.layer); });
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& current) {
                if (!current.isValid())
                    return;
                session_.pen.layer = model_->layerOf(current);
                remove_->setEnabled(model_->mayRemove(session_.pen.layer));
            });
    connect(model_, &QAbstractItemModel::modelReset, this, &LayersPanel::follow);
    connect(&session, &app::Session::loaded, this, &LayersPanel::follow);
    follow();
}

void LayersPanel::chooseColour(app::ContainerId layer)
{
    constexpr std::size_t rows = 2;
    coloured_ = layer;
    row_->setGeometry(list_->visualRect(model_->indexOf(layer)));
    colours_->open(*row_,
                   {app::coloursInUse(session_.now().objects(), rows * app::coloursInRow),
                    app::recentColours(QSettings()), app::layerColour(session_.now(), layer)});
}

void LayersPanel::follow()
{
    list_->setCurrentIndex(model_->indexOf(session_.pen.layer));
    remove_->setEnabled(model_->mayRemove(session_.pen.layer));
}

} // namespace ui

#include "moc_layers_panel.cpp"
