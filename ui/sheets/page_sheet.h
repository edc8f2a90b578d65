// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/page_steps.h"
#include "ui/widgets/sheet.h"

#include <QPointer>
#include <QTimer>

#include <vector>

namespace ui {

class Canvas;
class LookLabel;
class MainWindow;
class PageFrame;
class PageSection;

/// The page of the drawing: paper, scale, margins. Everything shows at once on the canvas; all
/// changes are one step to undo. Esc leaves the page as it was.
class PageSheet : public Sheet {
    Q_OBJECT

public:
    explicit PageSheet(MainWindow& window);
    ~PageSheet() override;

    void leave() override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addFootButtons();
    void addCheck();
    void follow(const app::DocumentChange& change);
    void check();
    void keep();

    app::Session& session_;
    Canvas& canvas_;
    app::PageEditing editing_;
    std::vector<PageSection*> sections_;
    LookLabel* check_;
    QPointer<PageFrame> frame_; ///< over the drawing, which may be gone first
    QTimer soon_;               ///< the check, which may look at every line
    app::Page shown_;
};

} // namespace ui
