// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QWidget>

class QCheckBox;

namespace ui {

class LengthField;

/// How clip windows cut. The choices are remembered; Crop, Cut out, Split, Export and the canvas
/// follow them.
class CutOptionsBox : public QWidget {
    Q_OBJECT

public:
    explicit CutOptionsBox(app::Session& session);

    QString title() const; ///< the choices in words: "areas open, every piece kept"

signals:
    void titled(const QString& remark);
    void entered(); ///< a length was entered: the focus returns to the canvas
    void refused(const QString& sentence); ///< the typed text is not a length
    void taken();                          ///< the field's value is valid again

private:
    QCheckBox* makeCheck(const QString& text, const QString& tip, bool app::CutChoices::*choice);
    void change(const app::CutChoices& choices);
    void follow();
    app::Unit unitOnPaper() const;

    app::Session& session_;
    QCheckBox *close_, *hidden_;
    LengthField* least_;
};

} // namespace ui
