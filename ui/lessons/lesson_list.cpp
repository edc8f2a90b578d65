// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_list.h"

#include "app/lessons/course.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int margin = 10, mark = 16;

/// The button of a lesson: its number and title, below them its subject and best result, and a tick
/// if the lesson is passed.
class LessonButton : public QAbstractButton {
public:
    LessonButton(int number, const app::Lesson& lesson, const app::Course& course)
        : lesson_(lesson), course_(course)
    {
        setText(QStringLiteral("%1  %2").arg(number).arg(lesson.title));
        setAccessibleName(text());
        setFocusPolicy(Qt::StrongFocus);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        setAttribute(Qt::WA_Hover);
    }
    void refresh()
    {
        const QSettings settings;
        const auto right = app::bestRight(settings, lesson_);
        passed_ = right && app::isPassed(*right, lesson_);
        words_ = lesson_.summary;
        if (right)
            words_ += u'\n'
                      + Text::tr("Best: %1 of %2 right at the first try")
                            .arg(*right)
                            .arg(app::questionsOf(lesson_));
        if (const auto on = course_.lessonToGoOn(); on && &app::lessons()[*on] == &lesson_)
            words_ += u'\n'
                      + Text::tr("Go on at page %1 of %2")
                            .arg(course_.pageToGoOn() + 1)
                            .arg(lesson_.pages.size());
        setAccessibleDescription(passed_ ? words_ + u'\n' + Text::tr("Passed") : words_);
        updateGeometry();
        update();
    }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override
    {
        return 2 * margin + fontMetrics().height() + 2 + summaryRect(width).height();
    }
    QSize sizeHint() const override { return {240, heightForWidth(240)}; }

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            click();
        else
            QAbstractButton::keyPressEvent(event);
    }
    void paintEvent(QPaintEvent*) override
    {
        const Look& look = lookOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(hasFocus() ? QPen(look.selection, 2) : QPen(look.control));
        painter.setBrush(underMouse() || isDown() ? look.hover : look.base);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), space::radius,
                                space::radius);
        const QRect inner = rect().adjusted(margin, margin, -margin, -margin);
        painter.setPen(look.text);
        painter.setFont(semiBold(font()));
        painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, text());
        painter.setFont(captionFont(font()));
        painter.setPen(look.muted);
        painter.drawText(summaryRect(width()), Qt::TextWordWrap, words_);
        if (passed_)
            ui::icon("tick").paint(&painter, QRect(inner.right() - mark, inner.top(), mark, mark));
    }
    void resizeEvent(QResizeEvent*) override { updateGeometry(); }

private:
    QRect summaryRect(int width) const
    {
        const QRect room(margin, margin + fontMetrics().height() + 2, width - 2 * margin, 1000);
        QRect area = QFontMetrics(captionFont(font())).boundingRect(room, Qt::TextWordWrap, words_);
        area.setWidth(room.width()); // with less width the words would wrap differently
        return area;
    }
    const app::Lesson& lesson_;
    const app::Course& course_;
    QString words_;
    bool passed_ = false;
};

} // namespace

LessonList::LessonList(const app::Course& course, QWidget* parent)
    : QScrollArea(parent), course_(course)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                               space::dockMargin);
    column->setSpacing(space::labelToField);
    auto* head = new QHBoxLayout;
    auto* title = new QLabel(Text::tr("Lessons"));
    title->setFont(semiBold(font()));
    auto* close = new QToolButton;
    close->setIcon(icon("close"));
    close->setAutoRaise(true);
    close->setToolTip(Text::tr("Close the lessons"));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, this, &LessonList::closeWanted);
    head->addWidget(title);
    head->addStretch();
    head->addWidget(close);
    column->addLayout(head);
    auto* about = new QLabel(
        Text::tr("Each lesson takes about ten minutes and asks a few questions, each time about "
                 "other lines. Later lessons build on earlier ones, but you may begin anywhere. "
                 "What you answer right at the first try counts. A tick marks the lessons that "
                 "you have passed."));
    about->setWordWrap(true);
    about->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(about);
    for (const app::Lesson& lesson : app::lessons()) {
        const int index = int(buttons_.size());
        auto* button = new LessonButton(index + 1, lesson, course);
        connect(button, &QAbstractButton::clicked, this, [this, index] { emit chosen(index); });
        column->addWidget(button);
        buttons_ << button;
    }
    column->addStretch();
    setWidget(body);
    refresh();
}

void LessonList::focusOnLesson() { buttons_[int(course_.lessonToGoOn().value_or(0))]->setFocus(); }

void LessonList::refresh()
{
    for (QAbstractButton* button : buttons_)
        static_cast<LessonButton*>(button)->refresh();
}

} // namespace ui

#include "moc_lesson_list.cpp"
