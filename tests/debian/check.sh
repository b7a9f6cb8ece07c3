#!/usr/bin/env bash
# Checks the Debian packages of a build for /usr in a clean Debian 12: they install, work, and serve a stranger's
# project. Packages that are made again are identical. Needs root, debootstrap and a network.
#   check.sh BUILD_FOLDER
set -euo pipefail
build=$(cd "$1" && pwd)
tests=$(cd "$(dirname "$0")/.." && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

for folder in packages again; do
  (cd "$build" && cpack -B "$room/$folder" >"$room/$folder.log") || { cat "$room/$folder.log"; exit 1; }
done
for package in "$room"/packages/*.deb; do
  cmp "$package" "$room/again/${package##*/}"
done

# The mirror of this machine's own packages.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1)
debian=$room/debian
debootstrap --variant=minbase bookworm "$debian" "${mirror:-http://deb.debian.org/debian}" >"$room/debootstrap.log" ||
  { cat "$room/debootstrap.log"; exit 1; }
cp "$room"/packages/*.deb "$debian/tmp"
cp -r "$tests/consumer" "$debian/tmp"
chroot "$debian" bash -euxo pipefail -s <<'END'
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
cd /tmp
apt-get install -qq --yes --no-install-recommends ./nipref_*.deb >log 2>&1 || { cat log; exit 1; }
nipref --version
nipref eval I1 alpha=0.73
nipref solve thick-full-friction
apt-get install -qq --yes --no-install-recommends ./libnipref-dev_*.deb cmake g++ make >log 2>&1 || { cat log; exit 1; }
apt-get install -qq --yes --no-install-recommends ./python3-nipref_*.deb >log 2>&1 || { cat log; exit 1; }
python3 -c 'import nipref; print(nipref.eval("I1", alpha=0.73), nipref.solve("thick-frictionless")["contact_length"])'
for project in consumer consumer/kernel_check; do
  cmake -S $project -B build/$project >log
  cmake --build build/$project >>log 2>&1 || { cat log; exit 1; }
  [ $project = consumer ] || nipref grade build/$project/libmylib.so --symbol sign_kernel --quantity I2 --points 500 \
    --baseline build/$project/baseline.toml --update-baseline
  ctest --test-dir build/$project --output-on-failure
done
END
echo "the packages install and serve"
