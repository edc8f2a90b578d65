// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/options_section.h"

#include "app/base/number.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/recent_colours.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/refusal_frame.h"
#include "ui/widgets/segments.h"

#include <QLineEdit>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr std::array usualDpis{96, 150, 300, 600};
constexpr int mostDecimals = 12;
constexpr app::Colour white{255, 255, 255}, nothing{255, 255, 255, 0};
enum Ground : std::uint8_t { None, White, Own };
enum RowOf : std::uint8_t {
    Version,
    Kind,
    Degrees,
    Paper,
    Resolution,
    Refusal,
    Background,
    Decimals
};

QStringList projectionTexts()
{
    QStringList texts;
    for (const app::ProjectionKind& kind : app::projections())
        texts << kind.name.first(1).toUpper() + kind.name.sliced(1);
    return texts;
}

QStringList dpiTexts()
{
    QStringList texts;
    for (const int dpi : usualDpis)
        texts << QString::number(dpi);
    return texts;
}

Ground groundOf(const std::optional<app::Colour>& background, const app::Format& format)
{
    if (!background)
        return format.takes.dpi ? White : None;
    return background->alpha == 0 ? None : *background == white ? White : Own;
}

} // namespace

OptionsSection::OptionsSection(app::LiveExport& live, QWidget* parent)
    : ExportSection({}, parent), live_(live),
      version_(new Segments(Text::tr("Version"), {Text::tr("R2000"), Text::tr("R12")})),
      kind_(new Segments(Text::tr("Kind"), {Text::tr("Clearcut drawing"), Text::tr("Plain")})),
      projection_(new Segments(Text::tr("Drawn as"), projectionTexts())),
      paper_(new Segments(Text::tr("Paper"), {Text::tr("As the area"), Text::tr("Whole page")})),
      dpis_(new Segments(Text::tr("Resolution"), dpiTexts())),
      background_(new Segments(Text::tr("Background"),
                               {Text::tr("Transparent"), Text::tr("White"), Text::tr("Colour…")})),
      dpi_(new QLineEdit), frame_(new RefusalFrame(*dpi_)), refusal_(new LookLabel),
      decimals_(new QSpinBox), colours_(new ColourPopup(this))
{
    addVersion();
    addKind();
    addProjection();
    addPaper();
    addResolution();
    addBackground();
    addDecimals();
}

template <class Edit>
void OptionsSection::change(const Edit& edit)
{
    app::ExportChoice choice = live_.choice();
    edit(choice);
    live_.change(std::move(choice));
}

void OptionsSection::addVersion()
{
    version_->setObjectName(QStringLiteral("export-dxf"));
    version_->setTips({Text::tr("With curves, all colours and line widths"),
                       Text::tr("For old programs and machines: curves other than arcs become "
                                "lines, colours the nearest of 255, all lines are equally wide")});
    rows_.push_back(addRow(Text::tr("Version"), {version_}));
    connect(version_, &Segments::picked, this, [this](int chosen) {
        change([&](app::ExportChoice& choice) { choice.dxf = app::DxfVersion(chosen); });
    });
}

void OptionsSection::addKind()
{
    kind_->setObjectName(QStringLiteral("export-svg"));
    kind_->setTips({Text::tr("Texts, shapes and layers can be edited again, here and in Inkscape"),
                    Text::tr("Nothing but SVG, for other programs and the web")});
    rows_.push_back(addRow(Text::tr("Kind"), {kind_}));
    connect(kind_, &Segments::picked, this, [this](int chosen) {
        change([&](app::ExportChoice& choice) { choice.plain = chosen == 1; });
    });
}

void OptionsSection::addProjection()
{
    projection_->setObjectName(QStringLiteral("export-projection"));
    projection_->setTips({Text::tr("A user unit of the drawing is a degree"),
                          Text::tr("A user unit is a degree of longitude, and latitudes are "
                                   "stretched, as in maps on the web")});
    rows_.push_back(addRow(Text::tr("Drawn as"), {projection_}));
    connect(projection_, &Segments::picked, this, [this](int chosen) {
        change([&](app::ExportChoice& choice) {
            choice.projection = app::projections()[std::size_t(chosen)].projection;
        });
    });
}

void OptionsSection::addPaper()
{
    paper_->setObjectName(QStringLiteral("export-paper"));
    paper_->setTips({Text::tr("The file is just as large as the area"),
                     Text::tr("The area lies at its place on the page of the drawing")});
    rows_.push_back(addRow(Text::tr("Paper"), {paper_}));
    connect(paper_, &Segments::picked, this, [this](int chosen) {
        change([&](app::ExportChoice& choice) { choice.paper = app::ExportPaper(chosen); });
    });
}

void OptionsSection::addResolution()
{
    dpi_->setObjectName(QStringLiteral("export-dpi"));
    dpi_->setAccessibleName(Text::tr("Resolution in dots per inch"));
    dpi_->setFixedSize(64, space::fieldHeight);
    dpi_->setAlignment(Qt::AlignRight);
    dpis_->setObjectName(QStringLiteral("export-usual-dpi"));
    rows_.push_back(addRow(Text::tr("Resolution"), {dpis_, dpi_, quietLabel(Text::tr("dpi"))}));
    refusal_->setWordWrap(true);
    refusal_->setColour(errorColour);
    refusal_->setObjectName(QStringLiteral("export-refusal"));
    const int row = grid().rowCount();
    auto* noName = new QLabel;
    grid().addWidget(noName, row, 0);
    grid().addWidget(refusal_, row, 1);
    rows_.push_back({noName, refusal_});
    connect(dpis_, &Segments::picked, this, [this](int chosen) {
        dpi_->setModified(false);
        change([&](app::ExportChoice& choice) { choice.dpi = usualDpis[std::size_t(chosen)]; });
    });
    connect(dpi_, &QLineEdit::editingFinished, this, &OptionsSection::takeDpi);
    connect(frame_, &RefusalFrame::typed, this, [this] { rows_[Refusal].setVisible(false); });
}

void OptionsSection::takeDpi()
{
    if (!dpi_->isModified())
        return;
    dpi_->setModified(false);
    const auto typed = app::parseNumber(app::inCLocale(dpi_->text(), locale()).toStdString());
    if (typed && *typed >= app::leastDpi && *typed <= app::mostDpi)
        return change([&](app::ExportChoice& choice) { choice.dpi = *typed; });
    const QString sentence = Text::tr("“%1” is not possible: give 1 to %2 dpi.")
                                 .arg(dpi_->text(), app::countText(std::size_t(app::mostDpi)));
    follow(); // the old number stays
    frame_->show();
    frame_->raise();
    refusal_->setText(sentence);
    rows_[Refusal].setVisible(true);
}

void OptionsSection::addBackground()
{
    background_->setObjectName(QStringLiteral("export-background"));
    colours_->hideEyedropper();
    rows_.push_back(addRow(Text::tr("Background"), {background_}));
    connect(background_, &Segments::picked, this, &OptionsSection::takeBackground);
    connect(colours_, &ColourPopup::picked, this, [this](const std::optional<app::Colour>& colour) {
        change([&](app::ExportChoice& choice) { choice.background = colour.value_or(nothing); });
    });
}

void OptionsSection::takeBackground(int chosen)
{
    if (chosen != Own)
        return change([&](app::ExportChoice& choice) {
            choice.background = chosen == White ? white : nothing;
        });
    follow(); // until a colour is picked
    colours_->open(*background_, {{}, app::recentColours(QSettings()), live_.background()});
}

void OptionsSection::addDecimals()
{
    decimals_->setObjectName(QStringLiteral("export-decimals"));
    decimals_->setAccessibleName(Text::tr("Decimals of coordinates"));
    decimals_->setRange(-1, mostDecimals);
    decimals_->setSpecialValueText(Text::tr("Exact"));
    decimals_->setFixedSize(76, space::fieldHeight);
    decimals_->setToolTip(Text::tr("Exact: as many decimals as it takes to read the same number "
                                   "back. Coordinates never leave the clip window by rounding."));
    rows_.push_back(addRow(Text::tr("Precision"), {decimals_, quietLabel(Text::tr("decimals"))}));
    connect(decimals_, &QSpinBox::valueChanged, this, [this](int decimals) {
        change([&](app::ExportChoice& choice) { choice.precision = decimals; });
    });
}

void OptionsSection::showBackground(const app::Format& format)
{
    background_->choose(groundOf(live_.background(), format));
    background_->setTips({format.takes.dpi ? Text::tr("Nothing behind the drawing")
                                           : Text::tr("Nothing behind the drawing: the paper"),
                          Text::tr("A white page behind the drawing"),
                          Text::tr("A page of another colour behind the drawing")});
}

void OptionsSection::follow()
{
    const app::ExportChoice& choice = live_.choice();
    const app::Format& format = app::formatOf(choice);
    setTitle(format.shortName());
    version_->choose(int(choice.dxf));
    kind_->choose(choice.plain ? 1 : 0);
    projection_->choose(int(&app::kindOf(choice.projection) - app::projections().data()));
    paper_->choose(int(choice.paper));
    const auto usual = std::ranges::find(usualDpis, choice.dpi);
    usual == usualDpis.end() ? dpis_->chooseNone() : dpis_->choose(int(usual - usualDpis.begin()));
    if (!dpi_->isModified() || !dpi_->hasFocus())
        dpi_->setText(app::shortText(choice.dpi));
    showBackground(format);
    const QSignalBlocker quiet(decimals_);
    decimals_->setValue(choice.precision);
    frame_->hide();
    rows_[Version].setVisible(format.takes.dxf);
    rows_[Kind].setVisible(format.takes.plain);
    rows_[Degrees].setVisible(format.takes.projection);
    rows_[Paper].setVisible(format.takes.paper);
    rows_[Resolution].setVisible(format.takes.dpi);
    rows_[Refusal].setVisible(false);
    rows_[Background].setVisible(format.takes.background);
    rows_[Decimals].setVisible(format.takes.precision);
}

} // namespace ui

#include "moc_options_section.cpp"
