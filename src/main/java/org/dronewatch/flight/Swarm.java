package org.dronewatch.flight;

import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Several drones of one kind that fly in formation: each flies the leader's path, displaced by a constant vector. The
 * formation is oriented by the leader's heading at time 0 and does not turn with it. A leader that follows the terrain
 * follows the ground below itself, not the ground below the others.
 *
 * @param count number of drones, including the leader, 1 to 1000
 * @param spacing distance between neighbours, above 0 and at most 10,000 m
 * @param formation arrangement of the drones
 */
public record Swarm(
        @In(value = Quantity.NUMBER, from = 1, to = 1000) int count,
        @In(value = Quantity.LENGTH, above = 0, to = 10_000) double spacing,
        Formation formation) {

    /** An arrangement of the drones of a swarm beside, behind or above one another. */
    public enum Formation {
        /** Side by side, the leader in the middle. */
        LINE {
            @Override
            Position offset(int number, int count) {
                return new Position(sideways(number), 0, 0);
            }
        },
        /** In single file, the leader in front. */
        COLUMN {
            @Override
            Position offset(int number, int count) {
                return new Position(0, -number, 0);
            }
        },
        /** A V: two lines that extend behind the leader, at a right angle to each other. */
        WEDGE {
            @Override
            Position offset(int number, int count) {
                int side = sideways(number);
                return new Position(side, -Math.abs(side), 0).times(Math.sqrt(0.5));
            }
        },
        /** In rows and columns, as square as possible, the leader in the middle of the first row. */
        GRID {
            @Override
            Position offset(int number, int count) {
                int columns = (int) Math.ceil(Math.sqrt(count));
                return new Position(sideways(number % columns), -(number / columns), 0);
            }
        },
        /** Stacked vertically, the leader lowest. */
        STACK {
            @Override
            Position offset(int number, int count) {
                return new Position(0, 0, number);
            }
        };

        /** A drone's offset: to the right of the leader, ahead of it and above it, in spacings. */
        abstract Position offset(int number, int count);

        /** The offset to the side in spacings, alternately to the right and to the left. */
        private static int sideways(int number) {
            int steps = (number + 1) / 2;
            return number % 2 == 0 ? -steps : steps;
        }
    }

    /** Checks the limits. */
    public Swarm {
        Limits.check(Swarm.class, count, spacing, formation);
    }

    /** A swarm side by side with 10 m between neighbours. */
    @Defaults("count")
    public static Swarm of(int count) {
        return new Swarm(count, 10.0, Formation.LINE);
    }

    /** The offset of each drone, the leader first: to the right of the leader, ahead of it and above it, m. */
    public List<Position> offsets() {
        return IntStream.range(0, count)
                .mapToObj(number -> formation.offset(number, count).times(spacing))
                .toList();
    }
}
