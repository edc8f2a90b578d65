// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_list.h"

#include "app/lessons/course.h"
#include "app/lessons/lesson_places.h"
#include "app/lessons/opened_lessons.h"
#include "ui/lessons/practice_entry.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int margin = 10, mark = 16;

/// The button of a lesson: its number and title, below them its subject and best result, and a tick
/// if the lesson is passed.
class LessonButton : public QAbstractButton {
public:
    LessonButton(std::size_t lesson, const app::Course& course)
        : number_(lesson), lesson_(*app::lessonAt(lesson)), course_(course)
    {
        setText(QStringLiteral("%1  %2").arg(app::placeOfLesson(lesson)).arg(lesson_.title));
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
        if (course_.lessonToGoOn() == number_)
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
    const std::size_t number_;
    const app::Lesson& lesson_; // an opened lesson stays, also when another replaces it
    const app::Course& course_;
    QString words_;
    bool passed_ = false;
};

/// A sentence of someone else, which is never rich text.
QLabel* plainLabel(const QString& text)
{
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

LessonList::LessonList(const app::Course& course, const app::Practice& practice, QWidget* parent)
    : QScrollArea(parent), course_(course), practice_(new PracticeEntry(practice))
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
    for (std::size_t i = 0; i < app::lessons().size(); ++i)
        addLesson(*column, i);
    column->addWidget(practice_);
    connect(practice_, &PracticeEntry::chosen, this, &LessonList::practiceChosen);
    connect(practice_, &PracticeEntry::goOnWanted, this, &LessonList::practiceGoesOn);
    opened_ = new QWidget;
    column->addWidget(opened_);
    column->addStretch();
    setWidget(body);
    addOpened();
    refresh();
}

void LessonList::addLesson(QBoxLayout& column, std::size_t lesson)
{
    auto* button = new LessonButton(lesson, course_);
    connect(button, &QAbstractButton::clicked, this, [this, lesson] { emit chosen(int(lesson)); });
    column.addWidget(button);
    buttons_ << button;
    numbers_.push_back(lesson);
}

/// The lessons that people opened, each folder under its heading with what is wrong in it.
void LessonList::addOpened()
{
    openings_ = app::lessonOpenings();
    opened_->hide(); // nothing is laid out until all are there
    const auto own = qsizetype(app::lessons().size());
    qDeleteAll(buttons_.mid(own));
    buttons_.resize(own);
    numbers_.resize(std::size_t(own));
    qDeleteAll(opened_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    delete opened_->layout();
    auto* column = new QVBoxLayout(opened_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(space::labelToField);
    for (const app::LessonGroup& group : app::openedLessons()) {
        column->addSpacing(space::betweenGroups);
        column->addWidget(headingOf(group));
        for (const std::size_t lesson : group.lessons)
            addLesson(*column, lesson);
        for (const QString& note : group.notes) {
            QLabel* label = plainLabel(note);
            label->setForegroundRole(QPalette::PlaceholderText);
            column->addWidget(label);
        }
    }
    opened_->setVisible(!app::openedLessons().empty());
}

/// The name of a folder, and what takes it out of the list.
QWidget* LessonList::headingOf(const app::LessonGroup& group)
{
    auto* heading = new QWidget;
    auto* row = new QHBoxLayout(heading);
    row->setContentsMargins(0, 0, 0, 0);
    QLabel* name = plainLabel(group.heading);
    name->setFont(semiBold(font()));
    name->setToolTip(group.folder);
    QToolButton* close = iconButton(
        "close", Text::tr("Take %1 out of the list. Its files stay.").arg(group.heading));
    close->setObjectName(QStringLiteral("close-folder"));
    connect(
        close, &QToolButton::clicked, this,
        [this, folder = group.folder] {
            QSettings settings;
            app::forgetLessonPlace(settings, folder);
            app::closeOpenedLessons(folder);
            refresh();
            focusOnLesson();
        },
        Qt::QueuedConnection); // the button is deleted
    row->addWidget(name, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    return heading;
}

QAbstractButton* LessonList::buttonOf(std::size_t lesson) const
{
    const auto found = std::ranges::find(numbers_, lesson);
    return buttons_[found == numbers_.end() ? 0 : int(found - numbers_.begin())];
}

void LessonList::focusOnLesson(std::optional<std::size_t> lesson)
{
    QAbstractButton* button = buttonOf(lesson.value_or(course_.lessonToGoOn().value_or(0)));
    button->setFocus();
    if (lesson)
        ensureWidgetVisible(button);
}

void LessonList::refresh()
{
    if (openings_ != app::lessonOpenings())
        addOpened();
    for (QAbstractButton* button : buttons_)
        static_cast<LessonButton*>(button)->refresh();
    practice_->refresh();
}

} // namespace ui

#include "moc_lesson_list.cpp"
