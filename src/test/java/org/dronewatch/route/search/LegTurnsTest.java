package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LegTurnsTest {
    /** From any direction, the drone can turn all the way round, to both sides, and a leg fits every turn it makes. */
    @ParameterizedTest
    @CsvSource({"8, 1.5", "16, 0.4", "16, 3.4", "32, 2.0", "48, 0.2", "48, 2.25", "48, 7.0"})
    void everyTurnHasRoomAndTurnsLeadAllTheWayRound(int count, double radius) {
        PlanDirections directions = PlanDirections.of(count);
        LegTurns turns = new LegTurns(directions, radius);
        for (int to = 0; to < count; to++) {
            assertThat(isBefore(turns, to, to)).isTrue();
            assertThat(isBefore(turns, Math.floorMod(to + 1, count), to)).isTrue();
            assertThat(isBefore(turns, Math.floorMod(to - 1, count), to)).isTrue();
            for (int from = 0; from < count; from++) {
                double between = Math.abs(directions.heading(to) - directions.heading(from));
                double angle = Math.min(between, 2.0 * Math.PI - between);
                double room = 2.0 * radius * Math.tan(0.5 * angle);
                double shorter = Math.min(length(directions, turns, from), length(directions, turns, to));
                assertThat(isBefore(turns, from, to))
                        .as("from %d to %d", from, to)
                        .isEqualTo(room <= shorter + 1e-9);
            }
        }
    }

    private static double length(PlanDirections directions, LegTurns turns, int direction) {
        return turns.repeats(direction) * Math.hypot(directions.east(direction), directions.north(direction));
    }

    private static boolean isBefore(LegTurns turns, int from, int to) {
        return (turns.before(to) >> from & 1L) == 1L;
    }
}
