// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/layer_model.h"

#include <QAction>
#include <QListView>

namespace ui {

/// The layers: eye, ink, name, number of lines, padlock. New shapes go to the chosen one.
class LayersPanel : public QWidget {
    Q_OBJECT

public:
    explicit LayersPanel(app::Session& session, QWidget* parent = nullptr);

    QAction* addAction() const { return add_; }
    QAction* removeAction() const { return remove_; }

private:
    void follow();

    app::Session& session_;
    LayerModel* model_;
    QListView* list_;
    QAction *add_, *remove_;
};

} // namespace ui
