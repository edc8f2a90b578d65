// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/recovery/replay.h"

#include <QFrame>
#include <QImage>

namespace ui {

/// A picture of a leftover drawing, which another thread recovers and paints.
class LeftoverPicture : public QFrame {
    Q_OBJECT

public:
    explicit LeftoverPicture(QWidget* parent = nullptr);

    void showPicture(const app::Leftover& leftover);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QImage picture_;
    QString sentence_; ///< in place of a picture
    app::Background<QImage> background_;
};

} // namespace ui
