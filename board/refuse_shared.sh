# refuse_shared.sh -- a function for scripts that run as root and write into a folder of BUILD. Source the file.
# shellcheck shell=bash

# Refuses folders that other users can write. Root writes files with predictable names there, and a link in place of such
# a file would let the other user overwrite any file. Prints one line that begins with SCRIPT, and returns 1.
refuse_shared() { # SCRIPT FOLDER...
    local script=$1 folder owner
    shift
    for folder; do
        owner=$(stat -c %u "$folder")
        if [ "$owner" -ne 0 ] && [ "$owner" -ne "${SUDO_UID:-0}" ] || [ -n "$(find "$folder" -maxdepth 0 -perm /002)" ]; then
            echo "$script: $folder: other users may write there; BUILD= names another folder" >&2
            return 1
        fi
    done
}
