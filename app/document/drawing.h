// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

#include <QObject>

#include <mutex>

namespace app {

/// What has changed, so that listeners can splice instead of starting anew.
struct Change {
    enum class Kind : std::uint8_t { Everything, Shapes, Window, Layers, Page };
    Kind kind = Kind::Everything;
    std::size_t first = 0, removed = 0, added = 0; ///< Shapes: from `first` on, old ones replaced
};

/// The drawing that is being edited. Only undo commands (app/commands) and `load` write to it.
class Drawing : public QObject {
    Q_OBJECT

public:
    explicit Drawing(Sheet sheet = {}, QObject* parent = nullptr);

    const Sheet& sheet() const { return sheet_; }
    /// Held while the drawing is being changed. Another thread holds it to read sheet().
    std::mutex& lock() const { return lock_; }

    /// Another drawing altogether (New, Open).
    void load(Sheet sheet);

    /// Replaces the shapes [first, first + count) by `shapes` and returns the old ones. The caller
    /// keeps `layer` ascending.
    std::vector<Shape> splice(std::size_t first, std::size_t count, std::vector<Shape> shapes);
    void setWindow(const clipping::Window& window);
    void setLayers(std::vector<Layer> layers);
    void setPage(const Page& page);

    /// Where a new shape of that layer goes: after the layer's last.
    std::size_t endOfLayer(std::uint32_t layer) const;

signals:
    void changed(const app::Change& change);

private:
    Sheet sheet_;
    mutable std::mutex lock_;
};

} // namespace app
