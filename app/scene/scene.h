// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/edited_document.h"
#include "app/scene/block_scene.h"

#include <QObject>

namespace app {

/// The visible lines of the edited document, kept up to date by its change signal, and the result
/// of clipping them. Curves are flattened to 0.05 mm on paper.
class Scene : public QObject {
    Q_OBJECT

public:
    explicit Scene(const EditedDocument& document, QObject* parent = nullptr);

    const SceneLines& lines() const { return blocks_.lines(); }

    /// Clips every line; see `SceneClipping`. The variant must not be a known misprint. The frame
    /// is valid until the next call and the next change of the lines.
    SceneFrame clip(const ClipRegion& region, const Variant& variant)
    {
        return blocks_.clip(region, variant);
    }

signals:
    void outdated(); ///< the next frame will look different

private:
    void update();

    const EditedDocument& document_;
    BlockScene blocks_;
};

} // namespace app
