// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/colour_choice.h"

#include "app/document/styles_in_use.h"
#include "app/session/recent_colours.h"
#include "app/view/colour_chart.h"
#include "ui/canvas/eyedropper.h"
#include "ui/look/text.h"
#include "ui/widgets/colour_popup.h"

namespace ui {

ColourChoice::ColourChoice(app::Session& session, Canvas& canvas, app::PaintPart part)
    : session_(session), canvas_(canvas), part_(part), popup_(new ColourPopup(this))
{
    setAutoRaise(true);
    setIconSize({16, 16});
    setPart(part);
    connect(this, &QToolButton::clicked, this, &ColourChoice::open);
    connect(popup_, &ColourPopup::picked, this, &ColourChoice::choose);
    connect(popup_, &ColourPopup::eyedropperWanted, this, &ColourChoice::startEyedropper);
    connect(&session, &app::Session::selectionChanged, this, &ColourChoice::follow);
    connect(&session, &app::Session::displayChanged, this, &ColourChoice::follow);
    connect(&session.document, &app::EditedDocument::changed, this, &ColourChoice::follow,
            Qt::QueuedConnection); // the selection may not be updated yet
}

void ColourChoice::setPart(app::PaintPart part)
{
    part_ = part;
    const QString name =
        part == &app::Style::stroke ? Text::tr("Stroke colour") : Text::tr("Fill colour");
    setToolTip(name);
    setAccessibleName(name);
    follow();
}

void ColourChoice::setSwatch(Swatch form)
{
    swatch_ = form;
    follow();
}

void ColourChoice::showEvent(QShowEvent* event)
{
    QToolButton::showEvent(event);
    follow();
}

std::optional<std::optional<app::Colour>> ColourChoice::now() const
{
    return app::common(app::shownStyles(session_), part_);
}

/// Asks nothing while it is hidden: there may be a million selected objects.
void ColourChoice::follow()
{
    if (!isVisible())
        return;
    const auto colour = now();
    setIcon(colour ? swatchIcon(*colour, swatch_) : mixedSwatchIcon());
    setText(!colour ? Text::tr("mixed") : *colour ? app::hexText(**colour) : Text::tr("none"));
}

void ColourChoice::open()
{
    constexpr std::size_t rows = 2;
    const app::Objects& objects = session_.now().objects();
    popup_->open(*this, {app::coloursInUse(objects, rows * app::coloursInRow),
                         app::recentColours(QSettings()), now()});
}

void ColourChoice::choose(const std::optional<app::Colour>& colour)
{
    if (const auto refusal = app::setColour(session_, part_, colour)) {
        emit session_.refused(*refusal);
        return;
    }
    if (colour) {
        QSettings settings;
        app::rememberColour(settings, *colour);
    }
    canvas_.setFocus();
}

void ColourChoice::startEyedropper()
{
    emit eyedropperStarted(); // popups close, which take all events
    const QPointer<ColourChoice> self = this;
    Eyedropper::start(canvas_, session_, [self, part = part_](const app::Colour& colour) {
        if (!self)
            return;
        const app::PaintPart shown = self->part_;
        self->part_ = part;
        self->choose(colour);
        self->part_ = shown;
    });
}

} // namespace ui

#include "moc_colour_choice.cpp"
