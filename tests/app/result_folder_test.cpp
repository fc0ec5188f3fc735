#include "app/result_folder.hpp"

#include "app/summary_json.hpp"
#include "tests/app/running.hpp"

#include <functional>

namespace {

namespace fs = std::filesystem;
using searle::app::check_output_place;
using searle::app::Occupant;
using searle::app::OutputPlaceError;
using searle::app::OutputWriteError;
using searle::app::ResultFile;
using searle::app::write_result_folder;
using searle::app::testing::names_in;
using searle::app::testing::TemporaryFolder;
using searle::app::testing::text_of;
using searle::app::testing::write_text;

/// A result folder's files whose table says `content`.
std::vector<ResultFile> results(const std::string& content) {
    searle::app::RunSummary summary;
    summary.files = {"fields/u.txt", "rheogram.csv", "summary.json"};
    return {{"fields/u.txt", "u"},
            {"rheogram.csv", content},
            {"summary.json", searle::app::summary_json(summary)}};
}

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const OutputPlaceError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ResultFolder, appears_with_its_parents_and_nothing_beside_it) {
    const TemporaryFolder folder;
    EXPECT_EQ(check_output_place(folder / "a/b/c", false), Occupant::nothing);
    EXPECT_EQ(names_in(folder.path()), "") << "a check touches nothing";
    write_result_folder(folder / "a/b/c", results("1"), false);
    EXPECT_EQ(names_in(folder / "a/b"), "c");
    EXPECT_EQ(names_in(folder / "a/b/c"), "fields rheogram.csv summary.json");
    EXPECT_EQ(text_of(folder / "a/b/c/rheogram.csv"), "1");
    EXPECT_EQ(text_of(folder / "a/b/c/fields/u.txt"), "u");
}

TEST(ResultFolder, has_the_permissions_that_the_umask_leaves) {
    const TemporaryFolder folder;
    const mode_t before = umask(022);
    write_result_folder(folder / "out", results("1"), false);
    umask(before);
    EXPECT_EQ(fs::status(folder / "out").permissions(), fs::perms(0755));
    EXPECT_EQ(fs::status(folder / "out/rheogram.csv").permissions(), fs::perms(0644));
}

TEST(ResultFolder, results_are_replaced_only_when_asked_and_then_as_a_whole) {
    const TemporaryFolder folder;
    write_result_folder(folder / "out", results("old"), false);
    EXPECT_NE(message_of([&] {
                  write_result_folder(folder / "out", results("new"), false);
              }).find("holds results already; --force replaces them"),
              std::string::npos);
    EXPECT_EQ(text_of(folder / "out/rheogram.csv"), "old");
    EXPECT_EQ(check_output_place(folder / "out", true), Occupant::results);
    std::vector<ResultFile> fewer = results("new");
    fewer.erase(fewer.begin());
    write_result_folder(folder / "out", fewer, true);
    EXPECT_EQ(text_of(folder / "out/rheogram.csv"), "new");
    EXPECT_EQ(names_in(folder / "out"), "rheogram.csv summary.json") << "nothing old is left";
    EXPECT_EQ(names_in(folder.path()), "out");
}

TEST(ResultFolder, files_that_searle_did_not_write_are_never_destroyed) {
    const TemporaryFolder folder;
    write_text(folder / "thesis/chapter.tex", "ten years");
    EXPECT_NE(message_of([&] { check_output_place(folder / "thesis", true); }).find("chapter.tex"),
              std::string::npos);
    write_result_folder(folder / "out", results("1"), false);
    write_text(folder / "out/notes.txt", "mine");
    EXPECT_NE(message_of([&] {
                  write_result_folder(folder / "out", results("2"), true);
              }).find("holds notes.txt, which is not part of a Searle result"),
              std::string::npos);
    EXPECT_EQ(text_of(folder / "out/notes.txt"), "mine");
    EXPECT_EQ(text_of(folder / "out/rheogram.csv"), "1");
    // A summary.json of another program lists nothing of ours.
    write_text(folder / "other/summary.json", R"({"files": ["summary.json"]})");
    EXPECT_NE(message_of([&] { check_output_place(folder / "other", true); }).find("summary.json"),
              std::string::npos);
}

TEST(ResultFolder, a_file_in_its_place_or_on_its_way_is_named) {
    const TemporaryFolder folder;
    write_text(folder / "file", "x");
    EXPECT_NE(message_of([&] { check_output_place(folder / "file", true); }).find("is a file"),
              std::string::npos);
    EXPECT_NE(
        message_of([&] { check_output_place(folder / "file/out", true); }).find("file is a file"),
        std::string::npos);
    fs::create_symlink(folder / "nowhere", folder / "link");
    EXPECT_NE(message_of([&] {
                  check_output_place(folder / "link", true);
              }).find("link to something that does not exist"),
              std::string::npos);
    EXPECT_EQ(text_of(folder / "file"), "x");
    EXPECT_NE(message_of([&] { check_output_place(folder / std::string(300, 'x'), true); }),
              "no error");
}

TEST(ResultFolder, an_empty_folder_and_a_link_to_a_folder_are_filled) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "empty");
    fs::create_directory_symlink("empty", folder / "link");
    EXPECT_EQ(check_output_place(folder / "link/", false), Occupant::empty_folder);
    write_result_folder(folder / "link/", results("1"), false);
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(text_of(folder / "empty/rheogram.csv"), "1");
    EXPECT_EQ(names_in(folder.path()), "empty link");
}

TEST(ResultFolder, the_current_folder_is_filled_where_it_stands) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "here");
    const fs::path before = fs::current_path();
    fs::current_path(folder / "here");
    write_result_folder(".", results("1"), false);
    EXPECT_EQ(names_in("."), "fields rheogram.csv summary.json");
    write_result_folder(".", results("2"), true);
    EXPECT_EQ(text_of("rheogram.csv"), "2");
    EXPECT_EQ(names_in("."), "fields rheogram.csv summary.json");
    fs::current_path(before);
    EXPECT_EQ(names_in(folder.path()), "here");
}

TEST(ResultFolder, a_write_that_fails_leaves_all_as_it_was) {
    // A limit on the size of files stands for a full disk: write(2) fails in the middle of a file.
    const TemporaryFolder folder;
    write_result_folder(folder / "old", results("old"), false);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_result_folder(folder / "a/new", results(std::string(5000, 'x')), false),
                 OutputWriteError);
    EXPECT_THROW(write_result_folder(folder / "old", results(std::string(5000, 'x')), true),
                 OutputWriteError);
    EXPECT_THROW(searle::app::replace_file(folder / "old/rheogram.csv", std::string(5000, 'x')),
                 OutputWriteError);
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(names_in(folder.path()), "old");
    EXPECT_EQ(names_in(folder / "old"), "fields rheogram.csv summary.json");
    EXPECT_EQ(text_of(folder / "old/rheogram.csv"), "old");
}

} // namespace
