// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/live_cost_map.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/cost_map_view.h"
#include "ui/widgets/message_strip.h"

#include <QComboBox>
#include <QLabel>

namespace ui {

class VariantBox;
class ToolList;
class Segments;

/// The cost of clipping a line with one fixed end, for every position of the other end around the
/// current clip window: the cost of one algorithm, or which algorithm is cheapest. Computes only
/// while it is visible, and only after the pending frame is shown.
class CostMapPanel : public QWidget {
    Q_OBJECT

public:
    explicit CostMapPanel(const app::Session& session, QWidget* parent = nullptr);

    CostMapView& view() { return *view_; }
    const app::LiveCostMap& live() const { return live_; }
    QString words() const { return words_->text(); } ///< about the point under the pointer

    /// Writes the fine map to `path`; returns a sentence if that fails, else nothing.
    std::optional<QString> exportTo(const QString& path);
    void setQuestions(std::unique_ptr<Questions> questions);

signals:
    void told(const ui::Message& message); ///< whether the file was written
    void entered(); ///< a choice was made in a list: the focus returns to the canvas

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
    QTimer soon_; ///< runs while plan_ is for another clip window than the current one
    VariantBox* algorithm_;
    ToolList* measure_;
    Segments* end_;
    CostMapView* view_;
    QLabel *words_, *notes_;
    std::unique_ptr<Questions> questions_;
};

} // namespace ui
