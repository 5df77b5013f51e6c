package org.dronewatch.run.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Ground;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Flat ground at 0 with a solid house of 20 x 20 x 10 m, and a roof on posts, 50 m to the east. */
class PathAdviceTest {
    private static final int[] OUTWARDS = {
        0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5
    };
    private static final World SITE = World.of(World.merge(List.of(
            TriangleMesh.of(
                    new float[] {-500, -500, 0, 500, -500, 0, 500, 500, 0, -500, 500, 0}, new int[] {0, 1, 2, 0, 2, 3}),
            box(-10, 10, 0, 10),
            box(40, 60, 6, 7))));

    private static TriangleMesh box(float west, float east, float bottom, float top) {
        float[] corners = new float[24];
        for (int i = 0; i < 8; i++) {
            corners[3 * i] = (i & 1) == 0 ? west : east;
            corners[3 * i + 1] = (i & 2) == 0 ? -10 : 10;
            corners[3 * i + 2] = (i & 4) == 0 ? bottom : top;
        }
        return TriangleMesh.of(corners, OUTWARDS);
    }

    private static List<String> on(Position from, Position to) {
        List<String> lines = new ArrayList<>();
        new PathAdvice("guest", SITE, SITE.newGround(), 40.0)
                .giveTo(new Approach(from, to).create(10.0, 2.5, Ground.NONE), lines::add);
        return lines;
    }

    /** From 100 m in the west at 7 m: the wall is 90 m away, and the roof 3 m above. */
    @Test
    void aFlightThroughAHouseIsNamedOnce() {
        assertThat(on(new Position(-100, 0, 7), new Position(100, 0, 7)))
                .singleElement()
                .asString()
                .matches(
                        "drone 'guest' flies below the ground or through a solid building: first at (9[.]0|9[.]2) s, at"
                                + " \\(-(10[.]0|9[.]\\d|8[.]\\d), 0[.]0, 7[.]0\\) m, and up to 3[.]0 m below the surface above it");
    }

    /** A dive that ends 4 m below the ground. */
    @Test
    void aFlightIntoTheGroundIsNamedWithItsDepth() {
        assertThat(on(new Position(0, 300, 20), new Position(0, 200, -4)))
                .singleElement()
                .asString()
                .contains("flies below the ground")
                .endsWith("up to 4.0 m below the surface above it");
    }

    @Test
    void whatIsBelowARoofOrOnTheGroundIsNotInside() {
        assertThat(on(new Position(30, 0, 3), new Position(100, 0, 3))).isEmpty();
        assertThat(on(new Position(-100, 0, 12), new Position(100, 0, 12))).isEmpty();
        assertThat(on(new Position(0, 200, 30), new Position(0, 100, 0))).isEmpty();
        // Beyond the rim, where nothing is known.
        assertThat(on(new Position(0, 600, -30), new Position(0, 700, -30))).isEmpty();
        List<String> lines = new ArrayList<>();
        new PathAdvice("parked", SITE, SITE.newGround(), 40.0)
                .giveTo(Hover.at(new Position(100, 0, 0)).create(10.0, 2.5, Ground.NONE), lines::add);
        assertThat(lines).isEmpty();
    }
}
