// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/marks_section.h"

#include "ui/look/text.h"

#include <QCheckBox>

namespace ui {

MarksSection::MarksSection(app::LiveSheets& sheets, QWidget* parent)
    : Section(Text::tr("Marks"), parent), sheets_(sheets)
{
    add(Text::tr("Registration marks"), "registration-marks", &app::SheetMarks::registration);
    add(Text::tr("Sheet labels"), "sheet-labels", &app::SheetMarks::labels);
    add(Text::tr("Crop lines at the corners"), "crop-lines", &app::SheetMarks::cropLines);
    boxes_[0].first->setToolTip(
        Text::tr("Crosses at the same points of the drawing on neighbouring "
                 "sheets: lay one over the other"));
    boxes_[1].first->setToolTip(
        Text::tr("Name, row and column of the sheet, and the size of all sheets "
                 "together"));
    boxes_[2].first->setToolTip(Text::tr("Lines along which a sheet is cut"));
    connect(&sheets, &app::LiveSheets::changed, this, &MarksSection::follow);
    connect(&sheets, &app::LiveSheets::openChanged, this, &MarksSection::follow);
    follow();
}

void MarksSection::add(const QString& text, const char* name, bool app::SheetMarks::*member)
{
    auto* box = new QCheckBox(text);
    box->setObjectName(QLatin1StringView(name));
    addWide(box);
    boxes_.emplace_back(box, member);
    connect(box, &QCheckBox::clicked, this, [this, member](bool checked) {
        app::SheetSettings next = sheets_.settings();
        next.plan.marks.*member = checked;
        if (const auto refusal = sheets_.change(std::move(next)))
            emit refused(*refusal);
        else
            emit taken();
        follow();
    });
}

void MarksSection::follow()
{
    for (const auto& [box, member] : boxes_)
        box->setChecked(sheets_.settings().plan.marks.*member);
}

} // namespace ui

#include "moc_marks_section.cpp"
