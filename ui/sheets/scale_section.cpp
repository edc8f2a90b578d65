// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/scale_section.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <algorithm>

namespace ui {
namespace {

constexpr std::array<double, 5> usualRatios{1, 20, 50, 100, 500};
constexpr std::array lengthUnits{app::Unit::Metre, app::Unit::Cm, app::Unit::Mm, app::Unit::Inch,
                                 app::Unit::Foot};
constexpr int ratioWidth = 76; // pixels

/// "50", not "50.00".
class RatioField : public LengthField {
public:
    RatioField() : LengthField(Text::tr("Scale 1 :"), Range::NotNegative, Suffix::None) {}

protected:
    QString textFromValue(double value) const override { return app::shortText(value, 8); }
};

QStringList ratioTexts()
{
    QStringList texts;
    for (const double ratio : usualRatios)
        texts << app::shortText(ratio);
    return texts;
}

QStringList unitTexts()
{
    QStringList texts;
    for (const app::Unit unit : lengthUnits)
        texts << app::latin(app::infoOf(unit).suffix);
    return texts;
}

template <class All, class T>
void showIn(Segments& row, const All& all, const T& value)
{
    const auto found = std::ranges::find(all, value);
    found == all.end() ? row.chooseNone() : row.choose(int(found - all.begin()));
}

} // namespace

ScaleSection::ScaleSection(app::Session& session, app::PageEditing& editing)
    : PageSection(Text::tr("Scale of the drawing"), session, editing), ratio_(new RatioField),
      usual_(new Segments(Text::tr("Scale"), ratioTexts())),
      unit_(new Segments(Text::tr("Lengths in"), unitTexts())), meaning_(quietLabel({}))
{
    ratio_->setObjectName(QStringLiteral("page-scale"));
    ratio_->setFixedWidth(ratioWidth);
    usual_->setObjectName(QStringLiteral("page-usual-scales"));
    unit_->setObjectName(QStringLiteral("page-unit"));
    unit_->setTips({Text::tr("Metres"), Text::tr("Centimetres"), Text::tr("Millimetres"),
                    Text::tr("Inches"), Text::tr("Feet")});
    auto* scale = addRow();
    scale->addWidget(new QLabel(Text::tr("1 :")));
    scale->addWidget(ratio_);
    scale->addWidget(usual_);
    scale->addStretch();
    auto* lengths = addRow();
    lengths->addWidget(quietLabel(Text::tr("Lengths in")));
    lengths->addWidget(unit_);
    lengths->addStretch();
    meaning_->setWordWrap(true);
    column().addWidget(meaning_);
    listen(*ratio_);
    connect(ratio_, &LengthField::edited, this,
            [this](double ratio) { take(app::withScale(page(), ratio), *ratio_); });
    connect(usual_, &Segments::picked, this, [this](int number) {
        take(app::withScale(page(), usualRatios[std::size_t(number)]), *usual_);
    });
    connect(unit_, &Segments::picked, this,
            [this](int number) { takeUnit(lengthUnits[std::size_t(number)]); });
    follow();
}

void ScaleSection::takeUnit(app::Unit unit)
{
    app::Page next = page();
    next.scale.unit.reset();
    if (next.usualUnit() != unit)
        next.scale.unit = unit;
    take(app::Result<app::Page>::of(std::move(next)), *unit_);
    // The rulers may have had another unit than the drawing.
    session().changeDisplay([unit](app::Display& display) { display.unit = unit; });
}

void ScaleSection::follow()
{
    const double ratio = page().scale.ratio;
    fill(*ratio_, ratio, app::Unit::User);
    showIn(*usual_, usualRatios, ratio);
    showIn(*unit_, lengthUnits, session().display().unit);
    meaning_->setText(Text::tr("1 mm on paper is %1 mm in the drawing. A new scale changes what "
                               "the page holds; lengths stay as drawn.")
                          .arg(app::shortText(ratio, 8)));
}

} // namespace ui

#include "moc_scale_section.cpp"
