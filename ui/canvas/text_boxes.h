// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/view/view.h"

#include <QObject>
#include <QRectF>

#include <optional>
#include <vector>

namespace ui {

/// Parts of the drawing that may be letters, which labels should not cover. The result is kept from
/// frame to frame until the lines or the view change.
class TextBoxes : public QObject {
    Q_OBJECT

public:
    explicit TextBoxes(const app::Scene& scene, QObject* parent = nullptr);

    /// Bounding boxes of the letters in a view, in logical pixels; empty for a drawing with too
    /// many lines.
    const std::vector<QRectF>& in(const app::View& view);

private:
    const app::Scene& scene_;
    std::optional<app::View> view_; ///< the view of boxes_; empty: boxes_ must be computed
    std::vector<QRectF> boxes_;
};

} // namespace ui
