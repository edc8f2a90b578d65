// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"

#include <QImage>

#include <deque>

namespace ui {

struct Look;

/// The pictures of pages that the program draws (`app/session/manual_picture.h`), on another
/// thread: a sample takes longer than a frame.
class DrawnPictures : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The picture of an address on a page of this look. Until it is drawn, an empty one of its
    /// size; `drawn` follows.
    QImage picture(const QString& address, int width, double pixelRatio, const Look& look);

    /// The same at once, for paper.
    static QImage now(const QString& address, int width, double pixelRatio);

signals:
    void drawn();

private:
    struct Kept {
        QString address;
        int width = 0;
        double pixelRatio = 1;
        const Look* look = nullptr;
        QImage image{};
    };
    std::deque<Kept> kept_; ///< the newest last
    Kept wanted_;
    app::Background<QImage> work_{app::paintingThreads()};
};

} // namespace ui
