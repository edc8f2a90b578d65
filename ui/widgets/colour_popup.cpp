// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/colour_popup.h"

#include "app/session/recent_colours.h"
#include "app/view/colour_chart.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/swatches.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr int rowsOfDrawing = 2, rowsOfChart = 5;

QString hint()
{
    return Text::tr(
        "Six hexadecimal digits, or a name such as teal. Two more digits make it transparent.");
}

} // namespace

ColourPopup::ColourPopup(QWidget* parent)
    : Popup(Text::tr("Colours"), parent), field_(new QLineEdit), sentence_(new LookLabel)
{
    setObjectName(QStringLiteral("colour-popup"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::labelToField);
    column->setSpacing(2);
    column->setSizeConstraint(QLayout::SetFixedSize);
    inDrawing_ = addSwatches(Text::tr("In this drawing"), rowsOfDrawing);
    recent_ = addSwatches(Text::tr("Recent colours"), 1);
    chart_ = addSwatches(Text::tr("All colours"), rowsOfChart);
    chart_->setColours(app::colourChart());
    addField();
}

Swatches* ColourPopup::addSwatches(const QString& name, int rows)
{
    auto* caption = new QLabel(name);
    caption->setFont(captionFont(font()));
    caption->setForegroundRole(QPalette::PlaceholderText);
    layout()->addWidget(caption);
    auto* swatches = new Swatches(name, app::coloursInRow, rows);
    layout()->addWidget(swatches);
    captions_[swatches] = caption;
    connect(swatches, &Swatches::picked, this, [this](const app::Colour& colour) { pick(colour); });
    return swatches;
}

void ColourPopup::addField()
{
    field_->setAccessibleName(Text::tr("Colour as digits or name"));
    field_->setFixedHeight(space::fieldHeight);
    field_->setMaxLength(60);
    connect(field_, &QLineEdit::textEdited, this, [this] { say(hint(), false); });
    auto* none = new QToolButton;
    none->setObjectName(QStringLiteral("no-colour"));
    none->setText(Text::tr("None"));
    none->setIconSize({16, 16});
    none->setIcon(swatchIcon(std::nullopt));
    none->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    none->setFixedHeight(space::fieldHeight);
    none->setProperty("framed", true);
    none->setFocusPolicy(Qt::StrongFocus);
    none->setToolTip(Text::tr("No colour"));
    connect(none, &QToolButton::clicked, this, [this] { pick(std::nullopt); });
    eyedropper_ = new QToolButton;
    eyedropper_->setObjectName(QStringLiteral("eyedropper"));
    eyedropper_->setIcon(icon("eyedropper"));
    eyedropper_->setFixedSize(space::fieldHeight, space::fieldHeight);
    eyedropper_->setAutoRaise(true);
    eyedropper_->setFocusPolicy(Qt::StrongFocus);
    eyedropper_->setToolTip(Text::tr("Take the colour of a line in the drawing"));
    eyedropper_->setAccessibleName(eyedropper_->toolTip());
    connect(eyedropper_, &QToolButton::clicked, this, [this] {
        close();
        emit eyedropperWanted();
    });
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, space::labelToField, 0, 0);
    row->addWidget(field_, 1);
    row->addWidget(none);
    row->addWidget(eyedropper_);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    sentence_->setFont(captionFont(font()));
    sentence_->setWordWrap(true);
    sentence_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    sentence_->setFixedSize(chart_->sizeHint().width(),
                            2 * QFontMetrics(sentence_->font()).lineSpacing() + 2);
    layout()->addWidget(sentence_);
}

void ColourPopup::hideEyedropper() { eyedropper_->hide(); }

void ColourPopup::say(const QString& sentence, bool isError)
{
    sentence_->setText(sentence);
    sentence_->setColour(isError ? &Look::warning : &Look::muted);
}

void ColourPopup::open(const QWidget& below, const ColourOffer& offer)
{
    constexpr int inRow = app::coloursInRow;
    inDrawing_->setRows(
        std::clamp((int(offer.inDrawing.size()) + inRow - 1) / inRow, 1, rowsOfDrawing));
    inDrawing_->setColours(offer.inDrawing);
    recent_->setColours(offer.recent);
    for (Swatches* swatches : {inDrawing_, recent_}) {
        swatches->setVisible(!swatches->colours().empty());
        captions_[swatches]->setVisible(!swatches->colours().empty());
    }
    const auto now = offer.now.value_or(std::nullopt);
    for (Swatches* swatches : {inDrawing_, recent_, chart_})
        swatches->mark(now);
    field_->setText(now ? app::hexText(*now) : QString());
    field_->setPlaceholderText(offer.now ? Text::tr("none") : Text::tr("mixed"));
    say(hint(), false);
    openBelow(below);
    Swatches* const first = now && !inDrawing_->has(*now) && chart_->has(*now) ? chart_
                            : offer.inDrawing.empty()                          ? chart_
                                                                               : inDrawing_;
    first->setFocus(Qt::PopupFocusReason);
}

void ColourPopup::pick(const std::optional<app::Colour>& colour)
{
    close();
    emit picked(colour);
}

void ColourPopup::accept()
{
    if (field_->text().trimmed().isEmpty())
        return close(), void();
    const auto colour = app::typedColour(field_->text());
    if (colour)
        return pick(*colour.value);
    say(colour.error, true);
    field_->selectAll();
}

void ColourPopup::keyPressEvent(QKeyEvent* event)
{
    const QString text = event->text();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        auto* button = qobject_cast<QToolButton*>(focusWidget());
        button ? button->click() : accept();
    } else if (!field_->hasFocus() && !text.isEmpty() && text[0].isPrint() && !text[0].isSpace()) {
        field_->setFocus();
        field_->setText(text);
        say(hint(), false);
    } else {
        Popup::keyPressEvent(event);
    }
}

} // namespace ui

#include "moc_colour_popup.cpp"
