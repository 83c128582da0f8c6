#!/usr/bin/env bash
# Pictures without tags from Debian's packages: desktop backgrounds, WebP turned into PNG in FOLDER.
#   fetch_photographs.sh FOLDER     (as root: installs packages)
# afterwards:
#   tagmint evaluate false-positives --photographs FOLDER --photographs /usr/share/backgrounds
#       --photographs /usr/share/wallpapers
# With --drawings also the drawings of the Open Clip Art Library, in /usr/share/openclipart/png.
set -euo pipefail
folder=${1:?usage: fetch_photographs.sh FOLDER [--drawings]}
packages=(gnome-backgrounds mate-backgrounds plasma-workspace-wallpapers lomiri-wallpapers-16.04
          lomiri-wallpapers-20.04 ukui-wallpapers sway-backgrounds)
more=()
[ "${2:-}" = "--drawings" ] && more=(openclipart-png)
apt-get install -y --no-install-recommends webp "${more[@]}" "${packages[@]}"
mkdir -p "$folder"
dpkg -L "${packages[@]}" | grep '\.webp$' | while read -r file; do
  [ -L "$file" ] || dwebp -quiet "$file" -o "$folder/$(basename "$file" .webp).png"
done
