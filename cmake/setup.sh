# SPDX-License-Identifier: MIT
# Sourced by ./play and ./check: installs what is missing and builds. Nothing comes from anywhere but Debian's packages.

# install_missing FILE...: installs the packages listed in the files that are not installed yet.
install_missing() {
    local missing=() package
    while read -r package; do
        dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
    done < <(grep -hv '^#' "$@")
    [ ${#missing[@]} -eq 0 ] && return
    if ! command -v apt-get >/dev/null; then
        echo "These Debian packages are needed, and there is no apt-get to install them: ${missing[*]}" >&2
        exit 1
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "Run as root, or install sudo; these packages are missing: ${missing[*]}" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    echo "Installing Debian packages: ${missing[*]}"
    # A fresh system has no package lists, and then even a known package cannot be found.
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build PRESET [TARGET...]: configures when needed and builds; quiet unless it takes long or fails.
build() {
    local preset=$1
    shift
    local log
    log=$(mktemp)
    if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1; then
        cat "$log" >&2
        exit 1
    fi
    rm -f "$log"
    local folder=$preset
    [ "$preset" = ci ] && folder=release  # the same folder: what ./play built is not built again
    if (cd "$root" && ninja -C "build/$folder" -n "$@" 2>/dev/null) | grep -q 'no work to do'; then return; fi
    echo "Building ($preset) ..." >&2
    (cd "$root" && NINJA_STATUS='[%f/%t, %es] ' cmake --build --preset "$preset" ${1:+--target "$@"}) >&2
}
