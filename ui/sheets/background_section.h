// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sheets/page_section.h"

class QCheckBox;

namespace ui {

class ColourPopup;
class Segments;

/// The background of the page, and whether files have it, too.
class BackgroundSection : public PageSection {
    Q_OBJECT

public:
    BackgroundSection(app::Session& session, app::PageEditing& editing);

    void follow() override;

private:
    void takeColour(const app::Colour& colour);

    Segments* colour_;
    QCheckBox* exported_;
    ColourPopup* colours_;
};

} // namespace ui
