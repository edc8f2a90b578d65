// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/background_section.h"

#include "app/session/recent_colours.h"
#include "ui/look/text.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QSettings>

namespace ui {
namespace {

constexpr app::Colour white{255, 255, 255}, nothing{255, 255, 255, 0};
enum Ground : std::uint8_t { White, None, Own };

Ground groundKind(const app::Colour& colour)
{
    return colour.alpha == 0 ? None : colour == white ? White : Own;
}

} // namespace

BackgroundSection::BackgroundSection(app::Session& session, app::PageEditing& editing)
    : PageSection(Text::tr("Background"), session, editing),
      colour_(new Segments(Text::tr("Background"),
                           {Text::tr("White"), Text::tr("None"), Text::tr("Colour…")})),
      exported_(new QCheckBox(Text::tr("Export the background"))), colours_(new ColourPopup(this))
{
    colour_->setObjectName(QStringLiteral("page-background"));
    colour_->setTips({Text::tr("White paper"), Text::tr("Nothing is behind the drawing"),
                      Text::tr("Paper of another colour")});
    exported_->setObjectName(QStringLiteral("export-background"));
    exported_->setToolTip(
        Text::tr("Pictures and PDF files have it, too, unless another one is chosen in Export. "
                 "It is not printed."));
    colours_->hideEyedropper();
    auto* row = addRow();
    row->addWidget(colour_);
    row->addStretch();
    addRow()->addWidget(exported_);
    connect(colour_, &Segments::picked, this, [this](int chosen) {
        if (chosen != Own)
            return takeColour(chosen == White ? white : nothing);
        follow(); // until a colour is picked
        colours_->open(*colour_, {{}, app::recentColours(QSettings()), page().background.colour});
    });
    connect(colours_, &ColourPopup::picked, this, [this](const std::optional<app::Colour>& colour) {
        takeColour(colour.value_or(nothing));
    });
    connect(exported_, &QCheckBox::clicked, this, [this](bool on) {
        app::Page next = page();
        next.background.exported = on;
        take(app::Result<app::Page>::of(std::move(next)), *exported_);
    });
    follow();
}

void BackgroundSection::takeColour(const app::Colour& colour)
{
    app::Page next = page();
    next.background.colour = colour;
    take(app::Result<app::Page>::of(std::move(next)), *colour_);
}

void BackgroundSection::follow()
{
    colour_->choose(groundKind(page().background.colour));
    exported_->setChecked(page().background.exported);
}

} // namespace ui

#include "moc_background_section.cpp"
