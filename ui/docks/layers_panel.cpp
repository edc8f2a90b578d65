// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layers_panel.h"

#include "app/base/numbers.h"
#include "app/document/styles_in_use.h"
#include "app/session/layer_colour.h"
#include "app/session/recent_colours.h"
#include "app/view/colour_chart.h"
#include "ui/docks/layer_painter.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/search_field.h"

#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>

namespace ui {

LayersPanel::LayersPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(new LayerModel(session, this)),
      list_(new LayerList(session, model_)),
      search_(new SearchField(Text::tr("Find a layer, group or object"))),
      add_(iconButton("plus", Text::tr("Add layer"))),
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
    list_->setItemDelegate(new LayerPainter(*list_));
    keepChoice(*list_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 4);
    column->setSpacing(2);
    auto* above = new QHBoxLayout;
    above->setContentsMargins(space::dockMargin, 0, space::dockMargin, 2);
    above->addWidget(search_);
    column->addLayout(above);
    column->addWidget(list_);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(space::dockMargin - 4, 0, space::dockMargin, 0);
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch();
    column->addLayout(buttons);
    connect(add_, &QToolButton::clicked, this, [this] {
        search_->clear();
        if (!model_->addLayer())
            return;
        list_->setCurrentIndex(model_->index(0));
        list_->edit(model_->index(0)); // to give it a name
    });
    connect(remove_, &QToolButton::clicked, this,
            [this] { model_->removeLayer(session_.pen.layer); });
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& current) {
                if (const app::TreeRow* row = model_->rowAt(current); row && !model_->changesRows())
                    current_ = model_->keyOf(*row);
                const app::ContainerId layer = model_->layerOf(current);
                if (layer == 0 || model_->changesRows())
                    return;
                session_.pen.layer = layer;
                remove_->setEnabled(model_->mayRemove(layer));
                list_->viewport()->update(); // both rows
                emit session_.displayChanged(); // its style for new objects
            });
    connect(model_, &QAbstractItemModel::modelReset, this, &LayersPanel::follow);
    connect(model_, &LayerModel::rowsChanged, this, &LayersPanel::restoreCurrent);
    connect(&session, &app::Session::loaded, this, &LayersPanel::follow);
    connect(&session, &app::Session::selectionChanged, this, &LayersPanel::reveal);
    connect(search_, &QLineEdit::textChanged, model_, &LayerModel::find);
    connect(model_, &LayerModel::foundChanged, this, &LayersPanel::sayFound);
    connect(search_, &SearchField::left, this, [this] {
        if (!list_->currentIndex().isValid() || model_->finds())
            list_->setCurrentIndex(model_->firstFound());
        list_->setFocus(Qt::TabFocusReason);
    });
    follow();
}

void LayersPanel::sayFound()
{
    search_->showResult(!model_->finds()       ? QString()
                        : model_->found() == 0 ? Text::tr("none")
                                               : app::countText(model_->found()));
}

void LayersPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    model_->setSeen(true);
    reveal();
}

void LayersPanel::hideEvent(QHideEvent* event)
{
    model_->setSeen(false);
    QWidget::hideEvent(event);
}

/// The row of the same object or group, if the list still has it; else that of the current layer.
void LayersPanel::restoreCurrent()
{
    if (current_ && current_->first != app::TreeRow::Kind::Layer)
        if (const QModelIndex same = model_->indexOf(*current_); same.isValid()) {
            if (same != list_->currentIndex())
                list_->setCurrentIndex(same);
            return;
        }
    const app::TreeRow* row = model_->rowAt(list_->currentIndex());
    if (!row || row->kind == app::TreeRow::Kind::Layer)
        follow();
}

/// Opens what is around the selected object or group, unless it was selected here.
void LayersPanel::reveal()
{
    if (!isVisible() || list_->selects())
        return;
    const QPersistentModelIndex row = model_->revealSelection();
    QTimer::singleShot(0, list_, [row, list = list_] { // when the panel has its height
        if (row.isValid())
            list->scrollTo(row);
    });
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
