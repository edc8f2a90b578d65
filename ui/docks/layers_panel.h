// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/layer_list.h"

#include <QToolButton>

#include <optional>

namespace ui {

class ColourPopup;
class SearchField;

/// The layers: eye, colour, name, number of objects, padlock; and the groups and objects of those
/// that are open, or what the field above them finds. New objects go to the layer that was clicked
/// last.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    explicit LayersPanel(app::Session& session, QWidget* parent = nullptr);

private:
    void chooseColour(app::ContainerId layer);
    void follow();
    void sayFound();
    void reveal();
    void restoreCurrent();
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

    app::Session& session_;
    LayerModel* model_;
    LayerList* list_;
    SearchField* search_;
    QToolButton *add_, *remove_;
    QWidget* row_; ///< the place of a row: never shown, the colours open below it
    ColourPopup* colours_;
    std::optional<LayerModel::RowKey> current_; ///< as it was last chosen
    app::ContainerId coloured_ = 0;             ///< the layer for which the colours are open
};

} // namespace ui
