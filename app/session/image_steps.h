// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/session/session.h"

#include <QMimeData>

#include <deque>
#include <functional>

namespace app {

// Undoable steps on the images below layers.

/// Lays an image below all of the drawing, on a locked layer of its own, as large as fits on the
/// page. If there is no room for it, Session::refused says so.
void placeImage(Session& session, const std::shared_ptr<const ImageFile>& file,
                const QString& name);
/// Takes the image from a layer, which stays.
void removeImage(Session& session, ContainerId layer);

/// Whether a file is called like an image, and whether another program offers one.
bool isNamedLikeImage(const QString& path);
bool offersImage(const QMimeData& data);

/// Reads images on another thread, and then places them, one at a time. What is not an image is
/// told by Session::refused.
class ImagePlacing : public QObject {
    Q_OBJECT

public:
    explicit ImagePlacing(Session& session);

    void place(const QString& path);
    void place(const QMimeData& data); ///< which offers one

private:
    struct Read {
        std::shared_ptr<const ImageFile> file{};
        QString fault{};
    };
    using Bytes = std::function<QByteArray()>;
    static Read read(const Bytes& bytes);
    struct Waiting {
        Bytes bytes;
        QString name;
    };
    void add(Bytes bytes, const QString& name);
    void start();

    Session& session_;
    std::deque<Waiting> waiting_; ///< the first one is being read
    Background<Read> reading_;
};

} // namespace app
