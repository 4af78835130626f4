#!/bin/sh
# SPDX-License-Identifier: MIT
# A compiler launcher that copies an object from BUILD instead of compiling it. The static library uses the same objects
# as the shared one, except those of the room api, which sets the exported names.
#
#   reuse.sh BUILD COMPILER ARGUMENT...
build=$1
shift
object='' depends='' before=''
for word; do
  case $before in
    -o) object=$word ;;
    -MF) depends=$word ;;
  esac
  before=$word
done
case $object in
  *src/CMakeFiles/hrbfnpr_api.dir/*) ;;
  *src/CMakeFiles/hrbfnpr_*.cpp.o | *src/CMakeFiles/hrbfnpr_*.cxx.o)
    built=$build/src/CMakeFiles/${object##*src/CMakeFiles/}
    if [ -f "$built" ] && cp "$built" "$object"; then
      [ -z "$depends" ] || echo "$object:" >"$depends"
      exit 0
    fi
    ;;
esac
exec "$@"
