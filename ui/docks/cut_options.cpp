// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/cut_options.h"

#include "app/settings/remembered.h"
#include "ui/docks/window_panel.h"
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

CutOptionsBox::CutOptionsBox(app::Session& session, WindowPanel& panel)
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
    grid->addWidget(&panel.tilesButton(), 1, 2, Qt::AlignRight);
    grid->setColumnStretch(2, 1);
    grid->setContentsMargins(space::dockMargin, 0, space::dockMargin, space::dockMargin);
    connect(least_, &LengthField::edited, this, [this](double length) {
        app::CutChoices choices = session_.display().cutting;
        choices.leastMillimetres = length * session_.now().page().millimetresPerUnit();
        change(choices);
    });
    connect(least_, &LengthField::entered, &panel, &WindowPanel::entered);
    connect(least_, &LengthField::refused, &panel, &WindowPanel::refused);
    connect(least_, &LengthField::taken, &panel, &WindowPanel::taken);
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
    least_->show(choices.leastMillimetres / unit, session_.display().unit, unit);
}

QWidget* withCutOptions(WindowPanel& panel, app::Session& session)
{
    auto* both = new QWidget;
    both->setSizePolicy(panel.sizePolicy());
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(&panel);
    column->addWidget(new CutOptionsBox(session, panel));
    return both;
}

} // namespace ui

#include "moc_cut_options.cpp"
