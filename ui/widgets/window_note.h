// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QLabel>

namespace ui {

/// What to do first, with a clip window or to get one, in a strip of its own above the first
/// drawing, until a clip window is changed.
class WindowNote : public QLabel {
    Q_OBJECT

public:
    explicit WindowNote(const app::Session& session);

signals:
    void learnt(); ///< a clip window was changed: never again

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    const app::Session& session_;
};

} // namespace ui
