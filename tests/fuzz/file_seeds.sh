#!/bin/bash
# file_seeds.sh FOLDER -- makes the seeds of the fuzz targets file_*. The program beside FOLDER
# writes them.
set -eu
mkdir -p "$1"/{replay,graph,conf,usb,tail,entries}
exec "$1/../file_seeds" "$1"
