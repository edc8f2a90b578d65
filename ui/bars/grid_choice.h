// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QToolButton>

namespace ui {

class LengthField;

/// Shows and hides the grid, and sets its spacing.
class GridChoice : public QWidget {
    Q_OBJECT

public:
    explicit GridChoice(app::Session& session);

    LengthField& spacing() { return *spacing_; }
    void showSpacing(bool shown);

private:
    void setSpacing(double length);
    void follow();

    app::Session& session_;
    QToolButton* switch_;
    LengthField* spacing_;
};

} // namespace ui
