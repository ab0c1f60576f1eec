#include "reports/files/file_buffer.hpp"

#include <unistd.h>

#include <cerrno>

namespace ff::reports {

FileBuffer::FileBuffer(int descriptor) : descriptor_(descriptor) {
    setp(bytes_.data(), bytes_.data() + bytes_.size());
}

bool FileBuffer::write_out() {
    for (const char* next = pbase(); error_ == 0 && next < pptr();) {
        const auto written = ::write(descriptor_, next, static_cast<std::size_t>(pptr() - next));
        if (written >= 0)
            next += written;
        else if (errno != EINTR)
            error_ = errno;
    }
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return error_ == 0;
}

FileBuffer::int_type FileBuffer::overflow(int_type next) {
    if (!write_out()) return traits_type::eof();
    if (!traits_type::eq_int_type(next, traits_type::eof())) sputc(traits_type::to_char_type(next));
    return traits_type::not_eof(next);
}

int FileBuffer::sync() {
    return write_out() ? 0 : -1;
}

}  // namespace ff::reports
