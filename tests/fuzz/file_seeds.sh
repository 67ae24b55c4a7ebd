#!/bin/bash
# file_seeds.sh FOLDER -- makes what the fuzz targets file_* begin with; the program beside FOLDER writes it.
set -eu
mkdir -p "$1"/{replay,graph,conf,usb,tail,entries}
exec "$1/../file_seeds" "$1"
