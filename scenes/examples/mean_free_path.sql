-- The mean free path of the balls of a gas, from its events and its series:
--
--     carom run gas --events events.csv --series series.csv
--     duckdb < mean_free_path.sql
--
-- Each impact of balls ends a path of two; balls fly at sqrt(pi k T / (2 m)) on average, m = 1.
with gas as (
  select any_value(balls) as balls, max(time) as time,
         sqrt(pi() * avg(temperature) / 2) as mean_speed
  from 'series.csv'
), impacts as (
  select count(*) as count from 'events.csv' where kind = 'ball'
)
select mean_speed, 2 * impacts.count / balls / time as collisions_per_second,
       balls * time * mean_speed / (2 * impacts.count) as mean_free_path
from gas, impacts;
