// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/pane_heading.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/view/pane_grid.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/tabular.h"

#include <QApplication>
#include <QMenu>
#include <QMouseEvent>

namespace ui {

namespace {

constexpr int updateMilliseconds = 100; // ten times a second
constexpr int headingMargin = 10, headingGap = 8, markerSize = 12, button = 20;
constexpr int widthForClose = 260; // in narrower headings the menu closes the pane
constexpr int leastName = 48;      // a name elided to less is not shown

QToolButton* makeButton(QWidget* parent, const QString& name)
{
    auto* made = new QToolButton(parent);
    made->setAutoRaise(true);
    made->setFixedSize(button, button);
    made->setFocusPolicy(Qt::TabFocus);
    made->setAccessibleName(name);
    made->setToolTip(name);
    return made;
}

} // namespace

PaneHeading::PaneHeading(QWidget* parent)
    : QWidget(parent), choose_(makeButton(this, Text::tr("Algorithm of this pane"))),
      close_(makeButton(this, Text::tr("Close this pane")))
{
    setFixedHeight(app::paneHeading);
    choose_->setText(QStringLiteral("▾"));
    close_->setIcon(icon("close"));
    close_->setIconSize({14, 14});
    connect(choose_, &QToolButton::clicked, this, &PaneHeading::openMenu);
    connect(close_, &QToolButton::clicked, this, &PaneHeading::closeWanted);
    connect(qApp, &QApplication::focusChanged, this, &PaneHeading::place);
    pause_.setSingleShot(true);
    pause_.setInterval(updateMilliseconds);
    connect(&pause_, &QTimer::timeout, this, &PaneHeading::showTime);
}

PaneHeading::~PaneHeading()
{
    // Its buttons may lose the focus while they are destroyed.
    disconnect(qApp, nullptr, this, nullptr);
}

void PaneHeading::show(const Pane& pane)
{
    pane_ = pane;
    const QString name = app::latin(pane.choice.algorithm->name);
    setAccessibleName(pane.choice.form == clipping::Form::Published
                          ? Text::tr("%1 as published").arg(name)
                          : name);
    followNeeds();
}

void PaneHeading::setNeeds(app::WindowNeeds needs)
{
    if (std::exchange(needs_, needs) != needs && pane_)
        followNeeds();
}

void PaneHeading::setLimits(const QString& where, const QString& left)
{
    if (where == where_ && left == left_)
        return;
    where_ = where;
    left_ = left;
    if (pane_)
        followNeeds();
}

bool PaneHeading::clips() const
{
    return left_.isEmpty() ? app::limitText(pane_->choice, needs_).isEmpty() : !where_.isEmpty();
}

app::Variant PaneHeading::used() const
{
    return left_.isEmpty() ? app::usedAt(needs_, pane_->choice) : pane_->choice;
}

void PaneHeading::followNeeds()
{
    const QString instead =
        left_.isEmpty() ? app::insteadText(needs_, pane_->choice)
                        : Text::tr("%1 does not clip %2: %3")
                              .arg(accessibleName(), left_, app::limitText(pane_->choice, needs_));
    // Otherwise the pane that clips more would seem to be slower.
    QString timed;
    if (!left_.isEmpty() && !where_.isEmpty())
        timed = Text::tr("The time is that of the other windows.");
    else if (left_.isEmpty() && needs_ > app::WindowNeeds::RotatedRectangle)
        timed = Text::tr("The time is that of all windows, also of those that other algorithms "
                         "cannot clip.");
    const QString what = instead.isEmpty() ? accessibleName() : instead;
    setToolTip(timed.isEmpty() ? what : what + u'\n' + timed);
    place();
    update();
}

// The name of the algorithm, or what clips in its place.
QString PaneHeading::nameText() const
{
    if (!left_.isEmpty())
        return where_.isEmpty() ? app::limitText(pane_->choice, needs_) : where_;
    const app::Variant used = this->used();
    if (used.algorithm == pane_->choice.algorithm)
        return app::latin(used.algorithm->name);
    return Text::tr("%1: %2 instead", "why an algorithm cannot clip; what clips instead")
        .arg(app::limitText(pane_->choice, needs_), app::latin(used.algorithm->abbreviation));
}

void PaneHeading::note(const app::FrameTimes& times)
{
    clip_.note(times);
    last_ = times;
    if (!pause_.isActive())
        pause_.start();
}

void PaneHeading::showTime()
{
    time_ = last_.total < app::leastLinesToTime ? QString()
            : last_.lateMs > app::longLate      ? app::lateText(last_.lateMs)
                                                : app::millisecondsText(clip_.median());
    setAccessibleDescription(time_);
    place();
    update();
}

QString PaneHeading::formText() const
{
    return width() < widthForClose ? Text::tr("published") : Text::tr("as published");
}

PaneHeading::Places PaneHeading::places() const
{
    Places p;
    auto left = [&, x = headingMargin](int width) mutable {
        return QRect(std::exchange(x, x + width), 1, width, height() - 1);
    };
    const int timeWidth = std::max(tabularWidth(fontMetrics(), app::millisecondsText(88.8)),
                                   tabularWidth(fontMetrics(), time_));
    if (width() >= widthForClose)
        p.close = QRect(width() - button - 4, 5, button, button);
    const int right = p.close.isValid() ? p.close.left() - 4 : width() - headingMargin;
    p.time = QRect(right - timeWidth, 1, timeWidth, height() - 1);
    p.marker = left(markerSize + headingGap);
    const QFontMetrics bold(semiBold(font()));
    const auto& algorithm = *pane_->choice.algorithm;
    p.abbreviation = left(bold.horizontalAdvance(app::latin(algorithm.abbreviation)) + headingGap);
    int room = p.time.left() - headingGap - button - p.abbreviation.right();
    const int name = fontMetrics().horizontalAdvance(nameText()) + headingGap;
    const int formWidth =
        QFontMetrics(captionFont(font())).horizontalAdvance(formText()) + headingGap;
    const bool published = used().form == clipping::Form::Published;
    const bool form = published && formWidth <= room;
    room -= form ? formWidth : 0;
    if (room >= std::min(name, leastName + headingGap))
        p.name = left(std::min(name, room));
    if (form)
        p.form = left(formWidth);
    p.choose = left(button);
    p.choose = QRect(p.choose.left() - 4, 5, button, button);
    return p;
}

void PaneHeading::place()
{
    if (!pane_)
        return;
    const Places p = places();
    choose_->setGeometry(p.choose);
    close_->setGeometry(p.close);
    const QWidget* focus = focusWidget();
    const bool inHand = underMouse() || (focus && focus->hasFocus());
    choose_->setVisible(pane_->active || inHand);
    close_->setVisible(inHand && p.close.isValid());
}

void PaneHeading::paintEvent(QPaintEvent*)
{
    if (!pane_)
        return;
    const Look& look = lookOf(palette());
    const app::Variant& choice = pane_->choice;
    const Places p = places();
    QPainter painter(this);
    painter.fillRect(rect(), look.panel);
    if (pane_->active)
        painter.fillRect(0, 0, width(), 2, look.selection);
    const int markerTop = (height() - markerSize) / 2 + 1;
    const bool clips = this->clips();
    painter.setOpacity(clips ? 1 : 0.4);
    app::paintMarker(painter, QRectF(p.marker.left(), markerTop, markerSize, markerSize), choice,
                     groundOf(palette()));
    painter.setOpacity(1);
    const auto text = [&](const QRect& place, const QFont& font, const QColor& colour,
                          const QString& words) {
        if (!place.isValid())
            return;
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(
            place, Qt::AlignLeft | Qt::AlignVCenter,
            QFontMetrics(font).elidedText(words, Qt::ElideRight, place.width() - headingGap + 1));
    };
    const QColor ink = clips ? look.text : palette().color(QPalette::Disabled, QPalette::Text);
    text(p.abbreviation, semiBold(font()), ink, app::latin(choice.algorithm->abbreviation));
    text(p.name, font(), clips && left_.isEmpty() ? look.text : look.muted, nameText());
    text(p.form, captionFont(font()), look.muted, formText());
    painter.setFont(font());
    painter.setPen(look.text);
    drawTabular(painter, p.time, Qt::AlignRight | Qt::AlignVCenter, time_);
}

void PaneHeading::resizeEvent(QResizeEvent*) { place(); }

void PaneHeading::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit pressed();
}

void PaneHeading::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit aloneWanted();
}

void PaneHeading::contextMenuEvent(QContextMenuEvent*) { openMenu(); }

bool PaneHeading::event(QEvent* event)
{
    const bool result = QWidget::event(event);
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave)
        place();
    return result;
}

void PaneHeading::openMenu()
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fill(*menu);
    menu->popup(mapToGlobal(choose_->geometry().bottomLeft()));
}

void PaneHeading::fill(QMenu& menu)
{
    QMenu* const published = new QMenu(Text::tr("&Published forms"), &menu);
    for (const clipping::Algorithm& row : clipping::algorithms()) {
        addChoice(menu, {&row});
        if (row.published)
            addChoice(*published, {&row, clipping::Form::Published});
    }
    menu.addSeparator();
    menu.addMenu(published);
    menu.addSeparator();
    menu.addAction(Text::tr("&Use this algorithm"), this, &PaneHeading::useWanted);
    menu.addAction(Text::tr("Show &only this pane"), this, &PaneHeading::aloneWanted);
    menu.addAction(Text::tr("&Close this pane"), this, &PaneHeading::closeWanted);
}

void PaneHeading::addChoice(QMenu& menu, const app::Variant& choice)
{
    auto* action = menu.addAction(markerIcon(choice), app::limitedName(*choice.algorithm, needs_),
                                  this, [this, choice] { emit chosen(choice); });
    action->setCheckable(true);
    action->setChecked(pane_->choice == choice);
}

} // namespace ui

#include "moc_pane_heading.cpp"
