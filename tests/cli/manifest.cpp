// SPDX-License-Identifier: GPL-3.0-or-later
/// The manifest of a whole set of tables, which takes minutes to make from the command line, beside another writer of the folder.
#include "touchstone/table/format.hpp"
#include "verify/files.hpp"
#include "verify/manifest.hpp"

#include <doctest/doctest.h>
#include <stdlib.h> // mkdtemp, of POSIX

#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <string>

using namespace touchstone;
using namespace touchstone::program;
using Json = nlohmann::ordered_json;

namespace {

/// A folder of its own, and tables in it.
class Folder {
public:
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "touchstone-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }
    const std::filesystem::path& path() const { return path_; }
    /// \returns its entry
    Json put(const std::string& file, const std::string& text) const
    {
        write_into_folder(path_, file, text);
        return {{"file", file}, {"sha256", sha256(text)}};
    }
    Json entries() const { return Json::parse(read_file(path_ / manifest_name("txt"))).at("tables"); }

private:
    std::filesystem::path path_;
};

} // namespace

TEST_CASE("the manifest of all tables waits for another writer, and loses none of its entries")
{
    const Folder here;
    const Json a = here.put("a.txt", "1\n"), b = here.put("b.txt", "2\n");
    std::optional<FolderLock> another(std::in_place, here.path());
    auto all = std::async(std::launch::async, [&] { write_manifest_of_all(here.path(), "txt", Json{a, b}); });
    CHECK(all.wait_for(std::chrono::milliseconds(300)) == std::future_status::timeout);
    CHECK_FALSE(std::filesystem::exists(here.path() / manifest_name("txt")));
    const Json mine = here.put("mine.txt", "3\n"), other_b = here.put("b.txt", "4\n");
    here.put(manifest_name("txt"), Json{{"tables", Json{mine, other_b}}}.dump());
    another.reset();
    all.get();
    CHECK(here.entries() == Json{a, other_b, mine});
}

TEST_CASE("two writers of all tables, each of which replaces files of the other, leave the manifest of what is there")
{
    const Folder here;
    for (int round = 0; round < 50; ++round) {
        const auto write = [&](const std::string& whose) {
            Json entries = Json::array();
            for (const char* file : {"a.txt", "b.txt", "c.txt", "d.txt"})
                entries.push_back(here.put(file, whose + file + std::to_string(round)));
            write_manifest_of_all(here.path(), "txt", entries);
        };
        auto one = std::async(std::launch::async, write, "one"), two = std::async(std::launch::async, write, "two");
        one.get();
        two.get();
        const Json entries = here.entries();
        CHECK(entries.size() == 4);
        for (const auto& e : entries)
            CHECK(e.at("sha256") == sha256(read_file(here.path() / e.at("file").get<std::string>())));
    }
}

TEST_CASE("what is no more as its entry says is left out, and an unreadable manifest replaced")
{
    const Folder here;
    const Json a = here.put("a.txt", "1\n"), old = here.put("old.txt", "2\n"), gone = here.put("gone.txt", "3\n");
    here.put("old.txt", "4\n");
    std::filesystem::remove(here.path() / "gone.txt");
    const Json outside{{"file", "../" + here.path().filename().string() + "/a.txt"}, {"sha256", sha256("1\n")}};
    const Json number{{"file", "a.txt"}, {"sha256", 5}};
    here.put(manifest_name("txt"), Json{{"tables", Json{old, gone, outside, number}}}.dump());
    write_manifest_of_all(here.path(), "txt", Json{a});
    CHECK(here.entries() == Json{a});
    CHECK(read_file(here.path() / manifest_name("txt")) == manifest_of_all(here.path(), "txt", Json{a}));
    for (const char* text : {"", "[1]", "{\"tables\":[{\"file\":5}]}"}) {
        here.put(manifest_name("txt"), text);
        CHECK_THROWS_AS(renew_manifest(here.path(), "txt", Json{a}), CorruptTable);
        write_manifest_of_all(here.path(), "txt", Json{a});
        CHECK(here.entries() == Json{a});
    }
}
