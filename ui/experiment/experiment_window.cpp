// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment_window.h"

#include "app/base/numbers.h"
#include "app/report/process_runs.h"
#include "app/settings/remembered.h"
#include "ui/experiment/choice_panel.h"
#include "ui/experiment/exports.h"
#include "ui/experiment/results.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/progress_row.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QVBoxLayout>

namespace ui {

namespace {

const QString durationRatioKey = QStringLiteral("experimentPace");
constexpr QSize usual(1180, 780), smallest(640, 360);
constexpr double leastTelling = 1; // seconds; shorter runs consist mostly of overhead
constexpr double leastDurationRatio = 0.02, mostDurationRatio = 50;
constexpr int leftWidth = 300;

QLabel* aside(const QString& text)
{
    auto* label = new QLabel(text);
    label->setFont(captionFont(label->font()));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

/// The page shown until there are results.
QWidget* invitation()
{
    auto* text = new QLabel(Text::tr(
        "<p><b>Which algorithm clips lines fastest?</b></p>"
        "<p>In 2019 D. Matthes and V. Drakopoulos clipped one and ten million random lines at a "
        "window with seven algorithms: six well-known ones and their own. Each ran ten times, and "
        "their own was the fastest.</p>"
        "<p><b>Run</b> repeats this on your machine and reports the result. <b>Quick run</b> uses "
        "fewer lines and takes a few seconds. At the left you can choose other lines, also those "
        "of your drawing.</p>"));
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setMaximumWidth(460);
    auto* page = new QWidget;
    auto* row = new QHBoxLayout(page); // no alignment: the text's height follows from its width
    row->addStretch(1);
    row->addWidget(text, 1000);
    row->addStretch(1);
    return page;
}

/// The error is empty if it was stopped.
app::Result<app::Study> measured(const app::Plan& plan, const QString& program,
                                 const app::Follower& follower)
{
    if (plan.trials.front().options.inProcesses)
        return app::studyInProcesses(plan, program, follower);
    return {app::study(plan, follower), {}};
}

} // namespace

ExperimentWindow::ExperimentWindow(app::Session& session, std::function<QString()> name,
                                   QWidget* parent)
    : QDialog(parent, Qt::Window), session_(session), name_(std::move(name)),
      exports_(new Exports(*this)), choice_(new ChoicePanel([this] {
          return app::drawingSubject(name_(), session_.scene.lines(), session_.now());
      })),
      run_(plainButton(Text::tr("&Run"), "play")), quick_(plainButton(Text::tr("&Quick run"))),
      copy_(plainButton(Text::tr("Co&py table"))), export_(new QToolButton), effort_(aside({})),
      progress_(new ProgressRow), strip_(new MessageStrip), stack_(new QStackedWidget),
      results_(new Results({copy_, export_})), program_(QCoreApplication::applicationFilePath())
{
    durationRatio_ =
        app::rememberedNumber(durationRatioKey, leastDurationRatio, mostDurationRatio, 1.0);
    layOut();
    addTools();
    connect(choice_, &ChoicePanel::changed, this, &ExperimentWindow::showEffort);
    connect(run_, &QPushButton::clicked, this, [this] { run(choice_->choice()); });
    connect(quick_, &QPushButton::clicked, this, [this] { run(app::quick(choice_->choice())); });
    connect(progress_, &ProgressRow::cancelWanted, this, &ExperimentWindow::cancel);
    connect(&session_.scene, &app::Scene::outdated, this, &ExperimentWindow::followDrawing);
    connect(&session_, &app::Session::displayChanged, this, &ExperimentWindow::showEffort);
    showEffort();
}

void ExperimentWindow::layOut()
{
    setObjectName(QStringLiteral("experiment"));
    setWindowTitle(Text::tr("Reproduce the paper"));
    restorePlace(*this, QStringLiteral("experimentGeometry"), usual, smallest);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(left());
    middle->addWidget(rule(Qt::Vertical));
    middle->addWidget(right(), 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(middle, 1);
    column->addWidget(rule(Qt::Horizontal));
    column->addWidget(progress_);
}

ExperimentWindow::~ExperimentWindow() = default;

void ExperimentWindow::setQuestions(std::unique_ptr<Questions> questions)
{
    exports_->setQuestions(std::move(questions));
}

const app::Study* ExperimentWindow::study() const { return results_->study().get(); }

QWidget* ExperimentWindow::left()
{
    auto* fields = new QWidget;
    auto* column = new QVBoxLayout(fields);
    column->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                               space::dockMargin);
    column->addWidget(choice_);
    column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(fields);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // its fields have it
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(run_, 1);
    buttons->addWidget(quick_, 1);
    auto* foot = new QVBoxLayout;
    foot->setContentsMargins(space::betweenGroups, space::labelToField, space::betweenGroups,
                             space::dockMargin);
    foot->setSpacing(space::labelToField);
    effort_->setMinimumHeight(2 * effort_->fontMetrics().lineSpacing());
    effort_->setAlignment(Qt::AlignTop);
    foot->addWidget(effort_);
    foot->addLayout(buttons);
    auto* whole = new QWidget;
    whole->setFixedWidth(leftWidth);
    auto* all = new QVBoxLayout(whole);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(scroll, 1);
    all->addLayout(foot);
    return whole;
}

QWidget* ExperimentWindow::right()
{
    stack_->addWidget(invitation());
    stack_->addWidget(results_);
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(stack_, 1);
    column->addWidget(strip_); // at the bottom, so that a message moves nothing
    return whole;
}

void ExperimentWindow::addTools()
{
    QMenu* menu = exports_->menu([this] {
        return Exports::Shown{results_->study(), results_->shownTable(), results_->shownChart()};
    });
    connect(export_, &QToolButton::clicked, menu,
            [this, menu] { menu->popup(export_->mapToGlobal(export_->rect().bottomLeft())); });
    export_->setText(Text::tr("&Export ▾"));
    export_->setIcon(icon("export"));
    export_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    export_->setFixedHeight(space::fieldHeight);
    export_->setProperty("framed", true);
    copy_->setFocusPolicy(Qt::TabFocus); // a click leaves the focus in the table
    copy_->setToolTip(Text::tr("Copy the table that you clicked last, or else the first one, for a "
                               "spreadsheet (separated by tabs)."));
    connect(copy_, &QPushButton::clicked, this, [this] {
        results_->copyTable();
        progress_->tell(Text::tr("The table is on the clipboard."));
    });
    connect(results_, &Results::tabChanged, this,
            [this] { copy_->setEnabled(results_->shownTable() != nullptr); });
    connect(results_, &Results::exportWanted, exports_, &Exports::exportChart);
    connect(exports_, &Exports::told, strip_, &MessageStrip::tell);
}

void ExperimentWindow::run(app::Choice choice)
{
    if (choice.target)
        choice.target = app::bestDrawTarget(); // queried here, in the window's thread
    auto plan = app::planOf(choice);
    if (!plan || measuring_.active())
        return showEffort();
    results_->markOld();
    progress_->start();
    taken_.start();
    thought_ = app::roughSeconds(*plan.value);
    measuring_.start(
        [plan = std::move(*plan.value), program = program_](const app::Follower& follower) {
            return measured(plan, program, follower);
        },
        [this](app::Result<app::Study>&& study) { finish(std::move(study)); },
        [this](const app::Progress& progress) { showProgress(progress); });
    showState();
}

void ExperimentWindow::cancel()
{
    measuring_.cancel();
    showState();
    progress_->tell(Text::tr("Cancelled. Nothing was changed."));
}

void ExperimentWindow::finish(app::Result<app::Study> study)
{
    if (!study) {
        strip_->tell({.sentence = study.error});
        progress_->tell({});
        return showState();
    }
    const double taken = double(taken_.elapsed()) / 1000;
    if (thought_ >= leastTelling) {
        durationRatio_ = std::clamp(taken / thought_, leastDurationRatio, mostDurationRatio);
        QSettings().setValue(durationRatioKey, durationRatio_);
    }
    results_->show(std::make_shared<const app::Study>(std::move(*study.value)));
    stack_->setCurrentWidget(results_);
    showEffort();
    progress_->tell(Text::tr("Done in %1.").arg(app::durationText(taken)));
}

void ExperimentWindow::showProgress(const app::Progress& progress)
{
    progress_->showProgress(progress.share,
                            Text::tr("%1. Other work on this computer distorts the times.")
                                .arg(app::progressText(progress)));
}

/// Shows how long the run will take, or why it is impossible.
void ExperimentWindow::showEffort()
{
    const app::Choice choice = choice_->choice();
    const auto plan = app::planOf(choice);
    effort_->setText(plan ? (app::effortText(*plan.value, durationRatio_) + u' '
                             + app::quickEffortText(choice, durationRatio_) + u' '
                             + app::leftOutText(choice))
                                .trimmed()
                          : plan.error);
    showState();
}

void ExperimentWindow::showState()
{
    const bool active = measuring_.active();
    const bool can = app::planOf(choice_->choice()).value.has_value();
    choice_->setEnabled(!active);
    run_->setEnabled(can && !active);
    quick_->setEnabled(can && !active);
    progress_->setWorking(active);
}

/// A hidden window ignores changes and updates itself when shown.
void ExperimentWindow::followDrawing()
{
    if (isVisible())
        choice_->followDrawing(session_.scene.lines().size());
}

void ExperimentWindow::showEvent(QShowEvent* event)
{
    if (!event->spontaneous())
        fitToScreens(*this);
    QDialog::showEvent(event);
    choice_->followDrawing(session_.scene.lines().size());
}

void ExperimentWindow::hideEvent(QHideEvent* event)
{
    rememberPlace(*this, QStringLiteral("experimentGeometry"));
    if (measuring_.active() && !event->spontaneous())
        cancel();
    QDialog::hideEvent(event);
}

/// Esc first cancels a running measurement.
void ExperimentWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && measuring_.active())
        return cancel();
    QDialog::keyPressEvent(event);
}

} // namespace ui

#include "moc_experiment_window.cpp"
