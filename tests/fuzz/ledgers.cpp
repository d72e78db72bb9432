// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/own/own_ledger.hpp"
#include "tests/fuzz/expect.hpp"
#include "tests/fuzz/targets.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace touchstone::fuzz {

void ledgers(std::string_view text)
{
    if (text.size() > 4000) return;
    static const std::string folder = "/tmp/touchstone-fuzz-" + std::to_string(::getpid());
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/ledger.json", std::ios::binary) << text;
    try {
        const proofs::OwnLedger ledger = proofs::load_ledger(folder);
        expect(!ledger.entries.empty(), "a ledger has entries");
    }
    catch (const proofs::OwnLedgerError& e) {
        expect(std::string_view(e.what()).find(folder) != std::string_view::npos, "the message names the file");
    }
    std::filesystem::remove_all(folder);
}

} // namespace touchstone::fuzz
