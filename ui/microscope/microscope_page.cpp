// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/microscope_page.h"

#include "app/comparison/differences_at.h"
#include "app/session/digits.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/microscope/answer_cover.h"
#include "ui/microscope/answer_discs.h"
#include "ui/microscope/code_view.h"
#include "ui/microscope/microscope_bar.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/operations_view.h"
#include "ui/microscope/overview.h"
#include "ui/microscope/place_mark.h"
#include "ui/microscope/variable_table.h"
#include "ui/microscope/variables_panel.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/link_button.h"

#include <QApplication>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int rightWidth = 428, narrowRight = 300, wide = 1200; // pixels
constexpr int lessonRight = 344;                                // beside a lesson
constexpr int lessonWidth = 480, narrowLesson = 380;
constexpr double usualType = 13, widestLesson = 0.45; // pixels; of the page
constexpr int leastMiddle = 320;

QWidget* underHeading(Heading* heading, QWidget* body)
{
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(heading);
    column->addWidget(body, 1);
    return both;
}

/// Shows or hides a part of the page, which may itself be hidden.
void showPart(QWidget& part, bool shown)
{
    if (part.isVisibleTo(part.parentWidget()) != shown)
        part.setVisible(shown);
}

QSplitter* splitter(Qt::Orientation orientation)
{
    auto* made = new QSplitter(orientation);
    made->setChildrenCollapsible(false);
    made->setHandleWidth(1);
    return made;
}

} // namespace

MicroscopePage::MicroscopePage(app::Session& session, app::DrawnLine& drawn, QWidget* parent)
    : QWidget(parent), session_(session), drawn_(drawn),
      bar_(new MicroscopeBar(session.microscope, drawn)),
      view_(new MicroscopeView(session.microscope)), steps_(new StepsPanel(session.microscope)),
      code_(new CodeView), variables_(new VariablesPanel), operations_(new OperationsView),
      overview_(new Overview(session, view_)), place_(new QLabel(view_)), leave_(linkButton()),
      back_(new QToolButton(view_)), fit_(new QToolButton(view_)),
      variablesCover_(new AnswerCover(&variables_->table())),
      operationsCover_(new AnswerCover(operations_)), across_(splitter(Qt::Horizontal)),
      down_(splitter(Qt::Vertical)), right_(splitter(Qt::Vertical))
{
    setAccessibleName(Text::tr("Clip microscope"));
    place_->setFont(captionFont(font()));
    place_->setForegroundRole(QPalette::PlaceholderText);
    place_->setAutoFillBackground(true); // it may cover lines if no corner is free
    place_->setBackgroundRole(QPalette::Base);
    place_->setAttribute(Qt::WA_TransparentForMouseEvents);
    back_->setText(Text::tr("Return to the drawing's line"));
    back_->setObjectName(QStringLiteral("back-to-line"));
    fit_->setText(Text::tr("Fit"));
    fit_->setToolTip(Text::tr("Fit the clip window and the line into the view (double click)"));
    leave_->setParent(view_);
    leave_->setText(Text::tr("Leave the lesson (Esc)"));
    leave_->setAccessibleName(Text::tr("Leave the lesson"));
    leave_->setToolTip(Text::tr("Return to the drawing; the lesson remembers its page"));
    leave_->setStyleSheet(leave_->styleSheet()
                          + QStringLiteral("QToolButton { background: palette(base); }"));
    leave_->setObjectName(QStringLiteral("leave-lesson"));
    leave_->hide();
    for (QToolButton* button : {back_, fit_}) {
        button->setProperty("framed", true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setFont(captionFont(font()));
        button->setAccessibleName(button->text());
        button->hide();
    }
    down_->addWidget(view_);
    down_->addWidget(steps_);
    down_->setStretchFactor(0, 1);
    across_->addWidget(down_);
    across_->addWidget(beside_ = makeRight());
    across_->setStretchFactor(0, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(bar_);
    column->addWidget(across_, 1);

    const app::Microscope& microscope = session.microscope;
    connect(&microscope, &app::Microscope::stepChanged, this, &MicroscopePage::showStep);
    connect(&microscope, &app::Microscope::tracedLineChanged, this, [this] {
        showStep();
        showPlace();
        overview_->update();
    });
    connect(&drawn, &app::DrawnLine::refreshed, this, &MicroscopePage::showPlace);
    connect(&session, &app::Session::previewChanged, overview_, &Overview::forget);
    connect(&session.scene, &app::Scene::outdated, overview_, &Overview::forget);
    connect(&session, &app::Session::displayChanged, overview_, &Overview::forget); // its paper
    connect(&session, &app::Session::displayChanged, bar_, &MicroscopeBar::follow);
    connect(bar_, &MicroscopeBar::lineDone, view_, [this] { view_->setFocus(); });
    connect(bar_, &MicroscopeBar::closeWanted, this, &MicroscopePage::closeWanted);
    connect(bar_, &MicroscopeBar::exportWanted, this, &MicroscopePage::exportWanted);
    connect(bar_, &MicroscopeBar::refused, this, &MicroscopePage::refused);
    connect(view_, &MicroscopeView::pointerMoved, this, &MicroscopePage::pointerMoved);
    connect(view_, &MicroscopeView::hinted, this, &MicroscopePage::hinted);
    connect(view_, &MicroscopeView::framed, this, &MicroscopePage::placeOverview);
    connect(&session.course, &app::Course::changed, this, &MicroscopePage::showParts);
    connect(leave_, &QToolButton::clicked, this, &MicroscopePage::closeWanted);
    connect(back_, &QToolButton::clicked, &drawn, &app::DrawnLine::back);
    connect(fit_, &QToolButton::clicked, view_, &MicroscopeView::fit);
    for (const QSplitter* parts : {across_, down_, right_})
        connect(parts, &QSplitter::splitterMoved, this, [this] { ownShares_ = true; });
    auto* discs = new AnswerDiscs(session.course, session.practice, *view_);
    connect(discs, &AnswerDiscs::answered, this, &MicroscopePage::goOnInLesson);
    new PlaceMark(session.practice, *view_);
    connect(&session.practice, &app::Practice::changed, this, &MicroscopePage::showParts);
    connect(&session.practice, &app::Practice::changed, this, &MicroscopePage::showStep);
    connect(code_, &CodeView::lineClicked, &session.practice,
            [&practice = session.practice](int line) {
                if (practice.move() && practice.move()->kind == app::MoveKind::Line)
                    practice.setDraft(line);
            });
    addKeys();
    showStep();
    showPlace();
}

QWidget* MicroscopePage::makeRight()
{
    auto* code = new Heading(Text::tr("Pseudo-code"));
    QToolButton* about = linkButton();
    about->setText(Text::tr("About this algorithm"));
    about->setAccessibleName(about->text());
    about->setObjectName(QStringLiteral("about-algorithm-link"));
    code->add(about);
    connect(about, &QToolButton::clicked, this,
            [this] { emit aboutWanted(session_.microscope.tracedLine().variant.algorithm); });
    right_->addWidget(codeBox_ = underHeading(code, code_));
    right_->addWidget(variables_);
    right_->setStretchFactor(0, 1);
    right_->setStretchFactor(1, 0);
    auto* all = new QWidget;
    all->setBackgroundRole(QPalette::AlternateBase);
    all->setAutoFillBackground(true);
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(right_, 1);
    column->addWidget(operationsHeading_ = new Heading(Text::tr("Operations so far")));
    column->addWidget(operations_);
    column->addStretch(); // if the operations stand alone
    return all;
}

void MicroscopePage::addKeys()
{
    app::Microscope& microscope = session_.microscope;
    constexpr std::size_t last = -1;
    const auto add = [this](int key, auto action) {
        auto* shortcut = new QShortcut(QKeySequence(key), this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, action);
        return shortcut;
    };
    add(Qt::Key_Left, [&microscope] { microscope.previous(); });
    add(Qt::Key_Right, [&microscope] { microscope.next(); });
    add(Qt::Key_Home, [&microscope] { microscope.goTo(0); });
    add(Qt::Key_End, [&microscope] { microscope.goTo(last); });
    add(Qt::Key_Escape, [this] { emit closeWanted(); });
    for (int digit = 0; digit <= 9; ++digit)
        add(Qt::Key_0 + digit, [this, digit] { useDigit(digit); });
    // Space still presses a button that has the focus.
    QShortcut* play = add(Qt::Key_Space, [this] { steps_->playback().toggle(); });
    play->setAutoRepeat(false);
    connect(qApp, &QApplication::focusChanged, play, [play](QWidget*, const QWidget* now) {
        play->setEnabled(!qobject_cast<const QAbstractButton*>(now)
                         && !qobject_cast<const QComboBox*>(now));
    });
}

/// Fields take their digits before.
void MicroscopePage::useDigit(int digit)
{
    const bool practises = session_.practice.isOn() && !session_.practice.isPaused();
    const app::DigitUse use =
        app::digitUse({.question = practises || session_.course.asks(), .gesture = view_->drags()});
    if (use == app::DigitUse::Answer) {
        if (!practises)
            session_.course.choose(digit - 1);
        else if (!session_.practice.useDigit(digit))
            return;
        return goOnInLesson();
    }
    if (use != app::DigitUse::Algorithm)
        return;
    for (const clipping::Algorithm& row : clipping::algorithms())
        if (digitOf(row) == QString::number(digit))
            drawn_.choose(app::usable({&row, session_.microscope.tracedLine().variant.form}));
}

/// After an answer that settles the question, Enter turns the lesson's page.
void MicroscopePage::goOnInLesson()
{
    if (side_ && (session_.practice.isOn() || !session_.course.isOpen()))
        side_->setFocus();
}

void MicroscopePage::showStep()
{
    const app::Microscope& microscope = session_.microscope;
    const app::Narration& narration = microscope.narration();
    const app::NarratedStep* narrated = microscope.narrated();
    // A folded branch would say the answer of an open question.
    code_->show(narration.code,
                microscope.isCovered() ? std::set<int>{} : app::linesRun(narration));
    const app::Practice& practice = session_.practice;
    const bool asksHere = practice.asks() && practice.move()->line > 0; // the line that is run now
    code_->light(asksHere ? practice.move()->line : narrated ? narrated->line : 0);
    variables_->show(microscope.tracedLine(), narration,
                     narrated ? microscope.step() : narration.steps.size());
    variablesCover_->setVisible(microscope.isCovered() && !narrated);
    operationsCover_->setVisible(microscope.isCovered());
    const bool counts = narrated && !microscope.isCovered();
    operations_->show(counts ? narrated->cost : clipping::OperationCounts{},
                      counts ? narration.steps.back().cost : clipping::OperationCounts{});
}

VariableTable& MicroscopePage::variables() { return variables_->table(); }

void MicroscopePage::setSide(QWidget* side)
{
    if (side == side_)
        return;
    if (QWidget* before = std::exchange(side_, side)) {
        before->setParent(this); // no longer one of the shares
        before->hide();
        before->deleteLater(); // Deleted later: it may have sent the signal
    }
    if (side) {
        keepShares();
        across_->insertWidget(0, side);
        across_->setStretchFactor(0, 0);
        across_->setStretchFactor(1, 1);
    }
    showParts();
    showPlace();
    if (!side)
        restoreShares();
}

/// All parts, or those that the page of a lesson shows.
void MicroscopePage::showParts()
{
    constexpr app::LessonParts all{
        .code = true, .variables = true, .operations = true, .steps = true};
    const bool practises = session_.practice.isOn() && !session_.practice.isPaused();
    const app::LessonParts shown = !side_      ? all
                                   : practises ? session_.practice.shows()
                                               : session_.course.shows();
    const bool reads =
        side_ && (practises || (session_.course.lesson() && !session_.course.isPaused()));
    if (leave_->isHidden() == reads) {
        leave_->setVisible(reads);
        placeOverview();
    }
    showPart(*bar_, !side_);
    showPart(*steps_, shown.steps);
    view_->countSteps(shown.steps);
    showPart(*codeBox_, shown.code);
    showPart(*variables_, shown.variables);
    showPart(*right_, shown.code || shown.variables);
    showPart(*operationsHeading_, shown.operations);
    showPart(*operations_, shown.operations);
    const bool besideBefore = !beside_->isHidden();
    showPart(*beside_, shown.code || shown.variables || shown.operations);
    if (besideBefore == beside_->isHidden() && side_)
        shareAcross();
}

/// Gives the right column its designed width if there is room, and the steps their preferred
/// height.
void MicroscopePage::share()
{
    shareAcross();
    const int all = height() - (bar_->isHidden() ? 0 : bar_->height());
    const int steps = all < 620 ? steps_->minimumSizeHint().height() : steps_->sizeHint().height();
    down_->setSizes({std::max(180, all - steps), steps});
    const int variables = variables_->sizeHint().height();
    right_->setSizes({std::max(variables, right_->height() - variables), variables});
}

void MicroscopePage::shareAcross()
{
    const int right = width() < wide ? narrowRight : side_ ? lessonRight : rightWidth;
    const double type = std::max(1.0, QFontInfo(font()).pixelSize() / usualType); // presenting
    const int lesson = std::min(qRound((width() < wide ? narrowLesson : lessonWidth) * type),
                                std::max(narrowLesson, qRound(width() * widestLesson)));
    const int left = side_ ? lesson : 0;
    const int taken = left + (beside_->isHidden() ? 0 : right) + 2 * across_->handleWidth();
    const int middle = std::max(leastMiddle, width() - taken);
    across_->setSizes(side_ ? QList{left, middle, right} : QList{middle, right});
}

void MicroscopePage::keepShares()
{
    if (ownShares_ && !sharesBefore_)
        sharesBefore_ = {across_->saveState(), down_->saveState(), right_->saveState()};
    ownShares_ = false;
}

/// The shares as they were before the lessons.
void MicroscopePage::restoreShares()
{
    const auto before = std::exchange(sharesBefore_, std::nullopt);
    ownShares_ = before.has_value();
    if (!before)
        return share();
    across_->restoreState(before->at(0));
    down_->restoreState(before->at(1));
    right_->restoreState(before->at(2));
}

void MicroscopePage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (!ownShares_)
        share();
}

void MicroscopePage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!ownShares_)
        share();
    view_->setFocus();
    emit hinted(
        Text::tr("Drag an end of the line: the whole trace follows. Ctrl suspends snapping."));
}

void MicroscopePage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        placeOverview();
}

} // namespace ui

#include "moc_microscope_page.cpp"
