// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "app/session/image_steps.h"
#include "app/session/live_sheets.h"
#include "ui/canvas/canvas.h"
#include "ui/dialogs/questions.h"
#include "ui/look/look.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/panels.h"

#include <QMainWindow>

namespace ui {

class AlgorithmPanel;
class Centre;
class CostMapPanel;
class DifferencePanel;
class DrawingTabs;
class Drawings;
class ExactnessPanel;
class Files;
class MicroscopePage;
class Modes;
class OptionBar;
class PanelLayout;
class Sheet;
class StatusBar;
class TilesPage;
class ToolBar;
class WorkspacePanes;
struct Workspace;

/// A property of actions: whether they work while isPreviewing().
inline constexpr const char* worksInPreview = "works-in-preview";

/// The editor's window around one session: bars, canvas and panels. It only assembles them. The
/// room menus/ adds its commands (`addMenus`) and opens the other windows that it asks for.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    static constexpr int messageMilliseconds = 5000; ///< in the status bar

    explicit MainWindow(Backend backend = Backend::Automatic, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions);

    app::Session& session() { return session_; }
    const app::Session& session() const { return session_; }
    Canvas& canvas() { return *canvas_; }
    const Canvas& canvas() const { return *canvas_; }
    Files& files() { return *files_; }
    app::ImagePlacing& placing() { return *placing_; }
    WindowPanel& windowPanel() { return *panels_.window; }
    AlgorithmPanel& algorithmPanel() { return *panels_.algorithm; }
    ComparePanel& comparePanel() { return *panels_.compare; }
    DifferencePanel& differencePanel() { return *panels_.difference; }
    CostMapPanel& costMapPanel() { return *panels_.costMap; }
    ExactnessPanel& exactnessPanel() { return *panels_.exactness; }
    OptionBar& optionBar() { return *optionBar_; }
    StatusBar& status() { return *status_; }
    app::DrawnLine& drawnLine() { return drawnLine_; }
    /// The other drawings of the program; null: this window is alone.
    Drawings* drawings() const { return drawings_; }
    void setDrawings(Drawings* drawings) { drawings_ = drawings; }
    DrawingTabs& drawingTabs() { return *drawingTabs_; } ///< which they fill
    /// Takes over what is the program's, not the drawing's: tool, workspace, theme,
    /// snapping, grid, and where the capsule is.
    void takeOver(const MainWindow& before);
    void saveLayout();  ///< of the panels, to the settings
    void comeToFront(); ///< this drawing, and the program's window

    /// The microscope's page; null until the microscope is first opened.
    MicroscopePage* microscopePage() const;
    /// The sheets of the drawing, and their page; null until it is first opened.
    app::LiveSheets& sheets() { return sheets_; }
    const app::LiveSheets& sheets() const { return sheets_; }
    TilesPage* tilesPage() const;

    /// Shows the first sample, its clip window ready to drag, and the start panel in front.
    void showStart();
    void tell(const Message& message) { strip_->tell(message); }
    /// Warns in the status bar until it is called with an empty text, and at first in the strip.
    void warn(const QString& sentence);
    QString message() const { return strip_->sentence(); }

    QList<QAction*> toolActions() const;
    QAction* toolAction(std::string_view key) const; ///< of one of ui::tools()
    QList<QAction*> panelToggles() const;
    void raisePanel(const QString& key);
    void togglePanel(const QString& key);
    bool showsPanel(const QString& key) const; ///< possibly behind another tab
    void resetLayout();
    const Workspace& workspace() const;
    void choose(const Workspace& workspace);

    Sheet* sheet() const; ///< the side sheet in place of the panels; null: none
    /// Whether the preview of an export is in place of the drawing. Keys of commands that are not
    /// marked `worksInPreview` then do nothing.
    bool isPreviewing() const;
    /// Shows a side sheet, which belongs to the window from now on, instead of the one before.
    void showSheet(Sheet* sheet);
    void closeSheet();

    /// Shows the lessons beside the microscope.
    void showLessons();
    bool showsLessons() const;
    /// Opens lesson files and folders of them, beside the program's own lessons.
    void openLessons(const QStringList& paths);

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
    void lessonExportWanted();                                    ///< of the one in progress

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;

private:
    bool isKeyOfPreview(const QKeyEvent& event) const;
    void takeDropped(const QMimeData& data, const QPointF& position);
    void addCentre();
    void addBars();
    void addModes();
    void followWorkspace();
    void addPanels();
    void connectPanels();
    void connectLayout();
    void connectFiles();
    void connectMicroscope(MicroscopePage* page);
    void connectTiles(TilesPage* page);
    void showTilesInStatus();
    void connectSession();
    /// Whether the window may be closed: not asked; the question is open; the answer waits for a
    /// file; yes.
    enum class Closing : std::uint8_t { No, Asking, Waiting, Agreed };
    static QString placeKey() { return QStringLiteral("geometry"); } ///< in the settings
    void showTitle();
    void rememberSnapping();
    void rememberCapsule();
    void rememberGrid();
    void rememberPaper();
    void limitHistory();

    app::Session session_;
    app::DrawnLine drawnLine_{session_};
    app::LiveSheets sheets_{session_};
    Theme theme_;
    Canvas* canvas_;
    MessageStrip* strip_;
    QString warning_; ///< that the status bar shows
    Centre* centre_ = nullptr;
    ToolBar* toolBar_ = nullptr;
    DrawingTabs* drawingTabs_ = nullptr;
    Drawings* drawings_ = nullptr;
    OptionBar* optionBar_ = nullptr;
    StatusBar* status_ = nullptr;
    std::unique_ptr<app::ImagePlacing> placing_;
    std::unique_ptr<Files> files_;
    Panels panels_{session_, *canvas_};
    std::unique_ptr<PanelLayout> panelLayout_;
    WorkspacePanes* workspacePanes_ = nullptr;
    std::unique_ptr<Modes> modes_;
    Closing closing_ = Closing::No;
};

} // namespace ui
