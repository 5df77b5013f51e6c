package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.terrain.KnownGround;
import org.dronewatch.terrain.TerrainGround;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Sensors of users' own, which only look: the cause comes from their outline and from what stands before the drone. */
class AssessorTest {
    private static final Position HERE = new Position(0, 0, 0);

    /** Detects what is nearer than 100 m, and looks north, 60 degrees wide, from 10 to 500 m. */
    private record Guard(Position position, boolean hasOutline, List<Double> probabilities)
            implements SensorSettings<Sensor>, Outlined {
        @Override
        public Guard withPosition(Position other) {
            return new Guard(other, hasOutline, probabilities);
        }

        @Override
        public Outline outline() {
            return new Outline.Sector(0, 0, Math.PI / 3, Math.PI / 3, 10, 500);
        }

        @Override
        public <C> Optional<C> as(Class<C> capability) {
            return capability == Outlined.class && !hasOutline ? Optional.empty() : SensorSettings.super.as(capability);
        }

        @Override
        public double rate() {
            return 1.0;
        }

        @Override
        public String kind() {
            return "guard";
        }

        @Override
        public Sensor create() {
            return (world, drones, look) ->
                    drones.stream().flatMap(drone -> seen(drone, look)).toList();
        }

        private Stream<Observation> seen(Drone drone, Look look) {
            double distance = drone.distance(HERE);
            Observation one =
                    new Observation(look.id(kind()), drone.id(), distance, new Reading(100.0 / distance, 1.0, ""));
            return probabilities.isEmpty()
                    ? Stream.of(one)
                    : probabilities.stream().map(p -> one.withFigures(Map.of(Observation.PROBABILITY, p)));
        }
    }

    /** The same, but it searches, so that chance decides once per encounter. */
    private record Searcher(Guard guard) implements SensorSettings<Sensor> {
        @Override
        public Position position() {
            return guard.position();
        }

        @Override
        public Searcher withPosition(Position other) {
            return new Searcher(guard.withPosition(other));
        }

        @Override
        public double rate() {
            return guard.rate();
        }

        @Override
        public String kind() {
            return "searcher";
        }

        @Override
        public Chance chance() {
            return Chance.PER_ENCOUNTER;
        }

        @Override
        public Sensor create() {
            return guard.create();
        }
    }

    private static Guard guard(boolean hasOutline) {
        return new Guard(HERE, hasOutline, List.of());
    }

    private static Cause cause(World world, double east, double north) {
        return assess(guard(true), world, cube(new Position(east, north, 0))).cause();
    }

    @Test
    void aLookGivesTheMargin() {
        Assessment one = assess(guard(true), open(), cube(new Position(0, 50, 0)));

        assertThat(one.cause()).isEqualTo(Cause.DETECTED);
        assertThat(one.probability()).isEqualTo(1.0);
        assertThat(one.margin()).isEqualTo(1.0);
        assertThat(one.marginDb()).isEqualTo(10.0 * Math.log10(2.0));
    }

    /** The look itself detects the drone each time here: its threshold may have been drawn. */
    @Test
    void aProbabilityThatALookStatesDecides() {
        Drone drone = cube(new Position(0, 50, 0));
        for (double probability : new double[] {0.25, 0.5, 0.75}) {
            Guard guard = new Guard(HERE, true, List.of(probability));
            Assessment one = assess(guard, open(), drone);

            assertThat(one.probability()).isEqualTo(probability);
            assertThat(one.margin()).isEqualTo(probability - 0.5);
            assertThat(one.cause()).isEqualTo(probability < 0.5 ? Cause.TOO_WEAK : Cause.DETECTED);
        }
    }

    /** A look may contain a drone more than once, and its draw may detect it by a less likely observation alone. */
    @Test
    void theLikeliestObservationCounts() {
        Guard guard = new Guard(HERE, true, List.of(0.1, 0.9, 0.3));
        Assessment one = assess(guard, open(), cube(new Position(0, 50, 0)));

        assertThat(one.probability()).isEqualTo(0.9);
        assertThat(one.cause()).isEqualTo(Cause.DETECTED);
    }

    /** What a search measures is no probability, with which the threshold of an encounter could be compared. */
    @Test
    void anEncounterIsDecidedByItsProbability() {
        Searcher searcher = new Searcher(new Guard(HERE, true, List.of(0.01)));
        Assessment one = new Assessor("searcher", searcher, open())
                .assess(cube(new Position(0, 50, 0)), Optional.empty(), new SplittableRandom(1));

        assertThat(one.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(one.margin()).isEqualTo(0.01 - 0.5);
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void theOutlineAndTheLineOfSightGiveTheCause(ModelRole role) {
        World world = behind(wall(150, -99, 99), role);

        assertThat(cause(open(), 0, 200)).isEqualTo(Cause.TOO_WEAK);
        assertThat(cause(world, 0, 200)).isEqualTo(Cause.hiddenBy(role));
        assertThat(cause(world, 0, 501)).isEqualTo(Cause.OUT_OF_RANGE);
        assertThat(cause(world, 300, 200)).isEqualTo(Cause.OUT_OF_VIEW);
    }

    /** Ground that is known up to 400 m to either side, and up to 180 m to the north. */
    private static World knownToTheNorthUpTo180(World world) {
        float[] corners = {-400, -400, -50, 400, -400, -50, 400, 180, -50, -400, 180, -50};
        TriangleMesh ground = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        return world.withKnownGround(new KnownGround(new TerrainGround(ground)));
    }

    /** Beyond the known ground, each of the others could hold as well: it is unknown all the same. */
    @Test
    void whatIsUnknownCountsBeforeAllOtherCauses() {
        World wall = behind(wall(150, -99, 99), ModelRole.BUILDING);
        World open = knownToTheNorthUpTo180(open());
        assertThat(cause(open(), 0, 200)).isEqualTo(Cause.TOO_WEAK);
        assertThat(cause(open, 0, 200)).isEqualTo(Cause.UNKNOWN);
        assertThat(cause(wall, 0, 200)).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(cause(knownToTheNorthUpTo180(wall), 0, 200)).isEqualTo(Cause.UNKNOWN);
        assertThat(cause(open(), 0, 501)).isEqualTo(Cause.OUT_OF_RANGE);
        assertThat(cause(open, 0, 501)).isEqualTo(Cause.UNKNOWN);
        assertThat(cause(open(), 420, 100)).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(cause(open, 420, 100)).isEqualTo(Cause.UNKNOWN);
        assertThat(cause(open, 0, 170)).as("as long as it is known").isEqualTo(Cause.TOO_WEAK);
    }

    /** What a look would detect if nothing stood there is unknown, too, with the signal of that look. */
    @Test
    void whatIsUnknownCountsBeforeADetection() {
        Drone near = cube(new Position(0, 50, 0));
        float[] corners = {-9, -9, -50, 9, -9, -50, 9, 9, -50, -9, 9, -50};
        TriangleMesh ground = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        World world = open().withKnownGround(new KnownGround(new TerrainGround(ground)));
        Assessor assessor = new Assessor("guard", guard(true), world);
        Assessment one = assessor.assess(near, Optional.empty(), new SplittableRandom(1));

        assertThat(one.cause()).isEqualTo(Cause.UNKNOWN);
        assertThat(one.margin()).isEqualTo(1.0);
        assertThat(assessor.explainMiss(near, Optional.empty()).cause()).isEqualTo(Cause.UNKNOWN);
        assertThat(Cause.values()[0]).isEqualTo(Cause.UNKNOWN);
    }

    @Test
    void withoutAnOutlineAllThatIsMissedIsTooWeak() {
        World world = behind(wall(150, -99, 99), ModelRole.TERRAIN);

        assertThat(assess(guard(false), world, cube(new Position(0, 200, 0))).cause())
                .isEqualTo(Cause.TOO_WEAK);
    }

    @Test
    void whatContradictsItselfIsRefused() {
        Signal enough = Signal.certain(2.0, "dB", 1.0);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Assessment(enough, Explanation.of(Cause.TOO_WEAK)))
                .withMessageContaining("TOO_WEAK");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Explanation.of(Cause.HIDDEN_BY_TERRAIN))
                .withMessageContaining("obstacle");
        Obstacle hill = new Obstacle(new SiteModel("hill.obj", ModelRole.TERRAIN), "grass");
        assertThat(Explanation.hiddenBy(hill).cause()).isEqualTo(Cause.HIDDEN_BY_TERRAIN);
    }
}
