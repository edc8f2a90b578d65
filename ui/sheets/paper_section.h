// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/page_section.h"

namespace ui {

class Segments;

/// Size and orientation of the paper.
class PaperSection : public PageSection {
    Q_OBJECT

public:
    PaperSection(app::Session& session, app::PageEditing& editing);

    void follow() override;

private:
    void addNames();
    void addSides();
    void addFits();
    void takeNamed(std::string_view name, QWidget& field);
    void takeSide(int axis, double millimetres);

    Segments *iso_, *american_, *turn_;
    std::array<LengthField*, 2> sides_;
    QLabel* unit_;
};

} // namespace ui
