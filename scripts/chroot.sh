# Clean releases of Debian in folders of the cache, for the scripts beside it; sourced after common.sh, not run.

chroots=$cache/chroots

# The archive that apt uses here, without that of security updates.
debian_archive() {
    list() {
        apt-get indextargets --format '$(LABEL)|$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages' |
            sed -n 's/^Debian|main|//p' | sort -u | head -n 1
    }
    [ -n "$(list)" ] || as_root apt-get -qq update
    list
}

# Runs a command inside of a release: without what the environment here says, and with /proc where that is allowed.
inside() { # RELEASE COMMAND...
    local folder=$chroots/$1 with_proc=()
    shift
    ! as_root unshare --mount --pid --fork true 2>/dev/null ||
        with_proc=(unshare --mount --pid --fork "--mount-proc=$folder/proc")
    as_root "${with_proc[@]}" chroot "$folder" /usr/bin/env -i HOME=/root LC_ALL=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"
}

# Installs packages there; what comes before the names goes to apt.
install_inside() { # RELEASE PACKAGES...
    local release=$1
    shift
    inside "$release" apt-get -qq update
    inside "$release" apt-get -qq install -y --no-install-recommends "$@"
    inside "$release" apt-get clean
}

# Makes a release with packages in it, once. More suites of the archive, as experimental, are separated by commas.
make_chroot() { # NAME SUITE MORE_SUITES PACKAGES...
    local name=$1 suite=$2 more=$3
    local complete=$chroots/$name/.complete
    shift 3
    [ "$(cat "$complete" 2>/dev/null)" = "$*" ] && return
    [ -e "$complete" ] || make_base "$name" "$suite" "$more"
    say "installing packages in $chroots/$name"
    if [ $# -gt 0 ]; then
        install_inside "$name" "$@" >>"$chroots/$name.log" 2>&1 ||
            { tail -n 20 "$chroots/$name.log"; fail "apt failed"; }
    fi
    echo "$*" | as_root tee "$complete" >/dev/null
}

make_base() { # NAME SUITE MORE_SUITES
    local name=$1 suite=$2 archive one
    archive=$(debian_archive)
    [ -n "$archive" ] || fail "apt names no archive of Debian"
    need_packages debootstrap
    say "fetching Debian's $suite into $chroots/$name (once)"
    mkdir -p "$chroots"
    as_root rm -rf "$chroots/$name"
    as_root debootstrap --variant=minbase "$suite" "$chroots/$name" "$archive" >"$chroots/$name.log" 2>&1 ||
        { tail -n 20 "$chroots/$name.log"; fail "debootstrap failed"; }
    echo 'Acquire::Check-Valid-Until "false";' |
        as_root tee "$chroots/$name/etc/apt/apt.conf.d/90archive" >/dev/null
    for one in ${3//,/ }; do
        echo "deb $archive $one main" | as_root tee -a "$chroots/$name/etc/apt/sources.list" >/dev/null
    done
    as_root touch "$chroots/$name/.complete"
}

# Puts the files of the repository, as they are now, into the folder of that name there.
copy_inside() { # RELEASE FOLDER
    as_root rm -rf "$chroots/$1$2"
    as_root mkdir -p "$chroots/$1$2"
    (cd "$root" && git ls-files -co --exclude-standard -z | xargs -0 ls -d 2>/dev/null | tar c -T -) |
        as_root tar x --no-same-owner -C "$chroots/$1$2"
}
