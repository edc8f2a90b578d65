// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/status_bar.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/scene/left_alone.h"
#include "app/scene/window_needs.h"
#include "app/session/comparing.h"
#include "app/view/ruler.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/status_cell.h"

#include <QMenu>

namespace ui {

namespace {

constexpr int updateMilliseconds = 100;                      // ten times a second
constexpr int widthForRenderer = 1300, widthForTimes = 1100; // the hint has the room of the rest

QString visibleText(const app::FrameTimes& times)
{
    const QString visible = Text::tr("%1 of %2 visible")
                                .arg(app::countText(times.visible), app::countText(times.total));
    if (times.differing > app::mostDiffering)
        return Text::tr("%1, over %2 differ").arg(visible, app::countText(app::mostDiffering));
    return times.differing > 0
               ? Text::tr("%1, %2 differ").arg(visible, app::countText(times.differing))
               : visible;
}

} // namespace

StatusBar::StatusBar(app::Session& session, Canvas& canvas, QWidget* parent)
    : QStatusBar(parent), session_(session), canvas_(canvas), hint_(new ElidedLabel),
      warning_(new WarningButton), position_(new StatusCell(Text::tr("Pointer"))),
      visible_(new StatusCell(Text::tr("Visible lines"))),
      algorithm_(new StatusCell(Text::tr("Algorithm"))), times_(new StatusCell(Text::tr("Times"))),
      renderer_(new StatusCell(Text::tr("Renderer"))), darkPaper_(new QToolButton),
      zoom_(new ZoomButton)
{
    setSizeGripEnabled(false);
    setFixedHeight(space::statusHeight);
    wearCaption(*hint_);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    hint_->setObjectName(QStringLiteral("hint"));
    hint_->setContentsMargins(8, 0, 0, 0);
    hint_->installEventFilter(this);
    addWidget(hint_, 1);
    addPermanentWidget(warning_);
    warning_->hide();
    connect(warning_, &QToolButton::clicked, this,
            [this] { emit warningWanted(warning_->sentence()); });
    for (QWidget* cell : {position_, visible_, algorithm_, times_, renderer_})
        addPermanentWidget(cell);
    addPaperSwitch();
    addZoomMenu();
    pause_.setSingleShot(true);
    pause_.setInterval(updateMilliseconds);
    connect(&pause_, &QTimer::timeout, this, &StatusBar::showTimes);
    connect(&canvas, &Canvas::frameShown, this, &StatusBar::note);
    connect(&canvas, &Canvas::pointerMoved, this, &StatusBar::showPosition);
    connect(&canvas, &Canvas::viewChanged, this, &StatusBar::showZoom);
    const auto hint = [this](const QString& said) {
        if (!session_.microscope.isOpen() && summary_.isEmpty()) // these have hints of their own
            showHint(said);
    };
    connect(&canvas, &Canvas::hint, this, hint);
    connect(&canvas, &Canvas::toolChanged, this, [hint] { hint({}); });
    connect(&session, &app::Session::displayChanged, this, &StatusBar::keepRoom);
    connect(&session, &app::Session::previewChanged, this, &StatusBar::followWindows);
    connect(&canvas, &Canvas::panesChanged, this, &StatusBar::followWindows);
    connect(&session, &app::Session::loaded, this, &StatusBar::forgetFrames);
    connect(&session, &app::Session::loaded, this, &StatusBar::keepRoom);
    connect(&session.microscope, &app::Microscope::openChanged, this, [this] { showHint({}); });
    for (const auto signal : {&app::Microscope::openChanged, &app::Microscope::tracedLineChanged,
                              &app::Microscope::stepChanged})
        connect(&session.microscope, signal, this, &StatusBar::showStep);
    keepRoom();
    showHint({});
    if (session.microscope.isOpen())
        showStep();
}

QString StatusBar::times() const { return times_->text(); }
QString StatusBar::visibility() const { return visible_->text(); }
QString StatusBar::position() const { return position_->text(); }

void StatusBar::showHint(const QString& hint)
{
    said_ = hint;
    const bool canvas = !session_.microscope.isOpen() && summary_.isEmpty();
    const QString own = canvas && hint.isEmpty() ? canvas_.toolHint() : hint;
    const QString both = canvas && canvas_.digitUse() == app::DigitUse::Algorithm
                             ? Text::tr("%1 Digits: algorithm.").arg(own)
                             : own;
    const bool fits = hint_->fontMetrics().horizontalAdvance(both) <= hint_->contentsRect().width();
    hint_->setWhole(fits ? both : own);
    hint_->setToolTip(both);
}

void StatusBar::warn(const QString& sentence)
{
    warning_->warn(Text::tr("Work not protected"), sentence);
}

void StatusBar::setSummary(const QString& summary)
{
    if (summary == summary_)
        return;
    summary_ = summary;
    if (summary.isEmpty()) { // the canvas again, or the microscope
        showHint({});
        return showStep();
    }
    keepRoom();
    visible_->setText(summary);
    position_->setText({});
    showParts();
}

/// The microscope has no times; zoom and renderer are those of the canvas.
void StatusBar::showParts()
{
    const bool open = session_.microscope.isOpen();
    const bool canvas = !open && summary_.isEmpty();
    times_->setVisible(!open && width() >= widthForTimes);
    zoom_->setVisible(canvas);
    renderer_->setVisible(canvas && width() >= widthForRenderer);
}

void StatusBar::note(const app::FrameTimes& times)
{
    clip_.note(times);
    last_ = times;
    if (!pause_.isActive())
        pause_.start();
}

/// Clears the times until the first frame of another drawing.
void StatusBar::forgetFrames()
{
    pause_.stop();
    clip_.forget();
    last_ = {};
    for (StatusCell* cell : {visible_, times_}) {
        cell->setText({});
        cell->setToolTip({});
    }
}

void StatusBar::showTimes()
{
    if (session_.microscope.isOpen())
        return;
    visible_->setText(summary_.isEmpty() ? visibleText(last_) : summary_);
    const bool differ = summary_.isEmpty() && last_.differing > 0;
    visible_->setToolTip(
        differ ? Text::tr("Some lines are seen to be cut differently from Exact. Another part is "
                          "left, or an end is off by more than 1/16 pixel.")
               : QString());
    const QString clip = app::millisecondsText(clip_.median());
    const bool timed = last_.total >= app::leastLinesToTime;
    const bool late = last_.lateMs > app::longLate;
    times_->setText(
        !last_.painting
            ? timed ? Text::tr("clip %1  draw %2").arg(clip, app::millisecondsText(last_.drawMs))
                    : Text::tr("too few lines to time")
        : timed && late ? Text::tr("clip %1  %2").arg(clip, app::lateText(last_.lateMs))
        : timed         ? Text::tr("clip %1  painting…").arg(clip)
                        : Text::tr("painting…"));
    explainTimes();
    emit this->timed(timed ? clip : QString(), last_.differing);
}

void StatusBar::explainTimes()
{
    QStringList sentences;
    if (last_.total < app::leastLinesToTime)
        sentences << Text::tr("With fewer than %1 lines the times are too short to measure.")
                         .arg(app::countText(app::leastLinesToTime));
    else
        sentences << Text::tr("Clipping: %1 ns per line. This is the processor time of all cores, "
                              "which other programs do not make longer. It is the median of up to "
                              "%2 frames of this drawing at these windows.")
                         .arg(app::numberText(clip_.median() * 1e6 / double(last_.total), 1))
                         .arg(app::FrameStatistics::length);
    if (last_.total >= app::leastLinesToTime && last_.lateMs > app::longLate)
        sentences << Text::tr(
            "The canvas still shows an earlier cut, until this one is clipped and "
            "painted.");
    else if (last_.painting)
        sentences << Text::tr("The picture takes a while. Until it is ready, the canvas shows the "
                              "previous one.");
    else if (last_.total >= app::leastLinesToTime)
        sentences << Text::tr("Drawing: the time in which this picture was painted.");
    times_->setToolTip(sentences.join(u' '));
}

void StatusBar::showPosition(std::optional<app::Point> position)
{
    if (!position)
        return position_->setText({});
    const app::Page& page = session_.now().page();
    const double size = page.realMillimetresPerUnit();
    const app::Unit unit = session_.display().unit;
    const app::Point place = *position - app::originOf(page, unit);
    position_->setText(
        Text::tr("x %1  y %2")
            .arg(app::lengthNumber(place.x, unit, size), app::lengthText(place.y, unit, size)));
}

void StatusBar::showPoint(std::optional<app::Point> point)
{
    position_->setText(
        point ? Text::tr("x %1  y %2").arg(app::shortText(point->x), app::shortText(point->y))
              : QString());
}

/// While the microscope is open, shows its step instead of times.
void StatusBar::showStep()
{
    const app::Microscope& microscope = session_.microscope;
    const bool open = microscope.isOpen();
    showParts();
    followPaper();
    keepRoom();
    if (!open) {
        showTimes();
        return showPosition({});
    }
    const auto steps = microscope.narration().steps.size();
    const QString now = app::countText(microscope.step() + 1);
    const QString all = microscope.isCovered() ? QStringLiteral("?") : app::countText(steps);
    visible_->setText(microscope.isCovered() && steps == 0 ? Text::tr("steps covered")
                      : steps == 0                         ? Text::tr("no steps")
                                   : Text::tr("step %1 of %2").arg(now, all));
    showAlgorithm(microscope.tracedLine().variant);
}

void StatusBar::showZoom()
{
    zoom_->setText(Text::tr("%1 % ▾").arg(app::numberText(canvas_.zoom() * 100, 0)));
}

/// Gives every cell the width of the widest text possible for this drawing.
void StatusBar::keepRoom()
{
    const auto& page = session_.now().page();
    const double size = page.realMillimetresPerUnit();
    const app::Unit unit = session_.display().unit;
    const double farthest = -std::max({std::abs(page.size.x), std::abs(page.size.y), 1.0});
    position_->setWidest(
        Text::tr("x %1  y %2")
            .arg(app::lengthNumber(farthest, unit, size), app::lengthText(farthest, unit, size)));
    keepRoomForLines();
    times_->setWidest(Text::tr("clip %1  draw %2")
                          .arg(app::millisecondsText(0.001), app::millisecondsText(99.9)));
    if (!session_.microscope.isOpen())
        showAlgorithm(session_.variant());
    renderer_->setWidest(QStringLiteral("OpenGL"));
    renderer_->setText(canvas_.backend() == Backend::OpenGL ? Text::tr("OpenGL")
                                                            : Text::tr("Raster"));
    renderer_->setToolTip(canvas_.backendReason());
    zoom_->setWidest(Text::tr("%1 % ▾").arg(u"10,000"));
    showZoom();
}

void StatusBar::keepRoomForLines()
{
    const std::size_t lines = session_.scene.lines().size();
    const bool isExact =
        app::usedAt(session_.region(), session_.variant()).algorithm == &clipping::exactAlgorithm();
    const app::FrameTimes widest{.visible = std::max<std::size_t>(lines, 9999),
                                 .total = std::max<std::size_t>(lines, 9999),
                                 .differing =
                                     isExact ? 0 : std::min(lines, app::mostDiffering + 1)};
    visible_->setWidest(summary_.isEmpty() ? visibleText(widest) : summary_);
}

/// Whether the active pane does not clip at some windows, rather than with another algorithm.
bool StatusBar::leavesAlone() const
{
    return canvas_.panes().size() > 1
           && !app::leftAlone(session_.region(), session_.variant()).empty();
}

void StatusBar::showAlgorithm(const app::Variant& variant)
{
    QString widest;
    for (const auto& row : clipping::algorithms())
        if (fontMetrics().horizontalAdvance(app::latin(row.abbreviation))
            > fontMetrics().horizontalAdvance(widest))
            widest = app::latin(row.abbreviation);
    const bool open = session_.microscope.isOpen();
    const app::Variant used =
        open || leavesAlone() ? variant : app::usedAt(session_.region(), variant);
    const bool published = used.form == clipping::Form::Published;
    const QString mark = used.misprint ? Text::tr(", misprint") : Text::tr(", published"),
                  other = Text::tr("%1 instead of %2");
    const bool instead = used.algorithm != variant.algorithm;
    const QString name = app::latin(used.algorithm->abbreviation);
    algorithm_->setWidest(instead ? other.arg(name, widest) : published ? widest + mark : widest);
    algorithm_->setText(instead     ? other.arg(name, app::latin(variant.algorithm->abbreviation))
                        : published ? name + mark
                                    : name);
    explainAlgorithm();
}

void StatusBar::followWindows()
{
    keepRoomForLines(); // where the algorithm cannot clip, another one is used
    if (!session_.microscope.isOpen())
        showAlgorithm(session_.variant());
}

void StatusBar::explainAlgorithm()
{
    const bool open = session_.microscope.isOpen();
    const app::Variant& shown =
        open ? session_.microscope.tracedLine().variant : session_.variant();
    const QString instead = open || leavesAlone()
                                ? QString()
                                : app::insteadText(app::needsOf(session_.region()), shown);
    const QString what = instead.isEmpty() ? app::latin(shown.algorithm->name) : instead;
    const QString compared = open ? QString() : app::onlyComparedText(session_);
    algorithm_->setToolTip(
        compared.isEmpty()
            ? what
            : what + u'\n'
                  + Text::tr("%1. Right click on its row in Compare, or on its pane's heading, to "
                             "use it.")
                        .arg(compared));
}

void StatusBar::resizeEvent(QResizeEvent* event)
{
    QStatusBar::resizeEvent(event);
    showParts();
}

bool StatusBar::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == hint_ && event->type() == QEvent::Resize)
        showHint(said_); // the bar, or a cell beside it, has another width
    return QStatusBar::eventFilter(watched, event);
}

void StatusBar::changeEvent(QEvent* event)
{
    QStatusBar::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        followPaper();
}

void StatusBar::addPaperSwitch()
{
    darkPaper_->setObjectName(QStringLiteral("dark-paper-switch"));
    darkPaper_->setText(Text::tr("Dark paper"));
    darkPaper_->setToolTip(
        Text::tr("Show the page dark, and dark colours lighter on it. Files keep "
                 "their colours."));
    wearCaption(*darkPaper_);
    darkPaper_->setCheckable(true);
    darkPaper_->setAutoRaise(true);
    darkPaper_->setFocusPolicy(Qt::TabFocus);
    connect(darkPaper_, &QToolButton::clicked, this, [this](bool on) {
        session_.changeDisplay([on](app::Display& display) { display.darkPaper = on; });
    });
    connect(&session_, &app::Session::displayChanged, this, &StatusBar::followPaper);
    addPermanentWidget(darkPaper_);
    followPaper();
}

/// In the light theme dark paper is a command of the menu View only.
void StatusBar::followPaper()
{
    darkPaper_->setVisible(lookOf(palette()).dark && !session_.microscope.isOpen());
    darkPaper_->setChecked(session_.display().darkPaper);
}

void StatusBar::addZoomMenu()
{
    auto* menu = new QMenu(zoom_);
    for (const double percent : {25.0, 50.0, 100.0, 200.0, 400.0, 800.0})
        menu->addAction(Text::tr("%1 %").arg(percent), this,
                        [this, percent] { canvas_.setZoom(percent / 100); });
    menu->addSeparator();
    menu->addAction(Text::tr("Fit drawing"), &canvas_, &Canvas::fitDrawing);
    menu->addAction(Text::tr("Fit page"), &canvas_, &Canvas::fitPage);
    menu->addAction(Text::tr("Fit selection"), &canvas_, &Canvas::fitSelection);
    QAction* window = menu->addAction(Text::tr("Fit clip window"), &canvas_, &Canvas::fitWindow);
    connect(menu, &QMenu::aboutToShow, window,
            [this, window] { window->setEnabled(session_.clipWindow().has_value()); });
    zoom_->setMenu(menu);
    zoom_->setAccessibleName(Text::tr("Zoom"));
    zoom_->setToolTip(Text::tr("Zoom"));
    addPermanentWidget(zoom_);
}

} // namespace ui

#include "moc_status_bar.cpp"
