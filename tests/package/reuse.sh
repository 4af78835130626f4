#!/bin/sh
# SPDX-License-Identifier: MIT
# A compiler's launcher: takes the object that the build in BUILD has made, where a static library is made of the same as
# the shared one.  That is so of all rooms but api, which says what is exported.
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
