// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/bars/option_bar.h"
#include "ui/bars/status_bar.h"
#include "ui/bars/tool_bar.h"
#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/microscope/microscope_page.h"
#include "ui/properties/stroke_row.h"
#include "ui/tiles/tiles_page.h"
#include "ui/tools/tool.h"
#include "ui/widgets/message_strip.h"
#include "ui/widgets/sheet.h"
#include "ui/window/centre.h"
#include "ui/window/drawing_tabs.h"
#include "ui/window/drawings.h"
#include "ui/window/modes.h"
#include "ui/window/panel_layout.h"
#include "ui/window/workspace_panes.h"
#include "ui/window/workspace_tabs.h"

#include <QApplication>
#include <QMenuBar>
#include <QSettings>

#include <algorithm>

namespace ui {

namespace {

constexpr QSize smallest(1024, 640), usualSize(1280, 800);

} // namespace

MainWindow::MainWindow(Backend backend, QWidget* parent)
    : QMainWindow(parent), theme_(savedTheme()), canvas_(new Canvas(session_, backend)),
      strip_(new MessageStrip), placing_(std::make_unique<app::ImagePlacing>(session_)),
      files_(std::make_unique<Files>(session_, *this, std::make_unique<Questions>(*this, strip_)))
{
    if (parent)
        setWindowFlags(Qt::Widget); // one of several in the program's window
    setMinimumSize(smallest);
    setAcceptDrops(true);
    setWindowIcon(icon("clearcut"));
    addCentre();
    addPanels();
    addBars();
    addModes();
    connectFiles();
    connectSession();
    workspacePanes_ = new WorkspacePanes(session_, *canvas_, this);
    connect(workspacePanes_, &WorkspacePanes::changed, this, &MainWindow::refreshActions);
    rememberSnapping();
    rememberCapsule();
    rememberGrid();
    rememberPaper();
    limitHistory();
    if (isWindow())
        restorePlace(*this, placeKey(), usualSize, minimumSize());
    panelLayout_->restore();
    followWorkspace();
    showTitle();
    canvas_->setFocus();
}

MainWindow::~MainWindow()
{
    // All widgets use the session, which is destroyed with the members, so they are destroyed
    // first. Without the disconnects the session's last signals would reach deleted widgets.
    const QSignalBlocker quiet(this);
    for (const QObject* source :
         {static_cast<QObject*>(&session_), static_cast<QObject*>(&session_.document),
          static_cast<QObject*>(&session_.history)})
        disconnect(source, nullptr, this, nullptr);
    hide();
    // A window that is hidden finishes the field in hand, for which it must be whole still.
    for (QWidget* child : findChildren<QWidget*>())
        if (child->isWindow())
            child->hide();
    qDeleteAll(findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
}

void MainWindow::addCentre()
{
    canvas_->setAccessibleName(Text::tr("Drawing"));
    centre_ = new Centre(*strip_, *canvas_);
    setCentralWidget(centre_);
    canvas_->setCarrier([this](const Canvas::Carried& carried) {
        return drawings_ && drawings_->carry(*this, carried);
    });
    status_ = new StatusBar(session_, *canvas_);
    setStatusBar(status_);
}

void MainWindow::addBars()
{
    drawingTabs_ = new DrawingTabs;
    addToolBar(Qt::TopToolBarArea, drawingTabs_);
    addToolBarBreak(Qt::TopToolBarArea);
    optionBar_ = new OptionBar(session_, *canvas_);
    addToolBar(Qt::TopToolBarArea, optionBar_);
    connect(optionBar_, &OptionBar::refused, strip_, &MessageStrip::refuse);
    connect(optionBar_, &OptionBar::taken, strip_, &MessageStrip::withdrawRefusal);
    auto* style = new StrokeRow(session_, *canvas_, StrokeRow::Frame::Plain);
    canvas_->setStyleControls(*style, [style] { style->showParts(); });
    toolBar_ = new ToolBar(session_, *canvas_);
    addToolBar(Qt::LeftToolBarArea, toolBar_);
    auto* tabs = new WorkspaceTabs(*panelLayout_);
    connect(tabs, &QTabBar::tabBarClicked, this, &MainWindow::closeSheet); // panels are wanted
    menuBar()->setCornerWidget(tabs);
    connect(panelLayout_.get(), &PanelLayout::workspaceChanged, this, &MainWindow::followWorkspace);
}

void MainWindow::followWorkspace()
{
    session_.worksInDraw = workspace().draws;
    centre_->allowNote(!workspace().draws); // it is about cutting
    workspacePanes_->choose(workspace());
    optionBar_->offerPanes(workspace().compares);
    status_->showHint({});
    refreshActions();
}

void MainWindow::addModes()
{
    modes_ = std::make_unique<Modes>(
        session_, drawnLine_, *canvas_,
        Modes::Parts{*this, sheets_, *centre_, *panelLayout_, {optionBar_, toolBar_}, *status_});
    connect(modes_.get(), &Modes::changed, this, &MainWindow::refreshActions);
    connect(&modes_->microscope(), &MicroscopeMode::lessonExportWanted, this,
            &MainWindow::lessonExportWanted);
    connect(&modes_->microscope(), &MicroscopeMode::made, this, &MainWindow::connectMicroscope);
    connect(&modes_->tiles(), &TilesMode::made, this, &MainWindow::connectTiles);
    connect(modes_.get(), &Modes::changed, this, &MainWindow::showTilesInStatus);
}

void MainWindow::setQuestions(std::unique_ptr<Questions> questions)
{
    files_->setQuestions(std::move(questions));
}

void MainWindow::setTheme(Theme theme)
{
    theme_ = theme;
    QSettings().setValue("theme", int(theme));
    applyTheme(*qApp, theme);
    refreshActions();
}

void MainWindow::takeOver(const MainWindow& before)
{
    canvas_->setTool(before.canvas().tool());
    canvas_->setSnapping(before.canvas().snapping());
    canvas_->switchSnapping(before.canvas().snaps());
    canvas_->setCapsuleHome(before.canvas().capsuleHome());
    session_.changeDisplay([&before](app::Display& display) {
        display.grid = before.session().display().grid;
        display.darkPaper = before.session().display().darkPaper;
    });
    session_.history.setLimit(before.session().history.limit());
    if (&before.workspace() != &workspace())
        choose(before.workspace());
    theme_ = before.theme_;
    refreshActions();
}

void MainWindow::comeToFront()
{
    if (drawings_)
        drawings_->showWindow(*this);
    window()->raise();
    window()->activateWindow();
}

void MainWindow::saveLayout() { panelLayout_->save(); }

void MainWindow::showStart()
{
    if (const auto samples = app::samples(); !samples.empty())
        files_->openSample(samples.front());
    canvas_->setTool("window");
    panelLayout_->showStart();
    if (!QSettings().value("windowDragged").toBool()) {
        auto* note = new WindowNote(session_);
        connect(note, &WindowNote::learnt, this,
                [] { QSettings().setValue("windowDragged", true); });
        centre_->addNote(*note);
        centre_->allowNote(!workspace().draws);
    }
}

TilesPage* MainWindow::tilesPage() const { return centre_->tiles(); }

MicroscopePage* MainWindow::microscopePage() const { return centre_->microscope(); }

QList<QAction*> MainWindow::toolActions() const { return toolBar_->tools(); }

QAction* MainWindow::toolAction(std::string_view key) const
{
    const auto row = std::ranges::find(tools(), key, &ToolInfo::key);
    return toolActions().at(row - tools().begin());
}

QList<QAction*> MainWindow::panelToggles() const { return panelLayout_->toggles(); }

void MainWindow::raisePanel(const QString& key) { panelLayout_->raise(key); }

void MainWindow::togglePanel(const QString& key) { panelLayout_->toggle(key); }

bool MainWindow::showsPanel(const QString& key) const { return panelLayout_->shows(key); }

void MainWindow::resetLayout() { panelLayout_->reset(); }

const Workspace& MainWindow::workspace() const { return panelLayout_->workspace(); }

void MainWindow::choose(const Workspace& workspace)
{
    closeSheet();
    panelLayout_->choose(workspace);
}

Sheet* MainWindow::sheet() const { return modes_->sheets().sheet(); }

bool MainWindow::isPreviewing() const { return sheet() && sheet()->preview(); }

void MainWindow::showSheet(Sheet* sheet) { modes_->sheets().show(sheet); }

void MainWindow::closeSheet() { modes_->sheets().close(); }

void MainWindow::showLessons() { modes_->microscope().showLessons(); }

void MainWindow::openLessons(const QStringList& paths) { modes_->microscope().openLessons(paths); }

bool MainWindow::showsLessons() const { return modes_->microscope().showsLessons(); }

void MainWindow::togglePresenting() { modes_->togglePresenting(); }

} // namespace ui

#include "moc_main_window.cpp"
