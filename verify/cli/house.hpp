#pragma once
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// For each name, the names whose headers its sources may include besides their own.
using Arrows = std::map<std::string, std::set<std::string>>;

/// Which room may include which. A room is one of the folders data, ref, fast and verify, a subject a folder in a room.
const Arrows& room_arrows();

/// For each room, which of its subjects may include which; "" is the room's own folder. house.toml has them.
const std::map<std::string, Arrows>& subject_arrows();

/// The files that differ from a revision in git, and new files, in the work tree that holds the current folder. Paths
/// are from the top of the tree. BadInput naming "since" if git does not know the revision, or there is no such tree.
std::vector<std::string> changed_files(const std::string& revision);

/// The subjects of the catalogue whose quantities depend on the files according to house.toml, and "contacts" if whole
/// contacts depend on them.
std::set<std::string> touched_subjects(const std::vector<std::string>& files);

}  // namespace nipref::verify
