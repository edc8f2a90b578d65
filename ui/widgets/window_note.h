// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QLabel>

namespace ui {

/// A hint above the first drawing, in a strip of its own: how to use a clip window or how to add
/// one. It stays until a clip window is changed.
class WindowNote : public QLabel {
    Q_OBJECT

public:
    explicit WindowNote(const app::Session& session);

signals:
    void learnt(); ///< a clip window was changed: never show the hint again

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    const app::Session& session_;
};

} // namespace ui
