// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/microscope_bar.h"

#include "app/base/text.h"
#include "ui/look/key_tip.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/microscope/line_field.h"
#include "ui/widgets/algorithm_marker.h"

#include <QEvent>
#include <QPainter>

namespace ui {

MicroscopeBar::MicroscopeBar(app::Microscope& microscope, app::DrawnLine& drawn, QWidget* parent)
    : QWidget(parent), microscope_(microscope), drawn_(drawn), row_(new QHBoxLayout(this)),
      algorithm_(new QComboBox), corrected_(new QRadioButton(Text::tr("corrected"))),
      published_(new QRadioButton(Text::tr("as published"))), line_(new LineField)
{
    row_->setContentsMargins(space::labelToField, 0, space::labelToField, 0);
    row_->setSpacing(4);
    setMinimumHeight(space::optionsHeight);
    setAccessibleName(Text::tr("Microscope"));
    addAlgorithm();
    addLine();
    addEnd();
    connect(&microscope, &app::Microscope::tracedLineChanged, this, &MicroscopeBar::follow);
    connect(&drawn, &app::DrawnLine::refreshed, this, &MicroscopeBar::follow);
    follow();
    arrange(); // or its words would ask for more room than a narrow window has
}

QLabel* MicroscopeBar::addCaption(const QString& text)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setContentsMargins(space::labelToField, 0, 4, 0);
    captions_ << label;
    row_->addWidget(label);
    return label;
}

QToolButton* MicroscopeBar::addButton(const char* key, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(icon(key));
    button->setIconSize({18, 18});
    button->setFixedSize(space::toolButton, space::toolButton);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    button->setToolTip(name);
    row_->addWidget(button);
    return button;
}

void MicroscopeBar::addAlgorithm()
{
    addCaption(Text::tr("Algorithm"));
    algorithm_->setAccessibleName(Text::tr("Algorithm"));
    algorithm_->setFocusPolicy(Qt::TabFocus);
    algorithm_->setIconSize({14, 14});
    algorithm_->setMaxVisibleItems(30);
    algorithm_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    algorithm_->setMinimumContentsLength(12);
    algorithm_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    algorithm_->setMaximumWidth(320);
    for (const clipping::Algorithm& row : clipping::algorithms())
        algorithm_->addItem(
            markerIcon({&row}),
            QStringLiteral("%1  %2").arg(app::latin(row.abbreviation), app::latin(row.name)));
    for (const app::Misprint& misprint : app::misprints())
        algorithm_->addItem(markerIcon(app::variantOf(misprint)), misprint.name);
    row_->addWidget(algorithm_, 4);
    auto* forms = new QWidget;
    auto* row = new QHBoxLayout(forms);
    row->setContentsMargins(space::labelToField, 0, space::labelToField, 0);
    row->setSpacing(10);
    for (QRadioButton* form : {corrected_, published_}) {
        form->setFocusPolicy(Qt::TabFocus);
        row->addWidget(form);
    }
    row_->addWidget(forms);
    connect(algorithm_, &QComboBox::activated, this, [this](int index) {
        const std::size_t rows = clipping::algorithms().size();
        if (std::size_t(index) >= rows)
            return drawn_.choose(app::variantOf(app::misprints()[std::size_t(index) - rows]));
        const auto& chosen = clipping::algorithms()[std::size_t(index)];
        const auto form = microscope_.tracedLine().variant.form;
        drawn_.choose(
            {&chosen, clipping::functionsOf(chosen, form) ? form : clipping::Form::Corrected});
    });
    connect(corrected_, &QRadioButton::clicked, this,
            [this] { choose(clipping::Form::Corrected); });
    connect(published_, &QRadioButton::clicked, this,
            [this] { choose(clipping::Form::Published); });
}

void MicroscopeBar::addLine()
{
    row_->addSpacing(space::labelToField);
    addCaption(Text::tr("Line"));
    line_->setMinimumWidth(150);
    line_->setMaximumWidth(420);
    line_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row_->addWidget(line_, 5);
    QToolButton* swap = addButton("swap", Text::tr("Swap ends"));
    previous_ = addButton("step-back", Text::tr("Previous line of the drawing"));
    next_ = addButton("step-on", Text::tr("Next line of the drawing"));
    setKeyTip(*previous_, Text::tr("Previous line of the drawing ({previous-line})"));
    setKeyTip(*next_, Text::tr("Next line of the drawing ({next-line})"));
    connect(line_, &LineField::typed, this, &MicroscopeBar::setLine);
    connect(line_, &LineField::done, this, &MicroscopeBar::lineDone);
    connect(line_, &LineField::refused, this, &MicroscopeBar::refused);
    connect(swap, &QToolButton::clicked, this, [this] {
        const auto& [a, b] = microscope_.tracedLine().line;
        setLine({b, a});
    });
    connect(previous_, &QToolButton::clicked, this, [this] { drawn_.go(-1); });
    connect(next_, &QToolButton::clicked, this, [this] { drawn_.go(1); });
}

void MicroscopeBar::addEnd()
{
    row_->addStretch(1);
    const auto addFramed = [this](const char* key, const QString& text, const QString& tip) {
        auto* button = new QPushButton(icon(key), text);
        button->setIconSize({16, 16});
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setFocusPolicy(Qt::TabFocus);
        row_->addWidget(button);
        return button;
    };
    export_ = addFramed("export", Text::tr("Export steps…"),
                        Text::tr("Export the steps as pictures or text"));
    close_ = addFramed("close", Text::tr("Close"), Text::tr("Return to the drawing (Esc)"));
    export_->setObjectName(QStringLiteral("export-steps-button"));
    close_->setObjectName(QStringLiteral("close-microscope"));
    connect(export_, &QPushButton::clicked, this, &MicroscopeBar::exportWanted);
    connect(close_, &QPushButton::clicked, this, &MicroscopeBar::closeWanted);
}

void MicroscopeBar::choose(clipping::Form form)
{
    drawn_.choose({microscope_.tracedLine().variant.algorithm, form});
}

void MicroscopeBar::setLine(const clipping::Segment& line)
{
    app::TracedLine tracedLine = microscope_.tracedLine();
    tracedLine.line = line;
    microscope_.setTracedLine(tracedLine);
}

void MicroscopeBar::follow()
{
    const app::TracedLine& tracedLine = microscope_.tracedLine();
    const auto& [algorithm, form, misprint] = tracedLine.variant;
    if (!algorithm)
        return;
    const auto row =
        misprint ? qsizetype(clipping::algorithms().size()) + (misprint - app::misprints().data())
                 : algorithm - clipping::algorithms().data();
    algorithm_->setCurrentIndex(int(row));
    corrected_->setEnabled(!misprint);
    published_->setEnabled(algorithm->published && !misprint);
    published_->setToolTip(misprint ? misprint->whatIsWrong
                           : algorithm->published
                               ? Text::tr("As its authors printed it, faults included")
                               : Text::tr("%1 has no published form, so the corrected form is used")
                                     .arg(app::latin(algorithm->name)));
    corrected_->setToolTip(Text::tr("With the faults of the published form corrected"));
    (form == clipping::Form::Published ? published_ : corrected_)->setChecked(true);
    line_->show(tracedLine.line);
    previous_->setEnabled(drawn_.line().has_value());
    next_->setEnabled(drawn_.line().has_value());
}

/// Drops the captions first, then the buttons' texts.
void MicroscopeBar::arrange()
{
    const double scale = fontMetrics().height() / 16.0;
    const bool words = width() >= 1000 * scale, captions = width() >= 1150 * scale;
    export_->setText(words ? Text::tr("Export steps…") : QString());
    close_->setText(words ? Text::tr("Close") : QString());
    for (QPushButton* button : {export_, close_})
        button->setMinimumWidth(button->sizeHint().width() + 8);
    for (QLabel* caption : captions_)
        caption->setVisible(captions);
}

void MicroscopeBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
    painter.fillRect(0, height() - 1, width(), 1, lookOf(palette()).rule);
}

void MicroscopeBar::resizeEvent(QResizeEvent* event)
{
    arrange();
    QWidget::resizeEvent(event);
}

void MicroscopeBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && close_)
        arrange();
}

} // namespace ui

#include "moc_microscope_bar.cpp"
