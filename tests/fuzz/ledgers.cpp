// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_ledger.hpp"
#include "tests/fuzz/expect.hpp"
#include "tests/fuzz/targets.hpp"

#include <string>

namespace touchstone::fuzz {

void ledgers(std::string_view text)
{
    const std::string folder = "/dev/null"; // no folder: no file of a table is there
    try {
        const proofs::OwnLedger ledger = proofs::read_ledger(std::string(text), folder);
        expect(!ledger.entries.empty(), "a ledger has entries");
    }
    catch (const proofs::OwnLedgerError& e) {
        expect(std::string_view(e.what()).find(folder + "/") != std::string_view::npos, "the message names the file");
    }
}

} // namespace touchstone::fuzz
