// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/cost_map.h"

#include <QTimer>

namespace app {

/// A cost map that is recomputed while its question changes. A coarse map is there as soon as
/// possible; a fine one follows between events, some milliseconds at a time.
class LiveCostMap : public QObject {
    Q_OBJECT

public:
    static constexpr int coarseness = 3; ///< so many cells at the side of the fine map are one

    explicit LiveCostMap(QObject* parent = nullptr);

    /// No plan: the map is not shown, and nothing is computed.
    void ask(const std::optional<CostPlan>& plan);
    const std::optional<CostPlan>& asked() const { return asked_; }

    /// The best map there is: perhaps coarse, or of what was asked before. Null if there is none.
    const CostMap* map() const { return map_ ? &*map_ : nullptr; }
    bool upToDate() const; ///< what was asked, fine and whole
    void finish();         ///< now, not soon

signals:
    void changed();

private:
    void work();
    void show(CostMap map);

    std::optional<CostPlan> asked_;
    std::optional<CostMap> map_, growing_;
    QTimer work_;
};

} // namespace app
