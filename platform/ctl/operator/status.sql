-- status.sql -- the SQL texts of status.c, which read the JSON status report of a running kiosk.
-- The format of this file is described in assets/bake/sql.awk.

-- The time of the report, whether the store is healthy, and the headline.
--- status_head
SELECT json_extract(?1, '$.written_ms'), json_extract(?1, '$.store.well'),
printf('kingyo %s, start %d, open for %d h %02d min: %s', json_extract(?1, '$.version'),
 json_extract(?1, '$.boot'), json_extract(?1, '$.up_s') / 3600,
 json_extract(?1, '$.up_s') / 60 % 60, json_extract(?1, '$.phase'))

-- The name and the text of each line below the headline.
--- status_lines
SELECT 'credits', printf('%d paid, %d of service, %d units towards the next',
 json_extract(?1, '$.credits.paid'), json_extract(?1, '$.credits.service'),
 json_extract(?1, '$.credits.units')) UNION ALL
SELECT 'tickets', printf('%d owed, %d dispensed', json_extract(?1, '$.tickets.owed'),
 json_extract(?1, '$.tickets.dispensed')) UNION ALL
SELECT 'ledger', printf('%s; %d entries, %d not on disk yet',
 iif(json_extract(?1, '$.store.well'), 'well', 'NOT WELL'),
 json_extract(?1, '$.store.entry_id'), json_extract(?1, '$.store.waiting')) UNION ALL
SELECT 'machine', printf('data %s; backup %s; %s MiB free; heat %s; watchdog %s%s',
 coalesce(json_extract(?1, '$.machine.data'), '?'),
 coalesce(json_extract(?1, '$.machine.backup_min') || ' min old', 'none'),
 coalesce(json_extract(?1, '$.machine.free_mib'), '?'),
 coalesce(json_extract(?1, '$.machine.heat_margin_c') || ' degrees below slowing down',
  'not measured'), coalesce(json_extract(?1, '$.machine.watchdog'), '?'),
 iif(json_extract(?1, '$.machine.clock_day') IS NULL, '; CLOCK NOT SET',
  iif(json_extract(?1, '$.machine.clock_went_back'), '; CLOCK WENT BACK', ''))) UNION ALL
SELECT 'files', printf('%d refused; %d databases set aside and not seen; %d scores without
their replay', json_extract(?1, '$.files.refused'), json_extract(?1, '$.files.set_aside'),
 json_extract(?1, '$.files.replays_missed')) UNION ALL
SELECT 'panics', printf('%d; left out because of them: %s',
 json_extract(?1, '$.panics.count'),
 coalesce(json_extract(?1, '$.panics.left_out'), 'nothing')) UNION ALL
SELECT 'frames', printf('%d, median %.1f ms, p99 %.1f ms; %d ticks dropped',
 json_extract(?1, '$.frames.count'), json_extract(?1, '$.frames.median_ms'),
 json_extract(?1, '$.frames.p99_ms'), json_extract(?1, '$.ticks.dropped')) UNION ALL
SELECT 'faults', coalesce((SELECT group_concat(key || ' ' || value, ', ')
 FROM json_each(?1, '$.faults') WHERE value > 0), 'none') UNION ALL
SELECT json_extract(value, '$.part'), json_extract(value, '$.text')
 FROM json_each(?1, '$.devices')
