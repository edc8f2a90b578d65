// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object.h"

namespace app {

const Shared<Particulars>& noParticulars()
{
    static const Shared<Particulars> none;
    return none;
}

} // namespace app
