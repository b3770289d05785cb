# Sums the bytes of a linker map by the part that they come from: "<part> <flash> <ram>" a line.
function hex(text,   value, i) {
  value = 0
  for (i = 3; i <= length(text); ++i) value = value * 16 + index("0123456789abcdef", substr(text, i, 1)) - 1
  return value
}
function part(file) {
  if (match(file, /libscrubjay_[a-z]+\.a/)) return substr(file, RSTART + 12, RLENGTH - 14)
  if (file ~ /libgcc\.a/) return "libgcc"
  if (file ~ /libm\.a/) return "libm"
  if (file ~ /libc_nano\.a/) return "libc"
  return "image"
}
/^Linker script and memory map/ { on = 1 }
!on { next }
/^[.\/A-Za-z]/ { section = $1; next }
# A long name stands on a line of its own.
/^ [.A-Z][^ ]*$/ { getline; $0 = "- " $0 }
$2 ~ /^0x/ && $3 ~ /^0x/ && NF >= 4 {
  size = hex($3)
  if (section == ".text" || section == ".ARM.exidx" || section == ".data") flash[part($4)] += size
  if (section == ".data" || section == ".bss") ram[part($4)] += size
  if (size > 0) parts[part($4)] = 1
}
$1 == "*fill*" && $2 ~ /^0x/ {
  if (section == ".text" || section == ".data") flash["filling"] += hex($3)
  if (section == ".data" || section == ".bss") ram["filling"] += hex($3)
  parts["filling"] = 1
}
END { for (name in parts) print name, flash[name] + 0, ram[name] + 0 }
