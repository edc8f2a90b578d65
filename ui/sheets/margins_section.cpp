// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/margins_section.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QPainter>

namespace ui {
namespace {

constexpr int marginWidth = 64; // pixels

struct MarginSide {
    const char* key;
    double app::PaperMargins::*member;
    int row, column;
};
constexpr std::array marginSides{MarginSide{"page-left", &app::PaperMargins::left, 1, 0},
                                 MarginSide{"page-top", &app::PaperMargins::top, 0, 1},
                                 MarginSide{"page-right", &app::PaperMargins::right, 1, 2},
                                 MarginSide{"page-bottom", &app::PaperMargins::bottom, 2, 1}};

/// The dashed rectangle between the four fields.
class MarginPicture : public QWidget {
public:
    MarginPicture() { setFixedSize(marginWidth, space::fieldHeight); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setPen(QPen(lookOf(palette()).guide, 1, Qt::DashLine));
        painter.drawRect(rect().adjusted(2, 2, -3, -3));
    }
};

} // namespace

MarginsSection::MarginsSection(app::Session& session, app::PageEditing& editing)
    : PageSection(Text::tr("Margins"), session, editing),
      shown_(new QCheckBox(Text::tr("Show margins"))),
      same_(new QCheckBox(Text::tr("All the same"))), unit_(quietLabel({}))
{
    auto* grid = new QGridLayout;
    grid->setSpacing(5);
    const std::array names{Text::tr("Left margin"), Text::tr("Top margin"),
                           Text::tr("Right margin"), Text::tr("Bottom margin")};
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        auto* field =
            new LengthField(names[i], LengthField::Range::NotNegative, LengthField::Suffix::None);
        sides_[i] = field;
        field->setFixedWidth(marginWidth);
        field->setObjectName(QLatin1StringView(marginSides[i].key));
        field->setToolTip(names[i]);
        grid->addWidget(field, marginSides[i].row, marginSides[i].column);
        listen(*field);
        connect(field, &LengthField::edited, this,
                [this, i](double millimetres) { takeSide(i, millimetres); });
    }
    grid->addWidget(new MarginPicture, 1, 1);
    shown_->setObjectName(QStringLiteral("show-margins"));
    same_->setObjectName(QStringLiteral("same-margins"));
    same_->setChecked(page().margins.same());
    auto* beside = new QVBoxLayout;
    for (QWidget* part : std::initializer_list<QWidget*>{shown_, same_, unit_})
        beside->addWidget(part);
    auto* row = addRow();
    row->addLayout(grid);
    row->addStretch();
    row->addLayout(beside);
    connect(shown_, &QCheckBox::clicked, this, [this](bool on) {
        app::Page next = page();
        next.margins.shown = on;
        take(app::Result<app::Page>::of(std::move(next)), *shown_);
    });
    connect(same_, &QCheckBox::clicked, this, [this](bool on) {
        if (on)
            takeSide(0, page().margins.left);
    });
    follow();
}

void MarginsSection::takeSide(std::size_t side, double millimetres)
{
    app::PaperMargins margins = page().margins;
    margins.*marginSides[side].member = millimetres;
    if (same_->isChecked())
        for (const MarginSide& each : marginSides)
            margins.*each.member = millimetres;
    take(app::withMargins(page(), margins), *sides_[side]);
}

void MarginsSection::follow()
{
    const app::PaperMargins& margins = page().margins;
    for (std::size_t i = 0; i < sides_.size(); ++i)
        fill(*sides_[i], margins.*marginSides[i].member, paperUnit());
    shown_->setChecked(margins.shown);
    if (!margins.same())
        same_->setChecked(false);
    unit_->setText(Text::tr("paper, %1").arg(app::latin(app::infoOf(paperUnit()).suffix)));
}

} // namespace ui

#include "moc_margins_section.cpp"
