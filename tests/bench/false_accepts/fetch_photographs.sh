#!/usr/bin/env bash
# Pictures without tags for false_accepts, from Debian's packages: desktop backgrounds, WebP turned
# into PNG in FOLDER, and the drawings of the Open Clip Art Library.
#   fetch_photographs.sh FOLDER     (as root: installs packages)
# afterwards:
#   false_accepts FOLDER /usr/share/backgrounds /usr/share/wallpapers
#   false_accepts /usr/share/openclipart/png
set -euo pipefail
folder=${1:?usage: fetch_photographs.sh FOLDER}
packages=(gnome-backgrounds mate-backgrounds plasma-workspace-wallpapers lomiri-wallpapers-16.04
          lomiri-wallpapers-20.04 ukui-wallpapers sway-backgrounds)
apt-get install -y --no-install-recommends webp openclipart-png "${packages[@]}"
mkdir -p "$folder"
dpkg -L "${packages[@]}" | grep '\.webp$' | while read -r file; do
  [ -L "$file" ] || dwebp -quiet "$file" -o "$folder/$(basename "$file" .webp).png"
done
