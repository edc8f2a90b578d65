// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_export.h"
#include "ui/export/export_section.h"

#include <QButtonGroup>

namespace ui {

class ToolList;

/// What of the drawing is exported. What is not possible is disabled and says why.
class AreaSection : public ExportSection {
    Q_OBJECT

public:
    AreaSection(app::Session& session, app::LiveExport& live, QWidget* parent = nullptr);

    void follow(); ///< the choice, the drawing and the selection

private:
    void addArea(const app::ExportPartInfo& info);
    void take(app::ExportArea area);
    app::ExportArea areaOf(app::ExportPart part) const; ///< with the window and layer of the lists
    QString remarkOf(const app::ExportPartInfo& info) const;
    void fillWindows();
    void fillLayers();

    app::Session& session_;
    app::LiveExport& live_;
    QButtonGroup group_;
    std::vector<QLabel*> remarks_; ///< one for each part; null where a list stands
    ToolList *windows_, *layers_;
};

} // namespace ui
