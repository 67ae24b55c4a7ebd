#!/usr/bin/env python3
"""v3d.py -- estimates what a frame costs on the GPU of a Raspberry Pi, from logs of Mesa.

  v3d.py programs PI4.LOG PI5.LOG     prints the table of all programs for programs.tsv
  v3d.py check PROGRAMS.TSV NEW.TSV   fails if a program of the new table spills or has more instructions than before
  v3d.py frame PI4.LOG|PI5.LOG JOBS.LOG QUADS.LOG --gpu pi4|pi5 [--fans N] [--pois N] [--limit MS]
                                      prints the milliseconds of the last frame in QUADS.LOG, and fails if they exceed
                                      the limit, or if the early depth test is off in a job of the frame that has a
                                      depth buffer

A log is the standard error of tests/render/shot --steps with gl_trace.so, whose first comment explains its lines.
PI4.LOG and PI5.LOG come from the driver v3d with V3D_DEBUG=precompile,shaderdb,fs,vs, and contain the compiled
programs. JOBS.LOG comes from v3d too, and contains the jobs of the frame. QUADS.LOG comes from softpipe, and contains the 2x2 pixel quads that each draw
call shades.

The model. A QPU is four lanes wide and executes one instruction for a lane in each clock cycle. A fragment costs
its instructions, or its texture lookups where those take longer: a slice does one bilinear lookup of 32 bits in a
clock cycle. A vertex costs the instructions of the coordinate shader, and those of the vertex shader as often as
the tiles that it lies on are drawn (REDRAWN). Stalls add STALLS, every job its start and its tiles' memory traffic.
Not modelled: the rates of the rasterizer and the binner, and the cache of the second level. The milliseconds are
estimates with an error of about 25 %. tests/v3d/README.md names the measurement that calibrated the lookups."""
import argparse
import collections
import re
import sys

GPUS = {
    # QPUs, slices, clock in MHz, memory traffic for tiles in bytes a nanosecond
    'pi4': (8, 2, 500, 4.0),
    'pi5': (16, 4, 960, 8.0),
}
# How often the vertex shader computes a vertex after the coordinate shader did. Half of a closed body is culled by
# then, and a vertex on the edge of a tile is computed again for each tile.
REDRAWN = {'body': 0.65, 'fin': 1.2, 'other': 1.0}
STALLS = 1.0 / 0.85
JOB_MS = 0.1

Code = collections.namedtuple('Code', 'instructions threads spills lookups loop each')


class Programs:
    """The names and the hashes of a log's programs."""

    def __init__(self):
        self.names, self.hashes = {}, {}

    def read(self, line):
        found = re.match(r'PROGRAM (\d+) (\w+) (.+)', line)
        if found:
            self.names[found[1]], self.hashes[found[1]] = found[3], found[2]
        return bool(found)


def read_codes(path):
    """Returns the programs of a log, and the most expensive variant of each program's shaders."""
    programs, codes, jumps, lookups = Programs(), {}, [], 0
    for line in open(path, errors='replace'):
        if programs.read(line):
            continue
        if line.endswith('QPU:\n'):
            jumps, lookups = [], 0
        if ' tmus' in line:
            lookups += 1
        jump = re.search(r'\bb\S*\s+(-?\d+), r:unif', line) if ', r:unif' in line else None
        if jump:
            jumps.append(int(jump[1]) // 8)
        if not line.startswith('SHADER-DB'):
            continue
        found = re.match(r'SHADER-DB-GLSL(\d+) - MESA_SHADER_(\w+) shader: (\d+) inst, (\d+) threads, (\d+) loops, '
                         r'\d+ uniforms, \d+ max-temps, (\d+):(\d+) spills:fills, \d+ sfu-stalls, (\d+) inst-and-stalls',
                         line)
        if not found:
            continue
        program, stage = found[1], found[2]
        _, threads, loops, spills, fills, cost = (int(value) for value in found.groups()[2:])
        # The driver unrolls the loop of shade_at() and jumps behind the rest of it after the last shade.
        ahead = sorted((jump for jump in jumps if jump > 25), reverse=True)
        loop, each = (ahead[0], ahead[0] - ahead[1]) if loops and len(ahead) > 2 else (0, 0)
        code = Code(cost, threads, spills + fills, lookups, loop, each)
        old = codes.setdefault(program, {}).get(stage)
        if not old or code.instructions > old.instructions:
            codes[program][stage] = code
    return programs, codes


STAGES = ('FRAGMENT', 'VERTEX', 'VERTEX_BIN')
COLUMNS = ['hash', 'program'] + [f'{gpu} {what}' for gpu in GPUS
                                 for what in ('fragment', 'vertex', 'binning', 'threads', 'spills', 'lookups')]


def rows_of(logs):
    """Returns one row for each program: the hash of its text, and its figures for each GPU."""
    rows = {}
    for log in logs:
        programs, codes = read_codes(log)
        for program, stages in codes.items():
            if program not in programs.names:
                continue
            got = [stages.get(stage) for stage in STAGES]
            figures = [code.instructions if code else 0 for code in got]
            figures += [min(code.threads for code in got if code), sum(code.spills for code in got if code),
                        got[0].lookups if got[0] else 0]
            rows.setdefault(programs.names[program], [programs.hashes[program]]).extend(figures)
    return rows


def read_table(path):
    lines = [line.rstrip('\n').split('\t') for line in open(path) if not line.startswith('#')]
    return {row[1]: [row[0], *map(int, row[2:])] for row in lines[1:]}


def check(table, rows):
    """Returns one line for each program that costs more than the table allows."""
    faults = []
    for name, row in rows.items():
        if name not in table:
            faults.append(f'{name}: is not in the table')
            continue
        for column, most, now in zip(COLUMNS[2:], table[name][1:], row[1:]):
            if column.endswith('spills') and now > 0:
                faults.append(f'{name}: {now} spills ({column.split()[0]})')
            elif column.split()[1] in ('fragment', 'vertex', 'binning', 'lookups') and now > most:
                faults.append(f'{name}: {now} {column}, the table allows {most}')
    return faults + [f'{name}: is in the table but was not compiled' for name in table if name not in rows]


def last_frame(path):
    """Returns the programs and the draws of the last frame: (step, program, target, instances, vertices, quads)."""
    programs, frame, draws, pending = Programs(), [], [], None
    for line in open(path, errors='replace'):
        if programs.read(line):
            continue
        word = line.split()
        if line.startswith('DRAW '):
            pending = word[1:]
        elif line.startswith('QUADS ') and pending:
            draws.append([None, pending[0], f'{word[1]}x{word[2]}', int(pending[3]), int(pending[4]), int(word[3])])
            pending = None
        elif line.startswith('STEP '):
            for draw in draws:
                draw[0] = draw[0] or word[1]
            if word[1] == 'prepare':
                draws = []
            elif word[1] == 'ui':
                frame, draws = draws, []
    return programs, frame


def instructions(code, count):
    """Returns the instructions of a shader if `count` shades lie over the water."""
    return code.instructions - code.loop + code.each * count if code.loop else code.instructions


Job = collections.namedtuple('Job', 'width height draws clear parts early_z')
CLEAR_DEPTH = 1  # PIPE_CLEAR_DEPTH of Mesa.
EARLY_Z_OFF = 3  # V3D_EZ_DISABLED of Mesa's v3d_context.h. The driver never leaves this state before the end of a job.


def read_jobs(path):
    """Returns the jobs of one frame. The driver submits a job when its result is needed, so the jobs of a frame lie
    between the same step of two frames."""
    frame, jobs = [], []
    for line in open(path, errors='replace'):
        if line.startswith('JOB '):
            word = line.split()
            value = dict(zip(word[3::2], word[4::2]))
            parts = bin(int(value['load'], 16)).count('1') + bin(int(value['store'], 16)).count('1')
            if int(word[2]) > 1:
                jobs.append(Job(int(word[1]), int(word[2]), int(value['draws']), int(value['clear'], 16), parts,
                                int(value['ez'])))
        elif line.startswith('STEP light'):
            frame, jobs = jobs, []
    return frame


def job_ms(job, bandwidth):
    """Returns the fixed cost of a job and of the memory traffic of its tiles."""
    return JOB_MS + job.width * job.height * 4 * job.parts / bandwidth * 1e-6


def frame(args):
    qpus, slices, mhz, bandwidth = GPUS[args.gpu]
    lanes, texels = qpus * 4 * mhz * 1e3, slices * mhz * 1e3
    compiled, codes = read_codes(args.code)
    by_name = {compiled.names[program]: stages for program, stages in codes.items() if program in compiled.names}
    none = Code(0, 0, 0, 0, 0, 0)
    programs, draws = last_frame(args.quads)
    steps, costs, quads_of = collections.Counter(), collections.Counter(), collections.Counter()
    for step, program, _, instances, vertices, quads in draws:
        name = programs.names[program]
        fragment, vertex, binning = (by_name[name].get(stage, none) for stage in STAGES)
        kind = {'fish fin': 'fin', 'fish body': 'body', 'near fish body': 'body', 'sunk fish body': 'body', 'snouts': 'body'}.get(name, 'other')
        is_fish = kind != 'other'
        lookups = fragment.lookups + (1 if name == 'mirror' else 0)  # Slopes are 64 bits a texel.
        shading = quads * 4 * instructions(fragment, args.fans) / lanes
        reading = quads * 4 * lookups / texels
        shades = args.pois if is_fish else args.fans
        moving = vertices * instances * (instructions(binning, 0) +
                                         REDRAWN[kind] * instructions(vertex, shades)) / lanes
        ms = max(shading, reading) + moving
        for table, key in ((steps, step), (costs, name)):
            table[key] += ms
            quads_of[key] += quads
    raw = sum(steps.values())
    jobs = read_jobs(args.jobs)
    total = raw * STALLS + sum(job_ms(job, bandwidth) for job in jobs)
    for step, ms in steps.items():
        print(f'  {step:8} {ms:6.2f} ms, {quads_of[step]:9,} quads')
    for name, ms in costs.most_common():
        print(f'    {name:20} {ms:6.2f} ms, {quads_of[name]:9,} quads')
    faults = []
    for job in jobs:
        size = f'{job.width}x{job.height}'
        has_depth = job.clear & CLEAR_DEPTH
        early_z = 'no depth' if not has_depth else 'early Z off' if job.early_z == EARLY_Z_OFF else 'early Z'
        print(f'  job {size:9} {job_ms(job, bandwidth):5.2f} ms, {job.draws:3} draws, {early_z}')
        if early_z == 'early Z off':
            faults.append(f'{args.jobs}: early Z is off in the job of {size} pixels')
    if round(total, 1) > args.limit:
        faults.append(f'{args.quads}: {total:.1f} ms a frame on {args.gpu}, at most {args.limit:g} ms are allowed')
    limit = f' of {args.limit:g}' if args.limit < float('inf') else ''
    print(f'{args.gpu}: {total:5.1f}{limit} ms a frame ({raw:.1f} ms of shading, {1e3 / total:.0f} a second, {len(draws)} draws)')
    fail_with(faults)


def fail_with(faults):
    for fault in faults:
        print(f'v3d: {fault}', file=sys.stderr)
    sys.exit(1 if faults else 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest='command', required=True)
    part = commands.add_parser('programs')
    part.add_argument('logs', nargs=2)
    part = commands.add_parser('check')
    part.add_argument('table')
    part.add_argument('new')
    part = commands.add_parser('frame')
    part.add_argument('code')
    part.add_argument('jobs')
    part.add_argument('quads')
    part.add_argument('--gpu', choices=GPUS, default='pi4')
    part.add_argument('--fans', type=int, default=0)
    part.add_argument('--pois', type=int, default=1)
    part.add_argument('--limit', type=float, default=float('inf'))
    args = parser.parse_args()
    if args.command == 'programs':
        print('\t'.join(COLUMNS))
        for name, row in rows_of(args.logs).items():
            print('\t'.join(map(str, [row[0], name, *row[1:]])))
    elif args.command == 'check':
        fail_with(check(read_table(args.table), read_table(args.new)))
    else:
        frame(args)


if __name__ == '__main__':
    main()
