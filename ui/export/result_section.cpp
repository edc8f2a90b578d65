// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/result_section.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"

#include <QLocale>

namespace ui {

namespace {

constexpr int patience = 100;  // milliseconds
constexpr double metre = 1000; // millimetres

QString drawnText(double millimetres)
{
    return millimetres < metre ? Text::tr("%1 mm").arg(app::numberText(millimetres, 2))
                               : Text::tr("%1 m").arg(app::numberText(millimetres / metre, 2));
}

QString pathsText(const app::ExportFacts& facts, std::size_t all)
{
    const QString layers = facts.layers == 1
                               ? Text::tr("on 1 layer")
                               : Text::tr("on %1 layers").arg(app::countText(facts.layers));
    return facts.paths == all ? Text::tr("<b>%1</b>, %2").arg(app::countText(facts.paths), layers)
                              : Text::tr("<b>%1</b> of %2, %3")
                                    .arg(app::countText(facts.paths), app::countText(all), layers);
}

QString bold(const QString& text) { return QStringLiteral("<b>%1</b>").arg(text); }

} // namespace

ResultSection::ResultSection(app::Session& session, app::LiveExport& live, QWidget* parent)
    : ExportSection(Text::tr("Result"), parent), session_(session), live_(live),
      paths_(addFact(Text::tr("Paths"), "export-paths")),
      length_(addFact(Text::tr("Drawn length"), "export-length")),
      size_(addFact(Text::tr("Size on paper"), "export-size")), pixels_(new QLabel), file_(nullptr),
      losses_(new LookLabel), error_(new LookLabel)
{
    pixels_->setTextFormat(Qt::RichText);
    pixels_->setObjectName(QStringLiteral("export-pixels"));
    pixelsRow_ = addRow(Text::tr("Picture"), {pixels_});
    file_ = addFact(Text::tr("File"), "export-bytes");
    for (LookLabel* label : {losses_, error_}) {
        label->setWordWrap(true);
        grid().addWidget(label, grid().rowCount(), 0, 1, 2);
    }
    losses_->setColour([](const Look& look) { return look.warning; });
    losses_->setObjectName(QStringLiteral("export-losses"));
    error_->setColour(errorColour);
    error_->setObjectName(QStringLiteral("export-error"));
    patience_.setSingleShot(true);
    patience_.setInterval(patience);
    connect(&patience_, &QTimer::timeout, this, [this] {
        late_ = true;
        follow();
    });
}

QLabel* ResultSection::addFact(const QString& name, const char* key)
{
    auto* label = new QLabel;
    label->setTextFormat(Qt::RichText);
    label->setObjectName(QString::fromLatin1(key));
    addRow(name, {label});
    return label;
}

void ResultSection::follow()
{
    const bool working = live_.making() || live_.counting();
    if (!working) {
        patience_.stop();
        late_ = false;
    } else if (!late_ && !patience_.isActive())
        patience_.start();
    if (!live_.making() || late_)
        showFacts();
    const bool counts = live_.bytes().has_value();
    if (counts || late_ || !live_.error().isEmpty())
        file_->setText(
            counts ? bold(locale().formattedDataSize(*live_.bytes(), 1, QLocale::DataSizeSIFormat))
            : working ? Text::tr("working…")
                      : QString());
    showLosses();
}

void ResultSection::showFacts()
{
    const bool waits = live_.making();
    const auto& made = live_.made();
    const auto put = [&](QLabel& label, const QString& text) {
        label.setText(waits ? Text::tr("working…") : made ? text : QString());
    };
    const app::ExportFacts facts = made ? made->facts : app::ExportFacts();
    put(*paths_, pathsText(facts, session_.now().objects().size()));
    put(*length_, bold(drawnText(facts.length)));
    put(*size_, bold(app::sizeText(facts.paper, app::Unit::Mm, 1)) + realSizeText(facts));
    put(*pixels_,
        bold(Text::tr("%1 × %2 pixels")
                 .arg(app::numberText(facts.pixels.x, 0), app::numberText(facts.pixels.y, 0))));
    pixelsRow_.setVisible(app::formatOf(live_.choice()).takes.dpi);
}

/// DXF has real lengths, which are others at a scale: "8 × 6.2 m in the file".
QString ResultSection::realSizeText(const app::ExportFacts& facts) const
{
    const app::Page& page = session_.now().page();
    if (!app::formatOf(live_.choice()).takes.dxf || page.scale.ratio == 1)
        return {};
    return QStringLiteral("<br>")
           + Text::tr("<b>%1</b> in the file, which has real lengths")
                 .arg(app::sizeText(facts.paper * page.scale.ratio, page.usualUnit(), 1));
}

void ResultSection::showLosses()
{
    const bool shown = !live_.making() && live_.made();
    const QStringList losses = shown ? live_.made()->drawing.losses : QStringList();
    losses_->setText(losses.join(u'\n'));
    losses_->setVisible(!losses.isEmpty());
    error_->setText(live_.error());
    error_->setVisible(!live_.error().isEmpty());
}

} // namespace ui

#include "moc_result_section.cpp"
