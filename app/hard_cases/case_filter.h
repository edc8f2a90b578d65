// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"

namespace app {

/// Which hard cases are shown.
struct CaseFilter {
    QString words{};               ///< each is somewhere in title, origin or reason; any case
    QString variant{};             ///< a key: it fails there; empty: any
    std::optional<Ruling> fault{}; ///< any variant (or that one) fails in this way

    bool lets(const HardCase& hard) const;
    friend bool operator==(const CaseFilter&, const CaseFilter&) = default;
};

/// Those that it lets through, in the order of the gallery.
std::vector<const HardCase*> casesFor(const CaseFilter& filter);

/// What can be chosen: all cases, those where each published form or exhibit fails, those of each
/// kind of fault. With the name of each and how many there are: "CS as published fails (17)".
struct CaseChoice {
    QString name;
    CaseFilter filter;
};
std::vector<CaseChoice> caseChoices();

} // namespace app
