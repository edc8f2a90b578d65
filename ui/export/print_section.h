// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/print_job.h"
#include "ui/export/export_section.h"

class QCheckBox;
class QSpinBox;

namespace ui {

class Segments;
class ToolList;

/// The paper that a drawing is printed on, and how it is divided if it is larger.
class PrintSection : public ExportSection {
    Q_OBJECT

public:
    /// Begins with the paper that was chosen last, or else with that of the page.
    explicit PrintSection(const app::Page& page, QWidget* parent = nullptr);

    const app::PrintChoice& choice() const { return choice_; } ///< its area does not count
    void showDivided(bool divided); ///< whether what is about several sheets counts

signals:
    void changed();

private:
    void take();

    app::PrintChoice choice_;
    ToolList* paper_;
    Segments* turn_;
    QSpinBox *overlap_, *margin_;
    QCheckBox* marks_;
    std::vector<Row> ofSeveral_;
};

} // namespace ui
