package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.Walls;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a radar sees of ground that ends, or drops away, in a range cell or before it, against closed forms. */
class VisibleGroundEdgesTest {
    private static final double FAR = 20_000;

    /** Of elevations in cells that would fill more than a radian if nothing hid them: some thousandths, rad. */
    private static final double PRECISION = 3e-3;

    private static final Position RADAR = new Position(0, 0, 0);

    /** A level sheet between two limits to the east and two to the north. */
    private static TriangleMesh sheet(double west, double east, double south, double north, double height) {
        float w = (float) west;
        float e = (float) east;
        float s = (float) south;
        float n = (float) north;
        float z = (float) height;
        return TriangleMesh.of(new float[] {w, s, z, e, s, z, e, n, z, w, n, z}, new int[] {0, 1, 2, 0, 2, 3});
    }

    private static TriangleMesh level(double south, double north, double height) {
        return sheet(-FAR, FAR, south, north, height);
    }

    private static VisibleGround ground(TriangleMesh... parts) {
        return new VisibleGround(World.of(World.merge(List.of(parts))), RADAR);
    }

    /** A cell that reaches beyond the last of the ground shows it up to there: 1000 m below, 20 km away. */
    @Test
    void whereTheGroundEndsInACellItIsSeenUpToItsEdge() {
        VisibleGround ground = ground(level(-FAR, FAR, -1000));
        double near = -Math.asin(1000.0 / 19_990);
        double edge = -Math.atan(1000.0 / 20_000);
        assertThat(ground.look(0, 19_990, 20_100)).isTrue();
        assertThat(ground.low()).isCloseTo(near, within(0.01 * (edge - near)));
        assertThat(ground.high()).isCloseTo(edge, within(0.01 * (edge - near)));
    }

    /**
     * A quarry begins 224 m away, 100 m below the radar: within 450 m only its brink is seen, and nothing of its
     * bottom, 440 m below the radar.
     */
    @ParameterizedTest
    @ValueSource(doubles = {150, 221})
    void aQuarryIsSeenUpToItsBrink(double near) {
        VisibleGround ground = ground(level(-FAR, 200, -100), level(200, FAR, -440));
        assertThat(ground.look(0, near, 450)).isTrue();
        assertThat(ground.low()).isCloseTo(-Math.asin(100.0 / near), within(PRECISION));
        assertThat(ground.high()).isCloseTo(-Math.atan(100.0 / 200), within(PRECISION));
        assertThat(ground.look(0, 445, 450)).as("within the quarry").isFalse();
    }

    /**
     * Of a wall behind a quarry all is seen that rises over its brink, 30 m below the radar; no matter whether the
     * ground before it goes on to the foot of the radar, or begins at a cliff 80 m away, over a valley that is deeper
     * than the cell is far.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-FAR, 80})
    void overTheBrinkOfAQuarryTheFarSideIsSeen(double begin) {
        VisibleGround ground = ground(
                level(-FAR, begin, -1000),
                Walls.wall(begin, -1000, -30),
                level(begin, 200, -30),
                level(200, FAR, -440),
                Walls.wall(600, -440, 20));
        assertThat(ground.look(0, 450, 610)).isTrue();
        assertThat(ground.low()).isCloseTo(-Math.atan(30.0 / 200), within(PRECISION));
        assertThat(ground.high()).isCloseTo(Math.atan(20.0 / 600), within(PRECISION));
    }

    /**
     * Roofs at a height of 50 m end where cells at other bearings do, at as many metres to the east and to the north:
     * to the other sides, and twice as far. None of them blurs the cell of a tenth of a milliradian.
     */
    @Test
    void whatStandsElsewhereDoesNotBlurACell() {
        double azimuth = Math.PI / 6;
        double x = 1000 * Math.sin(azimuth);
        double y = 1000 * Math.cos(azimuth);
        VisibleGround ground = ground(
                level(-FAR, FAR, -10),
                sheet(-FAR, -x, -FAR, FAR, 50),
                sheet(1000 / Math.sin(azimuth), FAR, -FAR, FAR, 50),
                sheet(-FAR, FAR, -FAR, -y, 50),
                sheet(-FAR, FAR, 1000 / Math.cos(azimuth), FAR, 50));
        double low = -Math.asin(10.0 / 995);
        double high = -Math.asin(10.0 / 1005);
        assertThat(ground.look(azimuth, 995, 1005)).isTrue();
        assertThat(ground.low()).isCloseTo(low, within(5e-3 * (high - low)));
        assertThat(ground.high()).isCloseTo(high, within(5e-3 * (high - low)));
    }

    /** What counts is the height of the radar above the ground, not above the sea. */
    @ParameterizedTest
    @CsvSource({"400", "-400", "50", "3000"})
    void theGroundMayLieAtAnyHeight(double sea) {
        VisibleGround ground = new VisibleGround(World.of(level(-FAR, FAR, sea)), new Position(0, 0, sea + 10));
        double low = -Math.asin(10 / 992.5);
        double high = -Math.asin(10 / 1007.5);
        assertThat(ground.look(0.5, 992.5, 1007.5)).isTrue();
        assertThat(ground.low()).isCloseTo(low, within(5e-3 * (high - low)));
        assertThat(ground.high()).isCloseTo(high, within(5e-3 * (high - low)));
    }

    /** A cell that begins at the radar begins straight below it. */
    @Test
    void aCellThatBeginsAtTheRadarBeginsBelowIt() {
        VisibleGround high = ground(level(-FAR, FAR, -100));
        assertThat(high.look(0, 0, 110)).isTrue();
        assertThat(high.low()).isEqualTo(-0.5 * Math.PI);
        assertThat(high.high()).isCloseTo(-Math.asin(100.0 / 110), within(2e-3));
    }
}
