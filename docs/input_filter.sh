#!/bin/sh
# Prints a file as Doxygen reads it: the declarations of src/fmm are in the group fmm, and the text
# that follows @par Accuracy, @par Cost or @par Not for on the same line is not a title. Private
# members are hidden, because Doxygen 1.9 links to a list of private types that it does not write.
folder=$(expr "$1" : '\(.*/src/[a-z_]*\)/.*[.]hpp$')
room=${folder##*/}
grouping=
if [ -e "$folder/$room.dox" ]; then
  grouping="s|^namespace stokesbook\(::study\)\? {\$|& /** @addtogroup $room */ /** @{ */|
            s|^}  // namespace stokesbook\(::study\)\?\$|/** @} */ &|"
fi
exec sed "$grouping
          /^ private:\$/,/^};\$/ {
            s|^ private:\$|& /** @cond */|
            s|^};\$|/** @endcond */ &|
          }
          s/@par Accuracy /@accuracy /; s/@par Cost /@cost /; s/@par Not for /@not_for /" "$1"
