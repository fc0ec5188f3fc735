#include "app/picture_file.hpp"

#include "geometry/mesh_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace searle::app {
namespace {

namespace fs = std::filesystem;

void write_text(const std::string& text, const fs::path& file) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
        const int reason = errno == 0 ? EIO : errno;
        std::error_code ignored;
        fs::remove(file, ignored);
        throw fs::filesystem_error("the picture cannot be written", file,
                                   std::error_code(reason, std::generic_category()));
    }
}

} // namespace

void check_picture_ending(const fs::path& file) {
    if (file.extension() != ".svg" && file.extension() != ".png")
        throw geometry::MeshError(
            fmt::format("{}: a picture's name ends in .svg or .png", file.string()));
}

void write_picture(const std::string& svg, const fs::path& file) {
    check_picture_ending(file);
    if (file.extension() == ".svg")
        return write_text(svg, file);
    fs::path source = file;
    source += fmt::format(".part-{}.svg", getpid());
    write_text(svg, source);
    const pid_t child = fork();
    if (child == 0) {
        execlp("rsvg-convert", "rsvg-convert", "--zoom", "1.5", "--output", file.c_str(),
               source.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    fs::remove(source);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw geometry::MeshToolMissing(
            "a .png is drawn by rsvg-convert, which is not here; to get "
            "it: apt-get install librsvg2-bin (.svg needs nothing)");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw geometry::MeshError(fmt::format("rsvg-convert could not write {}", file.string()));
}

} // namespace searle::app
