// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"
#include "app/scene/scene_block_cache.h"
#include "app/scene/scene_lines.h"

#include <QObject>

namespace app {

/// The visible lines of the edited document, kept up to date by its change signal. Curves are
/// flattened to 0.05 mm on paper.
class Scene : public QObject {
    Q_OBJECT

public:
    explicit Scene(const EditedDocument& document, QObject* parent = nullptr);

    const SceneLines& lines() const { return lines_; }

    /// Before a document is loaded: its blocks of lines, which another thread has made by
    /// `blocksFor`, because a large drawing takes some tenths of a second.
    void expect(SceneBlockCache blocks);

signals:
    void outdated(); ///< the next frame will look different

private:
    void update();

    const EditedDocument& document_;
    SceneBlockCache blocks_;
    bool expects_ = false; ///< blocks_ are those of a document to be loaded
    SceneLines lines_;
};

/// The blocks of lines of a document, as a scene makes them.
SceneBlockCache blocksFor(const Document& document);

} // namespace app
