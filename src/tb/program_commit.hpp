#pragma once
namespace faster {

/// The commit of the sources that this program was built from, as the build found it: 12 digits of its hash, with
/// "-dirty" where files differed from it. Empty: they were no git clone.
extern char const* const program_commit;
extern char const* const program_commit_date;  ///< yyyy-mm-dd

}  // namespace faster
