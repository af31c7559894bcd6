# For kills.sh: damage to parts, and disks that are small or read-only.

# damage FOLDER: of one part, of another file of the folder of parts, or of all
damage() {
  local parts=("$1"/[0-9]*.part) part  # not study.part, which is being written
  [ -e "${parts[0]}" ] || return 0
  part=${parts[RANDOM % ${#parts[@]}]}
  local size
  size=$(stat -c %s "$part" 2> /dev/null) || return 0
  case $((RANDOM % 8)) in
    0) tally "damage part removed" && rm -f "$part" ;;
    1) tally "damage truncated" && truncate -s $((size * (RANDOM % 100) / 100)) "$part" ;;
    2) tally "damage bit" && flip_bit "$part" $(((RANDOM * 32768 + RANDOM) % size)) ;;
    3) tally "damage crashes" && printf '3 1' >> "$1/crashes" ;;
    4) tally "damage torn" && head -c $((size / 2)) "$part" > "$1/00000099.part.part" ;;
    5) tally "damage folder removed" && rm -rf "$1" ;;
    6) tally "damage study" && flip_bit "$1/study" $((RANDOM % 80)) ;;
    7) tally "damage study removed" && rm -f "$1/study" ;;
  esac 2> /dev/null
  return 0
}

flip_bit() {  # FILE OFFSET
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  # shellcheck disable=SC2059
  printf "\\x$(printf %02x $((byte ^ (1 << RANDOM % 8))))" | dd of="$1" bs=1 seek="$2" conv=notrunc
} 2> /dev/null

# A mounted folder where that is allowed, found out once.
can_mount() {
  if [ -z "${mounting:-}" ]; then
    mounting=no
    mkdir -p "$folder/mounted"
    mount -t tmpfs -o size=64k tmpfs "$folder/mounted" 2> /dev/null && umount "$folder/mounted" && mounting=yes
  fi
  [ "$mounting" = yes ]
}

small_disk() {  # in a fifth of the trials this folder is on a disk that is too small
  chance 25 && can_mount || return 1
  mount -t tmpfs -o size=$((RANDOM % 300 + 16))k tmpfs "$PWD" && cd "$PWD" || return 1
}

ample_disk() {
  mountpoint -q "$PWD" || return 0
  mount -o remount,size=16m "$PWD"
}

read_only() {  # ARGUMENTS...: an attempt on a disk that is read-only
  mountpoint -q "$PWD" && mount -o remount,ro "$PWD" || return 0
  tally "limit read-only"
  "$gurney" run "../$job.toml" -o a.h5 --resume "$@" > /dev/null 2>&1
  local code=$?
  mount -o remount,rw "$PWD"
  [ $code -eq 1 ] || complain "exit code $code on a read-only disk"
}

no_disk() {  # FOLDER
  mountpoint -q "$1" && umount "$1"
}
