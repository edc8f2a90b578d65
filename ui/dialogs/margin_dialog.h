// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QDialog>

namespace ui {

/// Lays a clip window on the page without a margin.
class MarginDialog : public QDialog {
    Q_OBJECT

public:
    MarginDialog(app::Session& session, QWidget* parent);

    static void show(app::Session& session, QWidget& parent);
    void accept() override;

private:
    app::Session& session_;
    double margin_; ///< in user units
};

} // namespace ui
