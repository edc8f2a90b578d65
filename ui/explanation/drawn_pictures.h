// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"

#include <QImage>

namespace ui {

/// The pictures of pages that the program draws (`app/session/manual_picture.h`), on another thread:
/// a sample takes longer than a frame.
class DrawnPictures : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The picture of an address. Until it is drawn, an empty one of its size; `drawn` follows.
    QImage picture(const QString& address, int width, double pixelRatio);

    /// The same at once, for paper.
    static QImage now(const QString& address, int width, double pixelRatio);

signals:
    void drawn();

private:
    struct Kept {
        QString address;
        int width = 0;
        double pixelRatio = 1;
        QImage image{};
    };
    Kept kept_, wanted_;
    app::Background<QImage> work_{app::paintingThreads()};
};

} // namespace ui
