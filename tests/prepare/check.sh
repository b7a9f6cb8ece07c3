#!/usr/bin/env bash
# Tests .ci/prepare on machines of all kinds. apt, dpkg and the compiler are stand-ins that record their calls.
set -euo pipefail
prepare=$(cd "$(dirname "$0")/../.." && pwd)/.ci/prepare
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
mkdir "$room/bin"
stand_in() { printf '#!/bin/bash\n%s\n' "$2" >"$room/bin/$1" && chmod +x "$room/bin/$1"; }
stand_in dpkg-query '[[ " $INSTALLED " == *" ${!#} "* ]] && echo installed'
stand_in dpkg 'echo "dpkg $*" >>asked'
stand_in id 'if [ "$1" = -u ]; then echo "$USER_ID"; else echo user; fi'
stand_in sudo 'exit 1'
stand_in apt-cache 'printf "libboost1.%s-dev\n" 74 83 81 88'
stand_in g++ 'echo "#define BOOST_VERSION $BOOST"'
stand_in apt-get 'echo "apt-get $*" >>"$ROOM/asked"
case " $* " in
*" update "*) [ "${OFFLINE:-no}" = no ] ;;
*--simulate*) for name in "$@"; do [[ $name != lib* ]] || printf "Inst %s (1)\nInst %s-needs (1)\n" "$name" "$name"; done ;;
*" install "*) [ "$APT_INSTALLS" = yes ] ;;
*download*) touch package.deb ;;
esac'

# Runs get_missing on a machine. Then $asked has the calls of apt and dpkg, $said the output.
on_machine() {
  rm -rf "$room/work" && mkdir "$room/work"
  said=$(cd "$room/work" && env PATH="$room/bin:$PATH" ROOM="$room/work" "$@" bash -euo pipefail -c '. "$0"; get_missing' "$prepare" 2>&1) || said+=" failed"
  asked=$(cat "$room/work/asked" 2>/dev/null || true)
}
status=0
check() {
  if [[ "$2" != $3 ]]; then
    printf '%s: wanted %s in\n%s\n' "$1" "$3" "$2" && status=1
  fi
}
never() {
  if [[ "$2" == $3 ]]; then
    printf '%s: not wanted %s in\n%s\n' "$1" "$3" "$2" && status=1
  fi
}
all=$(. "$prepare" && echo "${tools[*]} ${libraries[*]} ${useful[*]}")

on_machine USER_ID=0 INSTALLED="$all" BOOST=108300 APT_INSTALLS=yes
check "nothing is missing" "$said$asked" ""
on_machine USER_ID=0 INSTALLED="cmake g++ make" BOOST=108300 APT_INSTALLS=yes
check "root installs" "$asked" "*install*--no-remove*libgsl-dev*"
check "root sees the command" "$said" "*+ *apt-get install*--no-remove*"
never "root installs" "$asked" "*download*"
on_machine USER_ID=0 INSTALLED="cmake g++ make" BOOST=108300 APT_INSTALLS=no
check "what cannot be installed is unpacked" "$asked" "*download*libgsl-dev libgsl-dev-needs*dpkg -x*"
on_machine USER_ID=1000 INSTALLED="cmake g++ make" BOOST=108300 APT_INSTALLS=yes
check "no root" "$asked" "*download*libgsl-dev libgsl-dev-needs*dpkg -x*"
never "no root" "$(grep -v simulate <<<"$asked")" "* install *"
on_machine USER_ID=1000 INSTALLED="g++ make" BOOST=108300 APT_INSTALLS=yes
check "no root and no tools" "$said" "Please install these packages first: cmake failed"
on_machine USER_ID=1000 INSTALLED="${all/gnuplot-nox/}" BOOST=108300 APT_INSTALLS=yes
check "no root and no gnuplot" "$said" "Without gnuplot-nox something is left out: README.md says what, under Dependencies"
on_machine USER_ID=0 INSTALLED="$all" BOOST=107400 APT_INSTALLS=yes
check "an old Boost stays" "$asked" "*download libboost1.81-dev*dpkg -x*"
never "an old Boost stays" "$asked" "* install *"
on_machine USER_ID=1000 INSTALLED="cmake g++ make" BOOST=108300 APT_INSTALLS=yes OFFLINE=yes
check "no network" "$said" "*What is missing cannot be downloaded; please install it: *libgsl-dev* failed"
never "no network" "$asked" "*dpkg*"
for machine in 0:yes 0:no 1000:no; do
  on_machine USER_ID=${machine%:*} INSTALLED="" BOOST=107400 APT_INSTALLS="${machine#*:}"
  never "nothing is removed" "$(grep ' install ' <<<"$asked" | grep -v -e --no-remove -e --simulate)" "*install*"
done
exit $status
