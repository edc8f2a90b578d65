// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/area_section.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/window_words.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/tool_list.h"

#include <QRadioButton>
#include <QSignalBlocker>

namespace ui {

namespace {

constexpr int widthOfList = 150; // pixels

ToolList* list(const QString& name, const char* key)
{
    auto* made = new ToolList;
    made->setAccessibleName(name);
    made->setObjectName(QString::fromLatin1(key));
    made->setFixedWidth(widthOfList);
    return made;
}

/// Shows rows with their data, and chooses the one with this data.
void fill(ToolList& list, const std::vector<std::pair<QString, qulonglong>>& rows, qulonglong now)
{
    const QSignalBlocker quiet(list);
    list.clear();
    for (const auto& [text, data] : rows)
        list.addItem(text, data);
    list.setCurrentIndex(std::max(0, list.findData(now)));
}

} // namespace

AreaSection::AreaSection(app::Session& session, app::LiveExport& live, QWidget* parent)
    : ExportSection(Text::tr("Area"), parent), session_(session), live_(live),
      windows_(list(Text::tr("Clip window to export"), "export-window")),
      layers_(list(Text::tr("Layer to export"), "export-layer"))
{
    for (const app::ExportPartInfo& info : app::exportParts())
        addArea(info);
    connect(&group_, &QButtonGroup::idClicked, this,
            [this](int id) { take(areaOf(app::ExportPart(id))); });
    connect(windows_, &QComboBox::activated, this,
            [this] { take(areaOf(app::ExportPart::Window)); });
    connect(layers_, &QComboBox::activated, this, [this] { take(areaOf(app::ExportPart::Layer)); });
}

void AreaSection::addArea(const app::ExportPartInfo& info)
{
    auto* button = new QRadioButton(Text::tr(info.name));
    button->setObjectName(QStringLiteral("export-") + app::latin(info.key));
    button->setToolTip(Text::tr(info.what));
    group_.addButton(button, int(info.part));
    const int row = grid().rowCount();
    grid().addWidget(button, row, 0);
    ToolList* list = info.part == app::ExportPart::Window  ? windows_
                     : info.part == app::ExportPart::Layer ? layers_
                                                           : nullptr;
    remarks_.push_back(list ? nullptr : quietLabel({}));
    grid().addWidget(list ? static_cast<QWidget*>(list) : remarks_.back(), row, 1, Qt::AlignRight);
}

app::ExportArea AreaSection::areaOf(app::ExportPart part) const
{
    return {part, std::size_t(windows_->currentData().toULongLong()),
            app::ContainerId(layers_->currentData().toULongLong())};
}

void AreaSection::take(app::ExportArea area)
{
    app::ExportChoice choice = live_.choice();
    choice.area = area;
    live_.change(std::move(choice));
}

QString AreaSection::remarkOf(const app::ExportPartInfo& info) const
{
    const app::Page& page = session_.now().page();
    const QString fault = live_.faultOf(areaOf(info.part));
    if (!fault.isEmpty())
        return fault;
    if (info.part == app::ExportPart::Cut)
        return Text::tr("what the windows keep");
    if (info.part == app::ExportPart::Page)
        return app::sizeText(page.size, page.paperUnit(session_.display().unit),
                             page.millimetresPerUnit());
    const std::size_t objects = session_.selection().size();
    return objects == 1 ? Text::tr("1 object")
                        : Text::tr("%1 objects").arg(app::countText(objects));
}

void AreaSection::fillWindows()
{
    std::vector<std::pair<QString, qulonglong>> rows;
    for (const app::ClipWindow& window : session_.now().windows().list)
        rows.emplace_back(app::nameOf(window), rows.size());
    fill(*windows_, rows, live_.choice().area.window);
}

void AreaSection::fillLayers()
{
    const app::Containers& tree = session_.now().containers();
    std::vector<std::pair<QString, qulonglong>> rows;
    for (const app::ContainerId id : tree.inOrder())
        if (tree[id].kind == app::Container::Kind::Layer)
            rows.emplace(rows.begin(), tree[id].name, id); // drawn on top = above in the list
    fill(*layers_, rows, live_.choice().area.layer);
}

void AreaSection::follow()
{
    fillWindows();
    fillLayers();
    const app::ExportPart now = live_.job().choice.area.part;
    for (const app::ExportPartInfo& info : app::exportParts()) {
        const QString fault = live_.faultOf(areaOf(info.part));
        auto* button = group_.button(int(info.part));
        // Another layer can be chosen where this one is empty.
        button->setEnabled(fault.isEmpty());
        button->setChecked(info.part == now);
        button->setToolTip(fault.isEmpty() ? Text::tr(info.what)
                                           : Text::tr("Not possible: %1").arg(fault));
        if (QLabel* remark = remarks_[std::size_t(info.part)])
            remark->setText(remarkOf(info));
    }
    windows_->setEnabled(windows_->count() > 0);
}

} // namespace ui

#include "moc_area_section.cpp"
