// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/cut_options.h"

#include "app/base/numbers.h"
#include "app/settings/remembered.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSettings>

namespace ui {

namespace {

const QString closeKey = QStringLiteral("closeCutAreas"), hiddenKey = QStringLiteral("cutHidden"),
              leastKey = QStringLiteral("leastPieceMillimetres");

app::CutChoices remembered()
{
    constexpr double most = 1e6;
    return {app::rememberedNumber(closeKey, 0, 1, 0) == 1,
            app::rememberedNumber(hiddenKey, 0, 1, 0) == 1,
            app::rememberedNumber(leastKey, 0.0, most, 0.0)};
}

void remember(const app::CutChoices& choices)
{
    QSettings settings;
    settings.setValue(closeKey, int(choices.closeAreas));
    settings.setValue(hiddenKey, int(choices.cutHidden));
    settings.setValue(leastKey, choices.leastMillimetres);
}

} // namespace

CutOptionsBox::CutOptionsBox(app::Session& session)
    : session_(session),
      close_(makeCheck(
          Text::tr("Close cut areas"),
          Text::tr("Let the stroke of a filled object follow the cut. Otherwise no stroke "
                   "runs along it."),
          &app::CutChoices::closeAreas)),
      hidden_(
          makeCheck(Text::tr("Cut hidden objects"),
                    Text::tr("Crop, cut out and split hidden objects, too. An export cuts them in "
                             "any case."),
                    &app::CutChoices::cutHidden)),
      least_(new LengthField(Text::tr("Drop pieces below"), LengthField::Range::NotNegative,
                             LengthField::Suffix::Unit))
{
    least_->setObjectName(QStringLiteral("least-piece"));
    least_->setToolTip(
        Text::tr("Shorter pieces of lines that are cut are left out when you crop, cut "
                 "out, split or export. The canvas does not show them as kept."));
    auto* label = new QLabel(Text::tr("Drop pieces below"));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(least_);
    label->setToolTip(least_->toolTip());
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    grid->addWidget(close_, 0, 0);
    grid->addWidget(hidden_, 0, 1, 1, 2);
    grid->addWidget(label, 1, 0);
    grid->addWidget(least_, 1, 1);
    grid->setColumnStretch(2, 1);
    grid->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                             space::dockMargin);
    grid->setRowStretch(2, 1); // behind another tab it may be higher than it needs
    connect(least_, &LengthField::edited, this, [this](double length) {
        app::CutChoices choices = session_.display().cutting;
        choices.leastMillimetres = length * session_.now().page().millimetresPerUnit();
        change(choices);
    });
    connect(least_, &LengthField::entered, this, &CutOptionsBox::entered);
    connect(least_, &LengthField::refused, this, &CutOptionsBox::refused);
    connect(least_, &LengthField::taken, this, &CutOptionsBox::taken);
    connect(&session, &app::Session::displayChanged, this, &CutOptionsBox::follow);
    change(remembered());
    follow();
}

QCheckBox* CutOptionsBox::makeCheck(const QString& text, const QString& tip,
                                    bool app::CutChoices::*choice)
{
    auto* box = new QCheckBox(text);
    box->setToolTip(tip);
    connect(box, &QCheckBox::toggled, this, [this, choice](bool on) {
        app::CutChoices choices = session_.display().cutting;
        choices.*choice = on;
        change(choices);
    });
    return box;
}

void CutOptionsBox::change(const app::CutChoices& choices)
{
    if (choices != remembered())
        remember(choices);
    session_.changeDisplay([&](app::Display& display) { display.cutting = choices; });
}

void CutOptionsBox::follow()
{
    const app::CutChoices& choices = session_.display().cutting;
    close_->setChecked(choices.closeAreas);
    hidden_->setChecked(choices.cutHidden);
    const double unit = session_.now().page().millimetresPerUnit();
    least_->show(choices.leastMillimetres / unit, unitOnPaper(), unit);
    emit titled(title());
}

app::Unit CutOptionsBox::unitOnPaper() const
{
    return session_.now().page().paperUnit(session_.display().unit);
}

QString CutOptionsBox::title() const
{
    const app::CutChoices& choices = session_.display().cutting;
    const double unit = session_.now().page().millimetresPerUnit();
    const QString areas = choices.closeAreas ? Text::tr("areas closed") : Text::tr("areas open");
    const QString pieces =
        choices.leastMillimetres > 0
            ? Text::tr("no piece below %1")
                  .arg(app::lengthText(choices.leastMillimetres / unit, unitOnPaper(), unit))
            : Text::tr("every piece kept");
    return choices.cutHidden ? Text::tr("%1, %2, hidden objects too").arg(areas, pieces)
                             : Text::tr("%1, %2").arg(areas, pieces);
}

} // namespace ui

#include "moc_cut_options.cpp"
