// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tiles/tiles_view.h"

namespace ui {

class SheetsSection;
class TilesBar;
class TilesSheet;

/// A large drawing on several sheets: the sheets, and the side sheet with what they are like and
/// how they are exported. Esc returns to the drawing.
class TilesPage : public QWidget {
    Q_OBJECT

public:
    TilesPage(app::Session& session, app::LiveSheets& sheets, QWidget* parent = nullptr);

    TilesView& view() { return *view_; }
    TilesView& overview() { return *overview_; }
    SheetsSection& sheetsSection();
    QRect sheetsArea() const { return view_->geometry(); } ///< without the bar and the side sheet

signals:
    void closeWanted();
    void exportWanted();
    void hinted(const QString& hint);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void tellHint();

    app::Session& session_;
    app::LiveSheets& sheets_;
    TilesBar* bar_;
    TilesView *view_, *overview_;
    TilesSheet* sheet_;
};

} // namespace ui
