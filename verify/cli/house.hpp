#pragma once
#include <map>
#include <set>
#include <string>

namespace nipref::verify {

/// For each name, the names that its sources may include besides their own.
using Arrows = std::map<std::string, std::set<std::string>>;

/// Which room may include which.
const Arrows& room_arrows();

/// For each room, which of its subjects may include which; "" is the room's own folder. A test compares these arrows
/// with every include and with the tables of the README.
const std::map<std::string, Arrows>& subject_arrows();

}  // namespace nipref::verify
