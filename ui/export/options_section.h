// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_export.h"
#include "ui/export/export_section.h"

class QLineEdit;
class QSpinBox;

namespace ui {

class ColourPopup;
class LookLabel;
class RefusalFrame;
class Segments;

/// What the chosen format can do: its version, kind, projection, paper, resolution, background
/// and decimals.
class OptionsSection : public ExportSection {
    Q_OBJECT

public:
    explicit OptionsSection(app::LiveExport& live, QWidget* parent = nullptr);

    void follow();

private:
    void addVersion();
    void addKind();
    void addProjection();
    void addPaper();
    void addResolution();
    void addBackground();
    void addDecimals();
    template <class Edit>
    void change(const Edit& edit);
    void takeDpi();
    void takeBackground(int chosen);
    void showBackground(const app::Format& format);

    app::LiveExport& live_;
    Segments *version_, *kind_, *projection_, *paper_, *dpis_, *background_;
    QLineEdit* dpi_;
    RefusalFrame* frame_;
    LookLabel* refusal_;
    QSpinBox* decimals_;
    ColourPopup* colours_;
    std::vector<Row> rows_;
};

} // namespace ui
