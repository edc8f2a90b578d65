// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "ui/canvas/canvas.h"
#include "ui/dialogs/questions.h"
#include "ui/look/look.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/panel_layout.h"
#include "ui/window/panels.h"

#include <QMainWindow>
#include <QPointer>

class QStackedWidget;
class QToolBar;

namespace ui {

class AlgorithmPanel;
class CostMapPanel;
class DifferencePanel;
class ExactnessPanel;
class Files;
class MicroscopePage;
class OptionBar;
class StatusBar;
class WindowNote;

/// The editor's window around one session: bars, canvas and panels. It only assembles them. The
/// room menus/ adds its commands (`addMenus`) and opens the other windows that it asks for.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Backend backend = Backend::Automatic, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions);

    app::Session& session() { return session_; }
    const app::Session& session() const { return session_; }
    Canvas& canvas() { return *canvas_; }
    const Canvas& canvas() const { return *canvas_; }
    Files& files() { return *files_; }
    AlgorithmPanel& algorithmPanel() { return *panels_.algorithm; }
    DifferencePanel& differencePanel() { return *panels_.difference; }
    CostMapPanel& costMapPanel() { return *panels_.costMap; }
    ExactnessPanel& exactnessPanel() { return *panels_.exactness; }
    OptionBar& optionBar() { return *optionBar_; }
    StatusBar& status() { return *status_; }
    app::DrawnLine& drawnLine() { return drawnLine_; }
    /// The microscope's page; null until the microscope is first opened.
    MicroscopePage* microscopePage() const { return microscopePage_; }

    /// Shows the first sample, its clip window ready to drag, and the start panel in front.
    void showStart();
    void tell(const Message& message) { strip_->tell(message); }
    QString message() const { return strip_->sentence(); }

    QList<QAction*> toolActions() const { return toolActions_; }
    QList<QAction*> panelToggles() const { return panelLayout_->toggles(); }
    void raisePanel(const QString& key) { panelLayout_->raise(key); }
    void togglePanel(const QString& key) { panelLayout_->toggle(key); }
    bool showsPanel(const QString& key) const { return panelLayout_->shows(key); }
    void resetLayout() { panelLayout_->reset(); }

    /// Shows the lessons beside the microscope.
    void showLessons();
    bool showsLessons() const;

    /// Enters or leaves presentation mode, for a projector: full screen, no panels, wide strokes,
    /// large type.
    void togglePresenting();
    bool isPresenting() const { return session_.display().presenting; }

    Theme theme() const { return theme_; }
    void setTheme(Theme theme);

    void refreshActions() { emit actionsOutdated(); }

signals:
    void actionsOutdated(); ///< which actions are enabled or checked may have changed
    void explanationWanted(const clipping::Algorithm& algorithm); ///< asks for its page
    void experimentWanted();                                      ///< the paper's
    void stepsExportWanted();                                     ///< of the microscope

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;

private:
    void addCentre();
    void addMicroscope();
    void makeMicroscopePage();
    void remakeMicroscopePage();
    void followMicroscope();
    void fitMode();
    void showInCentre();
    void makeBare();
    void endBare();
    void closeLessons();
    void addTools();
    void addBars();
    void addPanels();
    void connectPanels();
    void connectLayout();
    void connectFiles();
    void showTitle();
    void rememberPanes();
    void limitHistory();

    app::Session session_;
    app::DrawnLine drawnLine_{session_};
    Theme theme_;
    Canvas* canvas_;
    QStackedWidget* centre_ = nullptr; ///< the canvas, or the microscope
    MicroscopePage* microscopePage_ = nullptr;
    QPointer<QWidget> focusBefore_;   ///< the focus to restore when the microscope closes
    std::optional<QFont> fontBefore_; ///< the application's font to restore after presenting
    Qt::WindowStates statesBefore_{}; ///< the window's states to restore after presenting
    bool bare_ = false;               ///< the mode hides the panels
    QList<QToolBar*> barsBefore_;     ///< tool bars to show again
    MessageStrip* strip_;
    OptionBar* optionBar_ = nullptr;
    StatusBar* status_ = nullptr;
    std::unique_ptr<Files> files_;
    Panels panels_{session_};
    std::unique_ptr<PanelLayout> panelLayout_;
    QList<QAction*> toolActions_;
    WindowNote* note_ = nullptr;
};

} // namespace ui
