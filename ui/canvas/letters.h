// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/view/view.h"

#include <QObject>
#include <QRectF>

#include <optional>
#include <vector>

namespace ui {

/// What of the drawing may be letters, which labels should not hide: kept from frame to frame,
/// until the lines or the view change.
class Letters : public QObject {
    Q_OBJECT

public:
    explicit Letters(const app::Scene& scene, QObject* parent = nullptr);

    /// Their boxes in a view, in its logical pixels; none of a drawing with too many lines.
    const std::vector<QRectF>& in(const app::View& view);

private:
    const app::Scene& scene_;
    std::optional<app::View> view_; ///< nothing: to be found
    std::vector<QRectF> boxes_;
};

} // namespace ui
