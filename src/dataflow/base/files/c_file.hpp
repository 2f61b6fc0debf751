#pragma once
#include <cstdio>
#include <memory>

namespace dataflow::io {

struct CFileCloser {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file of the C library, closed by who has it last.
using CFile = std::unique_ptr<std::FILE, CFileCloser>;

}  // namespace dataflow::io
