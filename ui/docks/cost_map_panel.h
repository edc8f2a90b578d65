// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/live_cost_map.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/cost_map_view.h"

#include <QComboBox>
#include <QLabel>

namespace ui {

class VariantBox;
class ToolList;
class Segments;

/// What a line costs that has one end at a fixed point, for every place of the other end, around
/// the clip window as it is now: of one algorithm, or which one is cheapest. Computes only while it
/// is seen, and not before the frame that is due.
class CostMapPanel : public QWidget {
    Q_OBJECT

public:
    explicit CostMapPanel(const app::Session& session, QWidget* parent = nullptr);

    CostMapView& view() { return *view_; }
    const app::LiveCostMap& live() const { return live_; }
    QString words() const { return words_->text(); } ///< of what is under the pointer

    /// Writes the fine map; nothing, or the sentence why it could not be done.
    std::optional<QString> exportTo(const QString& path);
    void setQuestions(std::unique_ptr<Questions> questions);

signals:
    void told(const QString& sentence); ///< what became of a file

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addChoosers();
    void addMap();
    void choose();
    void followWindow();
    void ask();
    void follow();
    void point(const std::optional<app::Point>& at);
    void exportAs(const QString& key);

    const app::Session& session_;
    app::LiveCostMap live_;
    app::CostPlan plan_;
    QTimer soon_; ///< runs while the clip window is elsewhere than that of the plan
    VariantBox* algorithm_;
    ToolList* measure_;
    Segments* end_;
    CostMapView* view_;
    QLabel *words_, *notes_;
    std::unique_ptr<Questions> questions_;
};

} // namespace ui
