// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "ui/canvas/canvas.h"
#include "ui/dialogs/questions.h"
#include "ui/look.h"
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
class StartPanel;
class StatusBar;
class WindowNote;

/// The editor's window around one session: menus, bars, canvas and panels. It only puts them
/// together; what a command does is in its row (menus/) and in Files.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Backend backend = Backend::Automatic, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// What answers instead of dialogs (tests).
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
    StatusBar& status() { return *status_; }
    app::DrawnLine& drawnLine() { return drawnLine_; }
    /// The microscope's place in the window; made when it is opened first, null before.
    MicroscopePage* microscopePage() const { return microscopePage_; }

    /// The first sample on the canvas, its window ready to drag, and the start panel in front.
    void showStart();
    void tell(const Message& message) { strip_->tell(message); }
    QString message() const { return strip_->sentence(); }

    QList<QAction*> toolActions() const { return toolActions_; }
    QList<QAction*> panelToggles() const;
    void raisePanel(const QString& key);
    void togglePanel(const QString& key);
    bool showsPanel(const QString& key) const; ///< perhaps behind another
    void resetLayout();

    /// The lessons, beside the microscope.
    void showLessons();
    bool showsLessons() const;

    /// For a projector, or back: the whole screen, no panels, wide strokes, large type.
    void togglePresenting();
    bool isPresenting() const { return session_.display().presenting; }

    Theme theme() const { return theme_; }
    void setTheme(Theme theme);

    void refreshActions() { emit actionsOutdated(); }

signals:
    void actionsOutdated(); ///< what can be done, or is on, may have changed

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;

private:
    static constexpr int layoutVersion = 1; ///< of what saveState() writes
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
    void connectFields();
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
    QByteArray layoutBefore_; ///< of docks and bars, while there are none: in the microscope, or
                              ///< presenting
    QPointer<QWidget> focusBefore_;   ///< while the microscope is open
    std::optional<QFont> fontBefore_; ///< of the application, while presenting
    Qt::WindowStates statesBefore_{}; ///< the same
    /// A panel that went to make room for the microscope, or for those who look on.
    struct HiddenDock {
        QDockWidget* dock;
        QSize size;   ///< with its tabs
        bool inFront; ///< of the others in its tabs
    };
    std::vector<HiddenDock> hiddenDocks_;
    QList<QToolBar*> barsBefore_; ///< those that were shown then
    MessageStrip* strip_;
    StatusBar* status_ = nullptr;
    AlgorithmPanel* algorithmPanel_ = nullptr;
    DifferencePanel* differencePanel_ = nullptr;
    CostMapPanel* costMapPanel_ = nullptr;
    ExactnessPanel* exactnessPanel_ = nullptr;
    std::unique_ptr<Files> files_;
    QList<Dock*> docks_;    ///< Start first, then as they are stacked
    QList<Dock*> wide_;     ///< to compare: above the others, in a wider column
    QList<Dock*> openWide_; ///< those that are shown
    QList<QAction*> toolActions_;
    WindowNote* note_ = nullptr;
    Arrangement arrangement_ = Arrangement::Stacked;
    int lowerTabs_ = 0;       ///< of those that are stacked: how many share the lowest place
    bool arranging_ = false;  ///< docks move because we move them
    bool ownLayout_ = false;  ///< the person moved them: never rearranged
    bool inspecting_ = false; ///< a line is in the inspector
    bool starting_ = false;   ///< the start panel is in front
};

} // namespace ui
