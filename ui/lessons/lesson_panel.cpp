// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_panel.h"

#include "app/lessons/course.h"
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_list.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QApplication>
#include <QScrollBar>
#include <QSettings>
#include <QShortcut>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int usualWidth = 320, leastWidth = 240;
constexpr double lineHeight = 140; // percent

QPushButton* button(const QString& text, const QString& tip)
{
    auto* made = new QPushButton(text);
    made->setToolTip(tip);
    made->setMinimumHeight(space::toolButton);
    made->setAutoDefault(true); // Enter presses it
    return made;
}

/// Converts Markdown to a label's rich text with a larger line height.
QString richText(const QString& markdown)
{
    QTextDocument document;
    document.setMarkdown(markdown);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        format.setLineHeight(lineHeight, QTextBlockFormat::ProportionalHeight);
        QTextCursor(block).setBlockFormat(format);
    }
    return document.toHtml();
}

} // namespace

LessonPanel::LessonPanel(app::Course& course, QWidget* parent)
    : QStackedWidget(parent), course_(course), list_(new LessonList(course)), title_(new QLabel),
      place_(new QLabel), text_(new QLabel), told_(new QLabel), ending_(new QLabel),
      body_(new QScrollArea), choices_(new ChoiceList),
      back_(button(Text::tr("Back"), Text::tr("Previous page (Page Up)"))),
      again_(button(Text::tr("Show example"),
                    Text::tr("Show this page's example in the microscope again"))),
      next_(button(Text::tr("Next"), Text::tr("Next page (Page Down)"))),
      repeat_(button(Text::tr("Repeat lesson"),
                     Text::tr("Start this lesson again; your best points are kept")))
{
    setObjectName(QStringLiteral("lessons"));
    setAccessibleName(Text::tr("Lessons"));
    addWidget(list_);
    addWidget(makeReader());
    connect(list_, &LessonList::chosen, this,
            [this](int lesson) { course_.beginOrGoOn(std::size_t(lesson)); });
    connect(list_, &LessonList::closeWanted, this, &LessonPanel::closeWanted);
    connect(choices_, &ChoiceList::chosen, this, [this](int choice) {
        course_.choose(choice);
        body_->ensureWidgetVisible(choices_);
    });
    connect(choices_, &ChoiceList::answerWanted, &course_, &app::Course::showAnswer);
    connect(&course_, &app::Course::changed, this, &LessonPanel::showPage);
    connect(back_, &QPushButton::clicked, this, [this] { turn(-1); });
    connect(next_, &QPushButton::clicked, this, [this] { turn(1); });
    connect(again_, &QPushButton::clicked, &course_, &app::Course::showAgain);
    connect(repeat_, &QPushButton::clicked, this, [this] {
        course_.begin(course_.lessonIndex());
        focusNext();
    });
    const auto key = [this](int code, int pages) {
        auto* shortcut = new QShortcut(QKeySequence(code), this);
        connect(shortcut, &QShortcut::activated, this, [this, pages] { turn(pages); });
    };
    key(Qt::Key_PageUp, -1);
    key(Qt::Key_PageDown, 1);
    showPage();
}

QWidget* LessonPanel::makeReader()
{
    auto* reader = new QWidget;
    auto* column = new QVBoxLayout(reader);
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::dockMargin);
    column->setSpacing(space::labelToField);
    column->addLayout(makeHead());
    column->addWidget(makeBody(), 1);
    column->addWidget(ending_);
    column->addWidget(repeat_, 0, Qt::AlignLeft);
    column->addLayout(makeFoot());
    return reader;
}

QLayout* LessonPanel::makeHead()
{
    auto* all = new QToolButton;
    all->setIcon(icon("list"));
    all->setAutoRaise(true);
    all->setToolTip(Text::tr("Show all lessons"));
    all->setAccessibleName(all->toolTip());
    connect(all, &QToolButton::clicked, this, &LessonPanel::showList);
    title_->setFont(semiBold(font()));
    title_->setWordWrap(true);
    place_->setForegroundRole(QPalette::PlaceholderText);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(title_);
    words->addWidget(place_);
    auto* head = new QHBoxLayout;
    head->addLayout(words, 1);
    head->addWidget(all, 0, Qt::AlignTop);
    return head;
}

/// The text with the question below; scrolls if there is too little room.
QWidget* LessonPanel::makeBody()
{
    ending_->setFont(semiBold(font()));
    for (QLabel* label : {text_, told_, ending_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setAlignment(Qt::AlignTop);
    }
    auto* inner = new QWidget;
    auto* column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, space::labelToField, 0); // distance from the scroll bar
    column->addWidget(text_);
    column->addWidget(choices_);
    column->addSpacing(space::labelToField);
    column->addWidget(told_);
    column->addStretch();
    body_->setFrameShape(QFrame::NoFrame);
    body_->setWidgetResizable(true);
    body_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    body_->setFocusPolicy(Qt::NoFocus);
    body_->setWidget(inner);
    return body_;
}

QLayout* LessonPanel::makeFoot()
{
    auto* foot = new QHBoxLayout;
    foot->setSpacing(space::labelToField);
    foot->addWidget(back_);
    foot->addWidget(again_);
    foot->addStretch();
    foot->addWidget(next_);
    return foot;
}

void LessonPanel::showList()
{
    course_.atEnd() ? course_.end() : course_.pause();
    list_->focusOnLesson();
}

void LessonPanel::turn(int pages)
{
    if (!course_.lesson() || course_.isPaused())
        return;
    if (pages < 0)
        course_.previous();
    else if (!course_.atLastPage())
        course_.next();
    else if (course_.isOpen())
        return;
    else if (course_.lessonIndex() + 1 < app::lessons().size())
        course_.begin(course_.lessonIndex() + 1);
    else
        showList();
    focusNext();
}

void LessonPanel::focusNext()
{
    if (course_.lesson() && !course_.isPaused())
        nextInHand()->setFocus();
}

QWidget* LessonPanel::nextInHand() const
{
    if (!course_.isOpen())
        return next_;
    QWidget* choice = choices_->firstOpen();
    return choice ? choice : again_;
}

void LessonPanel::showPage()
{
    const bool reads = course_.lesson() && !course_.isPaused();
    const QWidget* focus = QApplication::focusWidget();
    const bool answers = focus && choices_->isAncestorOf(focus); // whose buttons are made anew
    setCurrentIndex(reads ? 1 : 0);
    list_->refresh();
    if (!reads) {
        setFocusProxy(list_->buttons()[int(course_.lessonToGoOn().value_or(0))]);
        return;
    }
    title_->setText(course_.lesson()->title);
    QString place = Text::tr("Page %1 of %2").arg(course_.page() + 1).arg(course_.pages());
    if (const app::Score score = course_.score(); score.settled > 0) {
        place +=
            QStringLiteral(" · ")
            + Text::tr("%1 of %2 points").arg(score.points).arg(app::mostPoints(*course_.lesson()));
        QSettings settings;
        app::keepPoints(settings, *course_.lesson(), score.points);
    }
    place_->setText(place);
    if (course_.answer().wrong == 0
        && course_.answer().tries.empty()) // a new page, not another try
        body_->verticalScrollBar()->setValue(0);
    text_->setText(richText(course_.text()));
    choices_->show(course_);
    told_->setText(richText(course_.told()));
    told_->setVisible(!course_.told().isEmpty());
    showEnding();
    back_->setEnabled(course_.page() > 0);
    next_->setEnabled(!course_.isOpen());
    next_->setToolTip(course_.isOpen()
                          ? Text::tr("First answer the question, or choose “Show the answer”")
                          : Text::tr("Next page (Page Down)"));
    setFocusProxy(nextInHand());
    if (answers)
        focusNext();
    const bool last = course_.lessonIndex() + 1 == app::lessons().size();
    next_->setText(!course_.atLastPage() ? Text::tr("Next")
                   : last                ? Text::tr("Finish")
                                         : Text::tr("Next lesson"));
}

/// Shows the ending below the text, where it is visible without scrolling.
void LessonPanel::showEnding()
{
    ending_->setText(course_.ending());
    ending_->setVisible(!ending_->text().isEmpty());
    repeat_->setVisible(ending_->isVisibleTo(this)
                        && !app::isPassed(course_.score().points, *course_.lesson()));
}

void LessonPanel::changeEvent(QEvent* event)
{
    QStackedWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        showPage();
}

QSize LessonPanel::sizeHint() const { return {usualWidth, 600}; }
QSize LessonPanel::minimumSizeHint() const { return {leastWidth, 200}; }

} // namespace ui

#include "moc_lesson_panel.cpp"
