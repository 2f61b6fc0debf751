#pragma once

namespace dataflow::sweeps {

/// The page of a sweep without its data: page/sweep.html with style and scripts in place. In the order in which they
/// stand there, `@title@` (twice) and `@data@` are to be replaced.
extern char const* const sweep_page_template;

}  // namespace dataflow::sweeps
