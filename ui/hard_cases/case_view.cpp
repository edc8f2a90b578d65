// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hard_cases/case_view.h"

#include "app/hard_cases/case_use.h"
#include "ui/hard_cases/answer_table.h"
#include "ui/hard_cases/case_picture_view.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr double titleSize = 1.3;

LookLabel* text(Qt::TextInteractionFlags flags = Qt::TextSelectableByMouse)
{
    auto* label = new LookLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(flags);
    return label;
}

} // namespace

CaseView::CaseView(QWidget* parent)
    : QScrollArea(parent), title_(text()), origin_(text(Qt::TextBrowserInteraction)), why_(text()),
      numbers_(text()), expected_(text()), note_(text()), picture_(new CasePictureView),
      microscope_(new QPushButton(Text::tr("Open in &microscope"))),
      draw_(new QPushButton(Text::tr("Open as &drawing"))), table_(new AnswerTable)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setFocusPolicy(Qt::NoFocus);
    QFont large = semiBold(font());
    large.setPointSizeF(large.pointSizeF() * titleSize);
    title_->setFont(large);
    origin_->setTextFormat(Qt::RichText);
    origin_->setOpenExternalLinks(true);
    origin_->setObjectName(QStringLiteral("origin"));
    numbers_->setFont(captionFont(font()));
    expected_->setFont(semiBold(font()));
    expected_->setObjectName(QStringLiteral("expected"));
    note_->setFont(captionFont(font()));
    note_->setForegroundRole(QPalette::PlaceholderText);
    note_->setText(Text::tr("Not to scale: only the order of the coordinates is true."));
    microscope_->setIcon(icon("microscope"));
    microscope_->setAutoDefault(false);
    draw_->setIcon(icon("pencil"));
    draw_->setAutoDefault(false);
    layOut();
    new LanguageFollower(*this, [this] {
        if (hard_)
            show(*hard_);
    });
    connect(table_, &AnswerTable::answerChosen, this, &CaseView::showAnswer);
    connect(microscope_, &QPushButton::clicked, this, [this] {
        if (hard_ && table_->chosen())
            emit microscopeWanted(*hard_, table_->chosen()->variant);
    });
    connect(draw_, &QPushButton::clicked, this, [this] {
        if (hard_ && table_->chosen())
            emit drawingWanted(*hard_, table_->chosen()->variant);
    });
}

void CaseView::layOut()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                               space::dockMargin);
    column->setSpacing(space::labelToField);
    column->addWidget(title_);
    column->addWidget(picture_);
    column->addWidget(note_);
    column->addWidget(facts());
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(space::labelToField);
    buttons->addWidget(microscope_);
    buttons->addWidget(draw_);
    buttons->addStretch();
    column->addLayout(buttons);
    column->addSpacing(space::labelToField);
    column->addWidget(table_);
    column->addStretch();
    setWidget(page);
}

QWidget* CaseView::facts()
{
    auto* all = new QWidget;
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    for (QLabel* label : {why_, numbers_, expected_, origin_})
        column->addWidget(label);
    return all;
}

void CaseView::show(const app::HardCase& hard)
{
    hard_ = &hard;
    title_->setText(hard.title);
    why_->setText(hard.why);
    numbers_->setText(Text::tr("Line from %1. Window from %2.")
                          .arg(app::pieceText(hard.line), app::pieceText(clipping::Segment{
                                                              hard.window.min, hard.window.max})));
    expected_->setText(Text::tr("Exact visible part: %1").arg(app::pieceText(hard.visible)));
    origin_->setText(hard.isOurs()
                         ? Text::tr("This case was made for Clearcut.")
                         : Text::tr("From <a href=\"%1\">%2</a>")
                               .arg(hard.link.toHtmlEscaped(), hard.origin.toHtmlEscaped()));
    origin_->setToolTip(hard.link);
    origin_->setFocusPolicy(hard.isOurs() ? Qt::NoFocus : Qt::StrongFocus); // for the link
    const auto document = app::documentOf(hard);
    draw_->setEnabled(document.value.has_value());
    draw_->setToolTip(document
                          ? Text::tr("Open a new drawing with exactly these numbers. It appears "
                                     "upside down, because y points down in drawings.")
                          : document.error);
    table_->show(hard, app::firstToLookAt(hard));
    ensureVisible(0, 0);
}

void CaseView::showAnswer()
{
    const app::CaseAnswer* answer = table_->chosen();
    if (!hard_ || !answer)
        return;
    picture_->show(*hard_, *answer);
    note_->setVisible(!app::isToScale(*hard_, answer));
    picture_->setAccessibleName(
        Text::tr("%1. %2: %3")
            .arg(hard_->title, app::nameOf(answer->variant), app::answerText(*answer)));
    microscope_->setToolTip(Text::tr("Show this case step by step with %1, the row selected below")
                                .arg(app::nameOf(answer->variant)));
}

} // namespace ui

#include "moc_case_view.cpp"
