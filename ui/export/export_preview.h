// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_view.h"

namespace ui {

class Segments;

/// What stands in the place of the drawing while an export is chosen: the preview, and a bar above
/// it that says how large it is shown.
class ExportPreview : public QWidget {
    Q_OBJECT

public:
    ExportPreview(app::Session& session, std::shared_ptr<app::LiveExport> live,
                  QWidget* parent = nullptr);

    ExportView& view() { return *view_; }

signals:
    void closeWanted(); ///< Esc
    void entered();     ///< Enter

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    Segments* size_;
    ExportView* view_;
};

} // namespace ui
