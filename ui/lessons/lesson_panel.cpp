// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_panel.h"

#include "app/lessons/course.h"
#include "app/lessons/opened_lessons.h"
#include "ui/lessons/choice_list.h"
#include "ui/lessons/lesson_list.h"
#include "ui/lessons/page_dots.h"
#include "ui/lessons/page_parts.h"
#include "ui/lessons/page_picture.h"
#include "ui/lessons/practice_page.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"

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

constexpr int usualWidth = 480, leastWidth = 320, wideMargin = 48, narrowMargin = 24, scrollGap = 8;
constexpr int widthWithDots = 360; // of the page, with type of this size in pixels
constexpr double usualType = 13;
constexpr double lineHeight = 140; // percent

QPushButton* button(const QString& text, const QString& tip)
{
    auto* made = new QPushButton(text);
    made->setToolTip(tip);
    made->setMinimumHeight(space::toolButton);
    made->setAutoDefault(true); // Enter presses it
    return made;
}

/// Converts Markdown to a label's rich text in the page's type with a larger line height.
QString richText(const QString& markdown)
{
    QTextDocument document;
    document.setDefaultFont(scaledFont(QApplication::font(), pageType::text));
    // Of other people's lessons, too: no HTML, which could name files.
    document.setMarkdown(markdown,
                         QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub
                                                         | QTextDocument::MarkdownNoHTML));
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        format.setLineHeight(lineHeight, QTextBlockFormat::ProportionalHeight);
        QTextCursor(block).setBlockFormat(format);
    }
    return document.toHtml();
}

} // namespace

LessonPanel::LessonPanel(app::Course& course, app::Practice& practice, QWidget* parent)
    : QStackedWidget(parent), course_(course), practice_(practice),
      list_(new LessonList(course, practice)), practicePage_(new PracticePage(practice)),
      place_(new QLabel), title_(new QLabel), text_(new QLabel), told_(new QLabel),
      ending_(new QLabel), count_(new QLabel), body_(new QScrollArea), picture_(new PagePicture),
      choices_(new ChoiceList), dots_(new PageDots),
      back_(button(Text::tr("Back"), Text::tr("Previous page (Page Up)"))),
      again_(button(Text::tr("Show example"),
                    Text::tr("Show this page's example in the microscope again"))),
      skip_(button(Text::tr("Skip"), Text::tr("Go on without an answer. The question then does not "
                                              "count as right."))),
      next_(button(Text::tr("Next"), Text::tr("Next page (Page Down)"))),
      repeat_(
          button(Text::tr("Repeat lesson"),
                 Text::tr("Start this lesson again, with other lines; your best result is kept")))
{
    for (QLabel* label : {text_, told_})
        label->setTextFormat(Qt::RichText);
    setObjectName(QStringLiteral("lessons"));
    setAccessibleName(Text::tr("Lessons"));
    addWidget(list_);
    addWidget(reader_ = makeReader());
    addWidget(practicePage_);
    setBackgroundRole(QPalette::AlternateBase);
    setAutoFillBackground(true);
    connect(list_, &LessonList::chosen, this, [this](int lesson) {
        course_.beginOrGoOn(std::size_t(lesson));
        focusNext();
    });
    connect(list_, &LessonList::closeWanted, this, &LessonPanel::closeWanted);
    connect(list_, &LessonList::practiceChosen, &practice, &app::Practice::begin);
    connect(list_, &LessonList::practiceGoesOn, &practice, &app::Practice::goOn);
    connect(practicePage_, &PracticePage::listWanted, this, &LessonPanel::showList);
    connect(&practice, &app::Practice::changed, this, &LessonPanel::showPractice);
    connect(choices_, &ChoiceList::chosen, this, [this](int choice) {
        course_.choose(choice);
        body_->ensureWidgetVisible(choices_);
    });
    connect(choices_, &ChoiceList::answerWanted, &course_, &app::Course::showAnswer);
    connect(&course_, &app::Course::changed, this, &LessonPanel::showPage);
    connect(back_, &QPushButton::clicked, this, [this] { turn(-1); });
    connect(next_, &QPushButton::clicked, this, [this] { turn(1); });
    connect(skip_, &QPushButton::clicked, this, [this] {
        course_.skip();
        focusNext();
    });
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
    if (practice_.isOn())
        showPractice();
}

QWidget* LessonPanel::makeReader()
{
    auto* reader = new QWidget;
    auto* column = new QVBoxLayout(reader);
    column->setSpacing(space::betweenGroups);
    column->addLayout(makeHead());
    column->addWidget(makeBody(), 1);
    column->addWidget(ending_);
    column->addWidget(repeat_, 0, Qt::AlignLeft);
    column->addLayout(makeFoot());
    return reader;
}

QLayout* LessonPanel::makeHead()
{
    QToolButton* const all = linkToLessons();
    connect(all, &QToolButton::clicked, this, &LessonPanel::showList);
    place_->setToolTip(Text::tr("Questions that you answered right at the first try, and how many "
                                "of them pass the lesson"));
    QToolButton* const page =
        iconButton("export", Text::tr("Export this lesson as a web page, with its questions"));
    page->setObjectName(QStringLiteral("export-lesson-button"));
    connect(page, &QToolButton::clicked, this, &LessonPanel::exportWanted);
    auto* head = pageHead(*place_, *all, *title_);
    static_cast<QHBoxLayout*>(head->itemAt(0)->layout())->addWidget(page);
    head->setContentsMargins(0, 0, scrollGap, 0);
    return head;
}

/// The text with the question below; scrolls if there is too little room.
QWidget* LessonPanel::makeBody()
{
    wearFont(*ending_, pageType::text, QFont::DemiBold);
    for (QLabel* label : {text_, told_, ending_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setAlignment(Qt::AlignTop);
    }
    auto* inner = new QWidget;
    auto* column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, scrollGap, 0); // distance from the scroll bar
    column->setSpacing(space::betweenGroups);
    column->addWidget(picture_);
    column->addWidget(text_);
    column->addWidget(again_, 0, Qt::AlignLeft);
    column->addWidget(choices_);
    column->addWidget(told_);
    column->addStretch();
    makePageBody(*body_, *inner);
    return body_;
}

QLayout* LessonPanel::makeFoot()
{
    auto* foot = pageFoot(*dots_, *count_, {back_, skip_, next_});
    foot->setContentsMargins(0, 0, scrollGap, 0);
    return foot;
}

void LessonPanel::showList()
{
    if (practice_.isOn())
        practice_.atEnd() ? practice_.end() : practice_.pause();
    else
        course_.atEnd() ? course_.end() : course_.pause();
    list_->focusOnLesson();
}

void LessonPanel::refreshList() { list_->refresh(); }

void LessonPanel::showOpened(std::optional<std::size_t> lesson)
{
    showList();
    list_->refresh();
    list_->focusOnLesson(lesson);
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
    else if (const auto after = app::lessonAfter(course_.lessonIndex()))
        course_.begin(*after);
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

/// The attempt, or without one the lessons.
void LessonPanel::showPractice()
{
    if (!practice_.isOn() || practice_.isPaused())
        return showPage();
    const QWidget* focus = QApplication::focusWidget();
    const bool here = focus && isAncestorOf(focus); // also on the list
    practicePage_->showAttempt();
    setCurrentWidget(practicePage_);
    setFocusProxy(practicePage_);
    const bool stays = practice_.atEnd() && here && focus->isVisible(); // among the wrong moves
    if (here && !stays)
        practicePage_->focusNext();
}

void LessonPanel::showPage()
{
    if (practice_.isOn() && !practice_.isPaused())
        return;
    const bool reads = course_.lesson() && !course_.isPaused();
    const QWidget* focus = QApplication::focusWidget();
    const bool answers = focus && choices_->isAncestorOf(focus); // whose buttons are made anew
    setCurrentIndex(reads ? 1 : 0);
    list_->refresh();
    if (!reads) {
        setFocusProxy(list_->buttonOf(course_.lessonToGoOn().value_or(0)));
        return;
    }
    showHead();
    if (course_.answer().wrong == 0
        && course_.answer().tries.empty()) // a new page, not another try
        body_->verticalScrollBar()->setValue(0);
    picture_->show(course_.lesson()->pages[course_.page()].picture);
    text_->setText(richText(course_.text()));
    choices_->show(course_);
    told_->setText(richText(course_.told()));
    told_->setVisible(!course_.told().isEmpty());
    showEnding();
    showFoot();
    setFocusProxy(nextInHand());
    if (answers)
        focusNext();
}

/// The lesson's number, what was right at the first try and how much passes, and its title.
void LessonPanel::showHead()
{
    const app::Lesson& lesson = *course_.lesson();
    const app::Score score = course_.score();
    place_->setText(Text::tr("Lesson %1 · %2 of %3 right, %4 pass")
                        .arg(app::placeOfLesson(course_.lessonIndex()))
                        .arg(score.right)
                        .arg(app::questionsOf(lesson))
                        .arg(app::neededRight(lesson)));
    if (score.settled > 0) {
        QSettings settings;
        app::keepRight(settings, lesson, score.right);
    }
    title_->setText(course_.lesson()->title);
}

/// The place in the lesson, and the buttons that turn the pages.
void LessonPanel::showFoot()
{
    const bool open = course_.isOpen();
    dots_->show(course_.page(), course_.pages());
    count_->setText(Text::tr("%1 of %2").arg(course_.page() + 1).arg(course_.pages()));
    again_->setVisible(course_.isAway());
    back_->setVisible(course_.page() > 0);
    skip_->setEnabled(open);
    skip_->setVisible(!course_.atEnd());
    next_->setEnabled(!open);
    next_->setToolTip(open ? Text::tr("First answer the question, or choose “Skip”")
                           : Text::tr("Next page (Page Down)"));
    const bool last = !app::lessonAfter(course_.lessonIndex());
    next_->setText(!course_.atEnd() ? Text::tr("Next")
                   : last           ? Text::tr("Finish")
                                    : Text::tr("Next lesson"));
}

/// Shows the ending below the text, where it is visible without scrolling.
void LessonPanel::showEnding()
{
    ending_->setText(course_.ending());
    ending_->setVisible(!ending_->text().isEmpty());
    repeat_->setVisible(ending_->isVisibleTo(this)
                        && !app::isPassed(course_.score().right, *course_.lesson()));
}

void LessonPanel::changeEvent(QEvent* event)
{
    QStackedWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        practice_.isOn() ? showPractice() : showPage();
}

void LessonPanel::resizeEvent(QResizeEvent* event)
{
    QStackedWidget::resizeEvent(event);
    const int side = width() < usualWidth - wideMargin ? narrowMargin : wideMargin;
    const double type = std::max(1.0, QFontInfo(font()).pixelSize() / usualType);
    dots_->setVisible(width() >= widthWithDots * type);
    reader_->layout()->setContentsMargins(side, side, side - scrollGap, side / 2);
}

QSize LessonPanel::sizeHint() const { return {usualWidth, 600}; }
QSize LessonPanel::minimumSizeHint() const { return {leastWidth, 200}; }

} // namespace ui

#include "moc_lesson_panel.cpp"
