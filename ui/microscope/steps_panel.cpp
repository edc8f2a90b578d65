// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/steps_panel.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/microscope/legend.h"
#include "ui/microscope/timeline.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/heading.h"

#include <QAccessible>
#include <QVBoxLayout>

#include <array>

namespace ui {

namespace {

constexpr int margin = 16, sentenceLines = 2;
constexpr std::array speeds{0.5, 1.0, 2.0, 4.0};
enum Button { First, Previous, Play, Next, Last };

QString speedText(double speed)
{
    return Text::tr("%1\u00d7").arg(app::numberText(speed, speed < 1 ? 1 : 0));
}

QFont sentenceFont(const QFont& body)
{
    QFont font = body;
    if (body.pixelSize() > 0)
        font.setPixelSize(qRound(body.pixelSize() * 1.3));
    else
        font.setPointSizeF(body.pointSizeF() * 1.3);
    return font;
}

} // namespace

StepsPanel::StepsPanel(app::Microscope& microscope, QWidget* parent)
    : QWidget(parent), microscope_(microscope), playback_(microscope), sentence_(new QLabel),
      count_(new QLabel),
      keys_(new QLabel(Text::tr("Left, Right: step. Space: play. Home, End: jump."))),
      speed_(new QComboBox), timeline_(new Timeline(microscope)), legend_(new Legend),
      foot_(new QWidget)
{
    setBackgroundRole(QPalette::AlternateBase);
    setAutoFillBackground(true);
    sentence_->setFont(sentenceFont(font()));
    sentence_->setWordWrap(true);
    sentence_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    sentence_->setMinimumHeight(sentenceLines * QFontMetrics(sentence_->font()).lineSpacing());
    count_->setAccessibleName(Text::tr("Step"));
    count_->setTextFormat(Qt::RichText);
    keys_->setFont(captionFont(font()));
    keys_->setForegroundRole(QPalette::PlaceholderText);
    addButton("first", Text::tr("First step"), Text::tr("Home"));
    addButton("step-back", Text::tr("Previous step"), Text::tr("Left"));
    addButton("play", Text::tr("Play"), Text::tr("Space"));
    addButton("step-on", Text::tr("Next step"), Text::tr("Right"));
    addButton("last", Text::tr("Last step"), Text::tr("End"));
    addSpeeds();
    layOut();
    constexpr std::size_t end = -1;
    connect(buttons_[First], &QToolButton::clicked, this, [this] { microscope_.goTo(0); });
    connect(buttons_[Previous], &QToolButton::clicked, this, [this] { microscope_.previous(); });
    connect(buttons_[Play], &QToolButton::clicked, &playback_, &Playback::toggle);
    connect(buttons_[Next], &QToolButton::clicked, this, [this] { microscope_.next(); });
    connect(buttons_[Last], &QToolButton::clicked, this, [this] { microscope_.goTo(end); });
    connect(&playback_, &Playback::playingChanged, this, &StepsPanel::showPlaying);
    connect(&microscope, &app::Microscope::stepChanged, this, &StepsPanel::showStep);
    connect(&microscope, &app::Microscope::tracedLineChanged, this, &StepsPanel::showStep);
    showStep();
}

QToolButton* StepsPanel::addButton(const char* key, const QString& name, const QString& shortcut)
{
    auto* button = new QToolButton;
    button->setIcon(icon(key));
    button->setIconSize({18, 18});
    button->setAutoRaise(true);
    button->setFixedSize(space::toolButton + 2, space::toolButton + 2);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    button->setToolTip(Text::tr("%1 (%2)").arg(name, shortcut));
    buttons_ << button;
    return button;
}

void StepsPanel::addSpeeds()
{
    for (const double speed : speeds)
        speed_->addItem(speedText(speed), speed);
    new LanguageFollower(*this, [this] {
        for (int i = 0; i < speed_->count(); ++i)
            speed_->setItemText(i, speedText(speed_->itemData(i).toDouble()));
    });
    speed_->setCurrentIndex(1);
    speed_->setFocusPolicy(Qt::TabFocus);
    speed_->setAccessibleName(Text::tr("Speed"));
    speed_->setToolTip(Text::tr("How fast the steps are played"));
    connect(speed_, &QComboBox::currentIndexChanged, this,
            [this](int index) { playback_.setSpeed(speeds[std::size_t(index)]); });
}

void StepsPanel::layOut()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (QToolButton* button : buttons_)
        row->addWidget(button);
    row->addSpacing(space::labelToField);
    row->addWidget(speed_);
    row->addSpacing(space::labelToField);
    row->addWidget(count_);
    row->addWidget(timeline_, 1);
    auto* foot = new QHBoxLayout(foot_);
    foot->setContentsMargins(0, 0, 0, 0);
    foot->addWidget(legend_);
    foot->addStretch();
    foot->addWidget(keys_);
    auto* body = new QVBoxLayout;
    body->setContentsMargins(margin, 6, margin, 6);
    body->setSpacing(4);
    body->addWidget(sentence_, 1);
    body->addLayout(row);
    body->addWidget(foot_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new Heading(Text::tr("Steps")));
    column->addLayout(body, 1);
}

void StepsPanel::showStep()
{
    const app::Narration& narration = microscope_.narration();
    const app::NarratedStep* narrated = microscope_.narrated();
    const bool any = narrated != nullptr;
    const QString before = sentence_->text();
    const bool covered = microscope_.isCovered();
    sentence_->setText(any       ? narrated->sentence
                       : covered ? Text::tr("The steps are covered until you answer the question.")
                                 : narration.refusal);
    const QString total = app::countText(narration.steps.size());
    const QString now = app::countText(microscope_.step() + 1);
    count_->setText(any && covered ? Text::tr("step <b>%1</b>").arg(now)
                    : any          ? Text::tr("<b>%1</b> of %2").arg(now, total)
                    : covered      ? QString()
                                   : Text::tr("no steps"));
    // Wide enough for the longest text, so that nothing moves while stepping.
    count_->setMinimumWidth(fontMetrics().horizontalAdvance(Text::tr("%1 of %1").arg(total)) + 10);
    const bool start = microscope_.step() == 0, end = microscope_.atEnd();
    for (const int button : {First, Previous})
        buttons_[button]->setEnabled(any && !start);
    for (const int button : {Next, Last})
        buttons_[button]->setEnabled(any && !end);
    buttons_[Play]->setEnabled(any && !(covered && end));
    speed_->setEnabled(any);
    legend_->show(narration);
    sentence_->setAccessibleName(sentence_->text());
    if (sentence_->text() != before && isVisible()) {
        QAccessibleEvent told(sentence_, QAccessible::NameChanged);
        QAccessible::updateAccessibility(&told);
    }
}

void StepsPanel::showPlaying()
{
    const bool playing = playback_.playing();
    const QString name = playing ? Text::tr("Pause") : Text::tr("Play");
    buttons_[Play]->setIcon(icon(playing ? "pause" : "play"));
    buttons_[Play]->setAccessibleName(name);
    buttons_[Play]->setToolTip(Text::tr("%1 (%2)").arg(name, Text::tr("Space")));
}

int StepsPanel::heightWithoutLegend() const
{
    const int title = std::max(space::dockTitleHeight, fontMetrics().height() + 8);
    return title + sentence_->minimumHeight() + timeline_->sizeHint().height() + 12 + 2 * 4;
}

QSize StepsPanel::minimumSizeHint() const { return {420, heightWithoutLegend()}; }

QSize StepsPanel::sizeHint() const
{
    constexpr int usual = 196;
    return {900, std::max(usual, heightWithoutLegend() + foot_->sizeHint().height() + 4)};
}

void StepsPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    foot_->setVisible(height() >= heightWithoutLegend() + foot_->sizeHint().height() + 4);
    keys_->setVisible(legend_->sizeHint().width() + keys_->sizeHint().width() + 3 * margin
                      <= width());
}

} // namespace ui

#include "moc_steps_panel.cpp"
