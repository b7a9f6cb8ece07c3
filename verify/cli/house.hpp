#pragma once
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// For each name, the names that its sources may include besides their own.
using Arrows = std::map<std::string, std::set<std::string>>;

/// Which room may include which.
const Arrows& room_arrows();

/// For each room, which of its subjects may include which; "" is the room's own folder. house.toml has them.
const std::map<std::string, Arrows>& subject_arrows();

/// Paths from the top of the tree of what differs from a revision of git's, new files too, in the tree that holds the
/// current folder. BadInput naming "since" if git does not know the revision, or there is no such tree.
std::vector<std::string> changed_files(const std::string& revision);

/// The subjects of the catalogue whose quantities the files have a part in, by the arrows of the house; "contacts"
/// where whole contacts are computed from them.
std::set<std::string> touched_subjects(const std::vector<std::string>& files);

}  // namespace nipref::verify
