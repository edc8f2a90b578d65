// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/paper_section.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/paper.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QPainter>

#include <algorithm>

namespace ui {
namespace {

constexpr std::array<std::string_view, 7> isoNames{"A0", "A1", "A2", "A3", "A4", "A5", "A6"};
constexpr std::array<std::string_view, 3> americanNames{"Letter", "Legal", "Tabloid"};
constexpr int sideWidth = 84; // pixels

QStringList textsOf(std::span<const std::string_view> names)
{
    QStringList texts;
    for (const std::string_view name : names)
        texts << app::latin(name);
    return texts;
}

/// A sheet in the proportions of ISO; larger sizes are larger, but not as much.
QIcon pictureOf(std::size_t size)
{
    return paintedIcon({26, 20}, [size](QPainter& painter, const Look& look) {
        const double width = 24 - 2.3 * double(size);
        QRectF sheet(0, 0, width, width * 0.707);
        sheet.moveCenter({13, 10});
        painter.setPen(QPen(look.text, 1));
        painter.setBrush(look.base);
        painter.drawRect(sheet);
    });
}

/// "A3, 297 × 420 mm".
QStringList tipsOf(std::span<const std::string_view> names)
{
    QStringList tips;
    for (const std::string_view name : names) {
        const app::Point& size = app::paperNamed(name)->millimetres;
        tips << Text::tr("%1, %2 × %3 mm")
                    .arg(app::latin(name), app::shortText(size.x), app::shortText(size.y));
    }
    return tips;
}

/// The number of a name in a row; -1: it is not there.
int indexIn(std::span<const std::string_view> names, const app::NamedPaper* paper)
{
    const auto found = paper ? std::ranges::find(names, paper->name) : names.end();
    return found == names.end() ? -1 : int(found - names.begin());
}

void chooseIn(Segments& row, int number) { number < 0 ? row.chooseNone() : row.choose(number); }

} // namespace

PaperSection::PaperSection(app::Session& session, app::PageEditing& editing)
    : PageSection(Text::tr("Size"), session, editing),
      iso_(new Segments(Text::tr("Paper"), textsOf(isoNames))),
      american_(
          new Segments(Text::tr("Paper"), textsOf(americanNames) << Text::tr("Own", "paper size"))),
      turn_(new Segments(Text::tr("Orientation"), {Text::tr("Portrait"), Text::tr("Landscape")})),
      unit_(quietLabel({}))
{
    const auto side = [](const QString& name) {
        return new LengthField(name, LengthField::Range::NotNegative, LengthField::Suffix::None);
    };
    sides_ = {side(Text::tr("Width of the page")), side(Text::tr("Height of the page"))};
    addNames();
    addSides();
    addFits();
    follow();
}

void PaperSection::addNames()
{
    std::vector<QIcon> pictures;
    for (std::size_t size = 0; size < isoNames.size(); ++size)
        pictures.push_back(pictureOf(size));
    iso_->setPictures(pictures);
    iso_->setTips(tipsOf(isoNames));
    american_->setTips(tipsOf(americanNames) << Text::tr("Type width and height"));
    iso_->setObjectName(QStringLiteral("page-iso"));
    american_->setObjectName(QStringLiteral("page-american"));
    turn_->setObjectName(QStringLiteral("page-orientation"));
    turn_->setIcons({"portrait", "landscape"});
    column().addWidget(iso_);
    auto* row = addRow();
    row->addWidget(american_);
    row->addStretch();
    row->addWidget(turn_);
    connect(iso_, &Segments::picked, this,
            [this](int number) { takeNamed(isoNames[std::size_t(number)], *iso_); });
    connect(american_, &Segments::picked, this, [this](int number) {
        if (std::size_t(number) < americanNames.size())
            return takeNamed(americanNames[std::size_t(number)], *american_);
        sides_[0]->setFocus(); // an own size is typed
        sides_[0]->selectAll();
    });
    connect(turn_, &Segments::picked, this, [this](int landscape) {
        const app::Point size = app::millimetresOf(page());
        if ((size.x > size.y) != (landscape == 1))
            take(app::Result<app::Page>::of(app::turnedPage(page())), *turn_);
    });
}

void PaperSection::addSides()
{
    auto* row = addRow();
    for (const int axis : {0, 1}) {
        LengthField* field = sides_[std::size_t(axis)];
        field->setFixedWidth(sideWidth);
        field->setObjectName(axis == 0 ? QStringLiteral("page-width")
                                       : QStringLiteral("page-height"));
        row->addWidget(quietLabel(axis == 0 ? Text::tr("W") : Text::tr("× H")));
        row->addWidget(field);
        listen(*field);
        connect(field, &LengthField::edited, this,
                [this, axis](double millimetres) { takeSide(axis, millimetres); });
    }
    row->addWidget(unit_);
    row->addStretch();
}

void PaperSection::addFits()
{
    struct Fit {
        const char* key;
        QString text, tip, needs;
        std::optional<clipping::Window> (*box)(const app::Session& session);
    };
    const std::array fits{
        Fit{"page-to-drawing", Text::tr("Page to drawing"),
            Text::tr("Fits the page around everything that is drawn, and adds the margins"),
            Text::tr("Nothing is drawn yet. Draw something first."), app::drawingBox},
        Fit{"page-to-windows", Text::tr("Page to windows"),
            Text::tr("Fits the page around the visible clip windows, and adds the margins"),
            Text::tr("The drawing has no clip window. Draw one first."), app::windowsBox}};
    auto* row = addRow();
    for (const Fit& fit : fits) {
        auto* button = plainButton(fit.text);
        button->setObjectName(QLatin1StringView(fit.key));
        button->setToolTip(fit.tip);
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, button, fit] {
            const auto box = fit.box(session());
            take(box ? app::fittedPage(page(), box) : app::Result<app::Page>::failure(fit.needs),
                 *button);
        });
    }
    row->addStretch();
}

void PaperSection::takeNamed(std::string_view name, QWidget& field)
{
    app::Point size = app::paperNamed(name)->millimetres;
    if (turn_->chosen() == 1)
        std::swap(size.x, size.y);
    take(app::withPaper(page(), size), field);
}

void PaperSection::takeSide(int axis, double millimetres)
{
    app::Point size = app::millimetresOf(page());
    size[axis] = millimetres;
    take(app::withPaper(page(), size), *sides_[std::size_t(axis)]);
}

void PaperSection::follow()
{
    const app::Point size = app::millimetresOf(page());
    const app::NamedPaper* paper = app::namedPaperOf(page());
    const int iso = indexIn(isoNames, paper), american = indexIn(americanNames, paper);
    chooseIn(*iso_, iso);
    chooseIn(*american_, iso < 0 && american < 0 ? int(americanNames.size()) : american);
    turn_->choose(size.x > size.y ? 1 : 0);
    for (const int axis : {0, 1})
        fill(*sides_[std::size_t(axis)], size[axis], paperUnit());
    unit_->setText(app::latin(app::infoOf(paperUnit()).suffix));
}

} // namespace ui

#include "moc_paper_section.cpp"
