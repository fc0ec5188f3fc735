#include "geometry/mesh_format/text_stream.hpp"

#include <cerrno>
#include <system_error>

namespace searle::geometry {
namespace {

constexpr std::size_t buffer_size = 1 << 20;

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw std::filesystem::filesystem_error(
        "the mesh cannot be written", path,
        std::error_code(errno == 0 ? EIO : errno, std::generic_category()));
}

} // namespace

TextStream::TextStream(const std::filesystem::path& file) : path_{file} {
    errno = 0;
    file_ = std::fopen(file.c_str(), "wb");
    if (file_ == nullptr)
        fail(path_);
    buffer_.reserve(buffer_size);
}

TextStream::~TextStream() {
    if (file_ != nullptr)
        std::fclose(file_);
}

TextStream& TextStream::operator<<(std::string_view text) {
    if (buffer_.size() + text.size() > buffer_size)
        flush();
    if (text.size() > buffer_size) {
        errno = 0;
        if (std::fwrite(text.data(), 1, text.size(), file_) != text.size())
            fail(path_);
        return *this;
    }
    buffer_ += text;
    return *this;
}

TextStream& TextStream::operator<<(char letter) { return *this << std::string_view{&letter, 1}; }

void TextStream::flush() {
    errno = 0;
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size())
        fail(path_);
    buffer_.clear();
}

void TextStream::close() {
    flush();
    errno = 0;
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0)
        fail(path_);
}

} // namespace searle::geometry
