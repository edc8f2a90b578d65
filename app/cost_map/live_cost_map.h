// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/cost_map/cost_map.h"

#include <QObject>

namespace app {

/// A cost map that is recomputed in the background when its plan changes. A coarse map appears as
/// soon as possible, at once if it takes at most 8 ms; a fine one follows.
class LiveCostMap : public QObject {
    Q_OBJECT

public:
    static constexpr int coarseness = 3; ///< a coarse cell is this many fine cells wide and high

    explicit LiveCostMap(QObject* parent = nullptr);

    /// An empty optional hides the map and stops the computation.
    void ask(const std::optional<CostPlan>& plan);
    const std::optional<CostPlan>& asked() const { return asked_; }

    /// The best map so far: perhaps coarse, or of the previous plan. Null if there is none.
    const CostMap* map() const { return map_ ? &*map_ : nullptr; }
    bool upToDate() const; ///< the map is that of the plan, fine and whole
    void finish();         ///< finishes the map before it returns

signals:
    void changed();

private:
    void compute(const CostPlan& plan);
    void show(CostMap map);

    std::optional<CostPlan> asked_;
    std::optional<CostMap> map_;
    Background<CostMap> background_; ///< of the plan, coarse or fine, until the map is up to date
};

} // namespace app
