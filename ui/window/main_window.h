// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "ui/canvas/canvas.h"
#include "ui/dialogs/questions.h"
#include "ui/look/look.h"
#include "ui/widgets/message_strip.h"

#include <QMainWindow>
#include <QPointer>

#include <vector>

class QDockWidget;
class QStackedWidget;
class QToolBar;

namespace ui {

class AlgorithmPanel;
class CostMapPanel;
class DifferencePanel;
class Dock;
class ExactnessPanel;
class Files;
class MicroscopePage;
class OptionBar;
class StartPanel;
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
    AlgorithmPanel& algorithmPanel() { return *algorithmPanel_; }
    DifferencePanel& differencePanel() { return *differencePanel_; }
    CostMapPanel& costMapPanel() { return *costMapPanel_; }
    ExactnessPanel& exactnessPanel() { return *exactnessPanel_; }
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
    QList<QAction*> panelToggles() const;
    void raisePanel(const QString& key);
    void togglePanel(const QString& key);
    bool showsPanel(const QString& key) const; ///< possibly behind another tab
    void resetLayout();

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
    static constexpr int layoutVersion = 1; ///< version of saveState()'s data
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
    void bringPanelsBack();
    void addTools();
    void addPanels();
    void place(Dock& dock);
    void connectStart(StartPanel& start);
    void addWide();
    void follow(Dock& wide);
    void makeRoomForLine();
    void addBars();
    void connectFiles();
    void showTitle();
    void rememberPanes();
    void limitHistory();
    void arrange();
    enum class Arrangement : std::uint8_t { Stacked, Tabs, StartInFront };
    void arrangeAs(Arrangement arrangement);
    Arrangement fittingArrangement() const;
    int lowerTabs() const;
    void fitStack();
    void shareHeight();
    void shareHeightWithWide();
    int columnWidth() const;
    void refreshDockTitles();
    void leaveStart();
    void saveLayout();
    void restoreLayout();

    app::Session session_;
    app::DrawnLine drawnLine_{session_};
    Theme theme_;
    Canvas* canvas_;
    QStackedWidget* centre_ = nullptr; ///< the canvas, or the microscope
    MicroscopePage* microscopePage_ = nullptr;
    /// Of docks and bars, while the microscope or a presentation hides them.
    QByteArray layoutBefore_;
    QPointer<QWidget> focusBefore_;   ///< the focus to restore when the microscope closes
    std::optional<QFont> fontBefore_; ///< the application's font to restore after presenting
    Qt::WindowStates statesBefore_{}; ///< the window's states to restore after presenting
    /// A panel that is hidden while the microscope is open or while presenting.
    struct HiddenDock {
        QDockWidget* dock;
        QSize size;   ///< of its tab group
        bool inFront; ///< whether it is the current tab of its group
    };
    std::vector<HiddenDock> hiddenDocks_;
    QList<QToolBar*> barsBefore_; ///< tool bars to show again
    MessageStrip* strip_;
    OptionBar* optionBar_ = nullptr;
    StatusBar* status_ = nullptr;
    AlgorithmPanel* algorithmPanel_ = nullptr;
    DifferencePanel* differencePanel_ = nullptr;
    CostMapPanel* costMapPanel_ = nullptr;
    ExactnessPanel* exactnessPanel_ = nullptr;
    std::unique_ptr<Files> files_;
    QList<Dock*> docks_;    ///< Start first, the others in stacking order
    QList<Dock*> wide_;     ///< the comparison panels: above the others, in a wider column
    QList<Dock*> openWide_; ///< the visible ones of wide_
    QList<QAction*> toolActions_;
    WindowNote* note_ = nullptr;
    Arrangement arrangement_ = Arrangement::Stacked;
    int lowerTabs_ = 0;       ///< how many of the stacked panels share the lowest place as tabs
    bool arranging_ = false;  ///< docks move by program, not by the person
    bool ownLayout_ = false;  ///< the person moved docks: never rearrange them
    bool inspecting_ = false; ///< the inspector shows a line
    bool starting_ = false;   ///< the start panel is in front
};

} // namespace ui
