// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QLabel>

namespace ui {

/// The number of lines of the drawing.
class CountPanel : public QLabel {
public:
    explicit CountPanel(app::Session& session)
    {
        const auto show = [this, &session] { setNum(int(session.scene.lines().size())); };
        QObject::connect(&session, &app::Session::previewChanged, this, show);
        show();
    }
};

} // namespace ui
