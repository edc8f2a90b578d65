// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_list.h"

#include "app/lessons/lesson.h"
#include "ui/look.h"
#include "ui/look_icon.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

namespace {

const QString doneKey = QStringLiteral("lessons/done");
constexpr int margin = 10, mark = 16;

/// One lesson: its number and title, below it what it is about, and a tick.
class LessonButton : public QAbstractButton {
public:
    LessonButton(int number, const app::Lesson& lesson) : key_(lesson.key), summary_(lesson.summary)
    {
        setText(QStringLiteral("%1  %2").arg(number).arg(lesson.title));
        setAccessibleName(text());
        setAccessibleDescription(summary_);
        setFocusPolicy(Qt::StrongFocus);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        setAttribute(Qt::WA_Hover);
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
        painter.setPen(hasFocus() ? QPen(look.selection, 2) : QPen(look.border));
        painter.setBrush(underMouse() || isDown() ? look.hover : look.base);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), space::radius,
                                space::radius);
        const QRect inner = rect().adjusted(margin, margin, -margin, -margin);
        painter.setPen(look.text);
        painter.setFont(semiBold(font()));
        painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, text());
        painter.setFont(captionFont(font()));
        painter.setPen(look.muted);
        painter.drawText(summaryRect(width()), Qt::TextWordWrap, summary_);
        if (isDone(key_))
            ui::icon("tick").paint(&painter, QRect(inner.right() - mark, inner.top(), mark, mark));
    }
    void resizeEvent(QResizeEvent*) override { updateGeometry(); }

private:
    QRect summaryRect(int width) const
    {
        const QRect room(margin, margin + fontMetrics().height() + 2, width - 2 * margin, 1000);
        return QFontMetrics(captionFont(font())).boundingRect(room, Qt::TextWordWrap, summary_);
    }
    QString key_, summary_;
};

} // namespace

bool isDone(const QString& lesson)
{
    return QSettings().value(doneKey).toStringList().contains(lesson);
}

void setDone(const QString& lesson)
{
    QStringList done = QSettings().value(doneKey).toStringList();
    if (!done.contains(lesson))
        QSettings().setValue(doneKey, done << lesson);
}

LessonList::LessonList(QWidget* parent) : QScrollArea(parent)
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
    auto* title = new QLabel(tr("Lessons"));
    title->setFont(semiBold(font()));
    auto* close = new QToolButton;
    close->setIcon(icon("close"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close the lessons"));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, this, &LessonList::closeWanted);
    head->addWidget(title);
    head->addStretch();
    head->addWidget(close);
    column->addLayout(head);
    auto* about =
        new QLabel(tr("Each takes about ten minutes and asks a few questions. One builds on "
                      "the other, but you may begin anywhere."));
    about->setWordWrap(true);
    about->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(about);
    for (const app::Lesson& lesson : app::lessons()) {
        const int index = int(buttons_.size());
        auto* button = new LessonButton(index + 1, lesson);
        connect(button, &QAbstractButton::clicked, this, [this, index] { emit chosen(index); });
        column->addWidget(button);
        buttons_ << button;
    }
    column->addStretch();
    setWidget(body);
}

void LessonList::refresh()
{
    for (QAbstractButton* button : buttons_)
        button->update();
}

} // namespace ui
